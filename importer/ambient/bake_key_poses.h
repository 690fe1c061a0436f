// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "importer/ambient/access_surfaces.h"
#include "runtime/model/vertex_access.h"

namespace sinew {

/// The times of key poses spread evenly over a clip, the first and the last included.
/// eq   duration * i / (count - 1)
/// out  the time 0 alone for one pose, and for a clip that lasts no time
std::vector<double> key_pose_times(double duration_s, std::uint32_t count);

/// Bakes the poses of a VertexAccess, one after another.
class KeyPoseBaker {
 public:
  /// in   scene, access  must outlive this object;   access  with its times, and without values
  ///      options        of each pose;   progress  receives the finished part of all poses
  ///      distance_m     in place of that of the options; nothing = what default_access_distance_m() says of the first
  KeyPoseBaker(const Scene& scene, const AccessOptions& options, std::optional<double> distance_m,
               VertexAccess& access);

  /// Bakes the next pose. A primitive that a pose does not show is open in it, and one that none shows has no values.
  /// in   pose  with positions
  /// err, cost  those of bake_ambient_access()
  void add(const FrameResult& pose);

 private:
  const Scene& scene_;
  AccessOptions options_;
  std::optional<double> distance_m_;
  VertexAccess& access_;
  std::size_t baked_ = 0;
};

}  // namespace sinew
