// SPDX-License-Identifier: MIT
#include "importer/tool/cost/skinned_part.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sinew::cost {

PosedSkin::PosedSkin(const Skin& skin, std::span<const Affined> model) {
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    palette.push_back(
        joint_matrix_from(affine_cast<float>(model[skin.joints[i]] * affine_cast<double>(skin.inverse_bind[i]))));
    exact.push_back(affine_cast<double>(affine_from(palette.back())));
  }
}

std::optional<SkinnedPart> skinned_part(const Subject& subject) {
  const Scene& scene = subject.scene;
  SkinnedPart part;
  part.skeleton = &scene.skeleton;
  for (const MeshInstance& instance : scene.instances) {
    if (instance.skin == kNone) continue;
    for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
      if (!primitive.influences.empty() &&
          (part.primitive == nullptr || primitive.vertex_count() > part.vertex_count())) {
        part.primitive = &primitive;
        part.skin = &scene.skins[instance.skin];
      }
  }
  if (part.primitive == nullptr) return std::nullopt;
  for (const ModelPose& model : subject.compared_poses()) part.poses.emplace_back(*part.skin, model);
  std::uint32_t most = 0;
  for (const InfluenceGroup& group : part.primitive->influences.groups) most = std::max(most, group.influence_count);
  part.description = fmt::format("{} vertices with up to {} influences, {}", part.vertex_count(), most,
                                 subject.animation() == nullptr
                                     ? std::string("with every joint turned by 30 degrees, for want of a clip")
                                     : fmt::format("in {} poses of {}", part.poses.size(), subject.clip_name()));
  return part;
}

double angle_deg(const glm::vec3& direction, const Vec3<double>& unit) {
  const Vec3<double> u = normalised_or(Vec3<double>(direction), unit);
  return 57.29577951308232 * 2.0 * std::atan2(safe_length(u - unit), safe_length(u + unit));
}

}  // namespace sinew::cost
