// SPDX-License-Identifier: MIT

#include <algorithm>
#include <array>

#include "runtime/animation/joint_tracks.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/retarget/dense_times.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/leg_pose.h"

namespace sinew {
namespace {

/// Collects the keys of the joints that hold_feet writes.
class HeldKeys {
 public:
  explicit HeldKeys(const FeetMap& feet) : hips_(feet.hips) {
    for (const LegPair& leg : feet.legs)
      legs_.push_back({{leg.target.joints[leg.target.upper].joint, leg.target.joints[leg.target.lower].joint,
                        leg.target.joints[leg.target.foot].joint},
                       {}});
  }

  void add(float time_s, std::span<const Transformd> plain, std::span<const Transformd> held) {
    for (Leg& leg : legs_)
      for (std::size_t i = 0; i < 3; ++i) {
        const Quat<double>& rotation = held[leg.joints[i]].rotation;
        leg.turns = leg.turns || rotation_angle_between(rotation, plain[leg.joints[i]].rotation) > kRounding;
        leg.tracks[i].times_s.push_back(time_s);
        leg.tracks[i].values.push_back(quat_cast<float>(rotation));
      }
    if (hips_ == kNone) return;
    const Vec3<double>& place = held[hips_].translation;
    hips_move_ = hips_move_ || safe_length(place - plain[hips_].translation) > kRounding * safe_length(place);
    hips_track_.times_s.push_back(time_s);
    hips_track_.values.emplace_back(place);
  }

  void write(Animation& animation) {
    for (Leg& leg : legs_)
      for (std::size_t i = 0; i < 3 && leg.turns; ++i)
        last_bone_of(animation, leg.joints[i]).rotation = std::move(leg.tracks[i]);
    if (hips_move_) last_bone_of(animation, hips_).translation = std::move(hips_track_);
  }

 private:
  static constexpr double kRounding = 1e-6;

  struct Leg {
    std::array<std::uint32_t, 3> joints;
    std::array<QuatTrack, 3> tracks;
    bool turns = false;  ///< a rotation of the leg differs from the retargeted pose
  };

  std::vector<Leg> legs_;
  std::uint32_t hips_;
  Vec3Track hips_track_;
  bool hips_move_ = false;
};

/// One ground contact of an ankle or of toes. It measures how far they move away from where they came down.
class Contact {
 public:
  /// in   off  place of the ankle or toes minus the source's scaled path
  void add(bool is_on, const Vec3<double>& off, FootSlide& slide) {
    if (!is_on) return end(slide);
    if (!is_on_) first_ = off;
    is_on_ = true;
    farthest_ = std::max(farthest_, safe_length(off - first_));
  }
  void end(FootSlide& slide) {
    if (!is_on_) return;
    slide.largest = std::max(slide.largest, farthest_);
    slide.mean += (farthest_ - slide.mean) / static_cast<double>(++slide.contacts);
    is_on_ = false;
    farthest_ = 0.0;
  }

 private:
  bool is_on_ = false;
  Vec3<double> first_{0.0};
  double farthest_ = 0.0;
};

}  // namespace

void hold_feet(const FeetMap& feet, const Animation& animation, const Skeleton& source, const Skeleton& target,
               Animation& retargeted) {
  const double ground = find_ground(feet, animation, source);
  HeldKeys keys(feet);
  TruthPose from, to;
  for (const double time_s : dense_times(animation)) {
    evaluate_truth(animation, source, time_s, from);
    evaluate_truth(retargeted, target, time_s, to);
    std::vector<Transformd> held = to.local;
    hold_feet(feet, ground, from.local, held);
    keys.add(static_cast<float>(time_s), to.local, held);
  }
  keys.write(retargeted);
}

FootSlide measure_foot_slide(const FeetMap& feet, const Animation& animation, const Skeleton& source,
                             const Animation& retargeted, const Skeleton& target) {
  const double ground = find_ground(feet, animation, source);
  FootSlide slide;
  std::vector<Contact> ankles(feet.legs.size()), toes(feet.legs.size());
  TruthPose from, to;
  for (const double time_s : dense_times(animation)) {
    evaluate_truth(animation, source, time_s, from);
    evaluate_truth(retargeted, target, time_s, to);
    for (std::size_t l = 0; l < feet.legs.size(); ++l) {
      const LegPair& leg = feet.legs[l];
      const auto at = leg_pose<double>(leg.source, [&](std::uint32_t j) { return from.local[j]; });
      const auto found = leg_pose<double>(leg.target, [&](std::uint32_t j) { return to.local[j]; });
      const FootContact<double> contact = foot_contact(leg, at, ground);
      const bool is_low = contact.held == 1.0;
      // A flat foot stands on ankle and toes.
      ankles[l].add(is_low && contact.toes < 0.55, found.foot.place - contact.foot * feet.ratio, slide);
      toes[l].add(is_low && contact.toes > 0.45, found.toes.place - contact.ball * feet.ratio, slide);
    }
  }
  for (Contact& contact : ankles) contact.end(slide);
  for (Contact& contact : toes) contact.end(slide);
  return slide;
}

}  // namespace sinew
