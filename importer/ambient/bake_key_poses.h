// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "importer/ambient/visibility_surfaces.h"
#include "runtime/model/vertex_visibility.h"

namespace sinew {

/// Times of key poses spread evenly over a clip, including both ends.
/// eq   duration * i / (count - 1)
/// out  only the time 0 if count < 2 or the duration is 0
std::vector<double> key_pose_times(double duration_s, std::uint32_t count);

/// Bakes the key poses of a VertexVisibility one after another.
class KeyPoseBaker {
 public:
  /// in   scene, visibility  must outlive this object;   visibility  has its times set and no values yet
  ///      options        for each pose;   progress  receives the finished fraction of all poses
  ///      distance_m     replaces options.distance_m; empty = default_visibility_distance_m() of the first
  KeyPoseBaker(const Scene& scene, const VisibilityOptions& options, std::optional<double> distance_m,
               VertexVisibility& visibility);

  /// Bakes the next pose. A primitive that is hidden in a pose gets visibility 1 there; one that is always hidden gets
  /// no values.
  /// in   pose  with positions
  /// err, cost  as bake_ambient_visibility()
  void add(const FrameResult& pose);

 private:
  const Scene& scene_;
  VisibilityOptions options_;
  std::optional<double> distance_m_;
  VertexVisibility& visibility_;
  std::size_t baked_ = 0;
};

}  // namespace sinew
