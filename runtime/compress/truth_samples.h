// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/compress/virtual_vertices.h"

namespace sinew {

/// The eight corners of a box in model space, all x, then all y, then all z.
using BoxCorners = std::array<std::array<double, 8>, 3>;

/// eq   M c for each corner c of corners_of(box); the same bits as transform_point
BoxCorners corners_in_model(const Affined& model, const Aabb& box) noexcept;

/// What forms of a clip are compared with at one time.
struct TruthSample {
  std::vector<BoxCorners> corners;  ///< [J] of the virtual vertices, model space
  std::vector<double> weights;      ///< values of the animation's weight tracks, one track after the other
  std::vector<double> stretch;      ///< [instances] longest image of a unit length of mesh space in model space; 0 for
                                    ///< instances whose weights no track moves. Empty without weight tracks
};

/// The authoring form of a clip at the times at which its compiled forms are measured. A search for the smallest clip
/// measures many forms at the same times, so samples are evaluated once and kept, up to a number of bytes. Those of
/// later times are evaluated whenever they are looked at.
/// The scene, the animation, the vertices and the times must outlive it. Any number of threads may read it.
class TruthSamples {
 public:
  static constexpr std::size_t kMostKeptBytes = std::size_t{64} << 20;

  /// in   times_s  rising
  /// cost O(kept times x J), allocates
  TruthSamples(const Scene& scene, const Animation& truth, const VirtualVertices& vertices,
               std::span<const double> times_s, std::size_t kept_bytes = kMostKeptBytes);

  /// Memory for samples that are not kept; one for each thread.
  struct Scratch {
    TruthPose pose;
    TruthSample sample;
    std::uint64_t evaluated = 0;  ///< how many samples were not kept
  };

  /// The sample of a time. It is valid until the next call with this scratch.
  const TruthSample& at(std::size_t time, Scratch& scratch) const;

  const Scene& scene() const noexcept { return scene_; }
  const Animation& truth() const noexcept { return truth_; }
  const VirtualVertices& vertices() const noexcept { return vertices_; }
  std::span<const double> times_s() const noexcept { return times_s_; }
  std::size_t kept_count() const noexcept { return kept_.size(); }  ///< of the first times

 private:
  void evaluate(double time_s, TruthPose& pose, TruthSample& out) const;

  const Scene& scene_;
  const Animation& truth_;
  const VirtualVertices& vertices_;
  std::span<const double> times_s_;
  std::vector<TruthSample> kept_;
};

}  // namespace sinew
