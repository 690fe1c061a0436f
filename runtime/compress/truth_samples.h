// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/base/api.h"
#include "runtime/compress/virtual_vertices.h"

namespace sinew {

/// The eight corners of a box in model space, all x, then all y, then all z.
using BoxCorners = std::array<std::array<double, 8>, 3>;

/// Computes the corners of a joint's box in model space.
/// eq   M c for each corner c of corners_of(box); the same bits as transform_point
SINEW_API BoxCorners corners_in_model(const Affined& model, const Aabb& box) noexcept;

/// The exact values of an animation at one time, which samples of compiled clips are compared with.
struct TruthSample {
  std::vector<BoxCorners> corners;  ///< [J] boxes of virtual vertices, in model space
  std::vector<double> weights;      ///< values of the weight tracks, one track after the other.
  /// [instances] Longest image in model space of a unit length of mesh space; 0 for instances without weight tracks.
  /// Empty if the animation has no weight tracks.
  std::vector<double> stretch;
};

/// The authoring form of a clip, sampled at the times at which its compiled forms are measured. A search measures many
/// forms at the same times, so the first samples are kept, up to a number of bytes. Later samples are evaluated on
/// every use. The scene, the animation, the vertices and the times must outlive it. Any number of threads may read it.
class SINEW_API TruthSamples {
 public:
  static constexpr std::size_t kMaxKeptBytes = std::size_t{64} << 20;

  /// in   times_s  rising
  /// cost O(kept times x J), allocates
  TruthSamples(const Scene& scene, const Animation& truth, const VirtualVertices& vertices,
               std::span<const double> times_s, std::size_t kept_bytes = kMaxKeptBytes);

  /// Memory for samples that are not kept. Each thread needs its own.
  struct Scratch {
    TruthPose pose;
    TruthSample sample;
    std::uint64_t evaluated = 0;  ///< number of samples that were evaluated because they were not kept
  };

  /// The sample at times_s()[time], valid until the next call with this scratch.
  const TruthSample& at(std::size_t time, Scratch& scratch) const;

  const Scene& scene() const noexcept { return scene_; }
  const Animation& truth() const noexcept { return truth_; }
  const VirtualVertices& vertices() const noexcept { return vertices_; }
  std::span<const double> times_s() const noexcept { return times_s_; }
  /// The samples of the first kept_count() times are kept
  std::size_t kept_count() const noexcept { return kept_.size(); }

 private:
  void fill(double time_s, const TruthPose& pose, TruthSample& out) const;

  const Scene& scene_;
  const Animation& truth_;
  const VirtualVertices& vertices_;
  std::span<const double> times_s_;
  std::vector<TruthSample> kept_;
};

}  // namespace sinew
