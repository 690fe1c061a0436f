// SPDX-License-Identifier: MIT
#include "importer/ambient/bake_key_poses.h"

namespace sinew {

std::vector<double> key_pose_times(double duration_s, std::uint32_t count) {
  if (count < 2 || !(duration_s > 0.0)) return {0.0};
  std::vector<double> times;
  for (std::uint32_t i = 0; i < count; ++i) times.push_back(duration_s * i / (count - 1.0));
  return times;
}

void bake_key_pose(const Scene& scene, const FrameResult& pose, std::size_t index, const AccessOptions& options,
                   VertexAccess& access) {
  const MeshAccess baked = bake_mesh_access(scene, pose, options);
  access.values.resize(scene.meshes.size());
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    access.values[m].resize(scene.meshes[m].primitives.size());
    for (std::size_t p = 0; p < access.values[m].size(); ++p) {
      std::vector<float>& all = access.values[m][p];
      const std::vector<float>& more = baked[m][p];
      if (all.empty() && more.empty()) continue;
      const std::size_t vertices = scene.meshes[m].primitives[p].vertex_count();
      all.resize(index * vertices, 1.0f);
      all.insert(all.end(), more.begin(), more.end());
      all.resize((index + 1) * vertices, 1.0f);
    }
  }
}

}  // namespace sinew
