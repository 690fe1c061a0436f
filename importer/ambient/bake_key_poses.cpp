// SPDX-License-Identifier: MIT
#include "importer/ambient/bake_key_poses.h"

namespace sinew {

std::vector<double> key_pose_times(double duration_s, std::uint32_t count) {
  if (count < 2 || !(duration_s > 0.0)) return {0.0};
  std::vector<double> times;
  for (std::uint32_t i = 0; i < count; ++i) times.push_back(duration_s * i / (count - 1.0));
  return times;
}

KeyPoseBaker::KeyPoseBaker(const Scene& scene, const VisibilityOptions& options, std::optional<double> distance_m,
                           VertexVisibility& visibility)
    : scene_(scene), options_(options), distance_m_(distance_m), visibility_(visibility) {
  if (!options.progress) return;
  options_.progress = [this, report = options.progress](double part) {
    report((static_cast<double>(baked_) + part) / static_cast<double>(visibility_.times_s.size()));
  };
}

void KeyPoseBaker::add(const FrameResult& pose) {
  if (!distance_m_) distance_m_ = default_visibility_distance_m(scene_, pose);
  options_.distance_m = *distance_m_;
  const MeshVisibility baked = bake_mesh_visibility(scene_, pose, options_);
  visibility_.values.resize(scene_.meshes.size());
  for (std::size_t m = 0; m < scene_.meshes.size(); ++m) {
    visibility_.values[m].resize(scene_.meshes[m].primitives.size());
    for (std::size_t p = 0; p < visibility_.values[m].size(); ++p) {
      std::vector<float>& all = visibility_.values[m][p];
      const std::vector<float>& more = baked[m][p];
      if (all.empty() && more.empty()) continue;
      const std::size_t vertices = scene_.meshes[m].primitives[p].vertex_count();
      all.resize(baked_ * vertices, 1.0f);
      all.insert(all.end(), more.begin(), more.end());
      all.resize((baked_ + 1) * vertices, 1.0f);
    }
  }
  ++baked_;
}

}  // namespace sinew
