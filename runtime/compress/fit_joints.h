// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/compress/key_lists.h"
#include "runtime/compress/moving_joints.h"

namespace sinew {

/// Leaves keys out of the tracks of joints, from the roots to the tips. After each track, the error that its joint and
/// all joints below it have accumulated stays within a share of the budget. The shares rise along each path of joints,
/// up to the whole budget at its end. Later tracks may use the part that earlier ones left.
class JointFit {
 public:
  /// The arguments must outlive it.
  /// in   truth, stored   as in fit_keys()
  JointFit(const Skeleton& skeleton, const Animation& truth, const Animation& stored, const VirtualVertices& vertices);

  bool empty() const noexcept { return stages_.empty(); }  ///< no track moves a joint

  /// The keys that each track keeps. Tracks at the rest transform of their joint are left out.
  std::vector<KeptKeys> fit(double budget_m);

  /// Gives tracks that kept many keys in the last fit a larger share, and others a smaller one.
  /// eq   the keys of a track fall with the root of its share s: k = a / sqrt(s). The sum of bytes b k is smallest, for
  ///      shares of one sum, where s is proportional to (b a)^(2/3).
  void share_by_need();

 private:
  /// A track of a moving joint.
  struct Stage {
    std::uint32_t joint = 0;     ///< index of the moving joint
    std::uint32_t property = 0;  ///< index into MovingJoint::bone_of
    KeptKeys kept;
    double weight = 1.0;          ///< share relative to those of other tracks
    double from = 0.0, to = 0.0;  ///< part of the budget that may be used before and after this track
  };
  /// The times of one part of the animation. Long animations are worked on in parts, which bounds the memory.
  struct Part {
    std::vector<double> times_s;
    bool first = false, last = false;
    std::vector<std::vector<Transformd>> local;  ///< [moving joints][times] local transforms of the truth
    std::vector<std::vector<Affined>> model;     ///< [moving joints][times] model matrices of the truth
  };

  void set_shares();
  Part make_part(std::size_t begin, std::size_t end) const;
  void fit_part(const Part& part, double budget_m);
  template <class TrackType, class Property>
  void fit_track(const Part& part, Stage& stage, const TrackType& track, const std::vector<Affined>& parent,
                 double limit_m, Property property, std::vector<Transformd>& local) const;

  const Skeleton& skeleton_;
  const Animation &truth_, &stored_;
  std::vector<MovingJoint> joints_;
  std::vector<Stage> stages_;  ///< in the order of joints, parents first
  std::vector<double> times_s_;
  std::size_t times_per_part_ = 0;
  std::vector<Part> kept_parts_;  ///< the only part of a short animation, else empty
};

}  // namespace sinew
