// SPDX-License-Identifier: MIT
#include "importer/tool/cost/skin_probe.h"

#include <algorithm>

#include <fmt/format.h>

#include "runtime/math/quaternion.h"

namespace sinew::cost {

SkinProbe::SkinProbe(const Scene& scene, std::size_t most_points) {
  for (const MeshInstance& instance : scene.instances)
    for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
      vertices_of_scene_ += primitive.vertex_count();
  const std::size_t step =
      std::max<std::size_t>(1, (vertices_of_scene_ + most_points - 1) / std::max<std::size_t>(1, most_points));
  for (const MeshInstance& instance : scene.instances) add_instance(scene, instance, step);
  has_vertices_ = point_count() > 0;
  if (!has_vertices_) add_joints(scene.skeleton);
}

void SkinProbe::add_instance(const Scene& scene, const MeshInstance& instance, std::size_t step) {
  for (const Primitive& primitive : scene.meshes[instance.mesh].primitives) {
    if (instance.skin != kNone && !primitive.influences.empty()) {
      add_skinned_vertices(primitive, scene.skins[instance.skin], step);
      continue;
    }
    for (std::size_t v = 0; v < primitive.vertex_count(); v += step)
      add_point({instance.joint, 1.0, Vec3<double>(primitive.positions[v])});
  }
}

void SkinProbe::add_skinned_vertices(const Primitive& primitive, const Skin& skin, std::size_t step) {
  for (const InfluenceGroup& group : primitive.influences.groups)
    for (std::size_t v = 0; v < group.vertex_count; v += step) {
      const Vec3<double> rest(primitive.positions[group.first_vertex + v]);
      for (std::size_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = group.first_influence + v * group.influence_count + i;
        const std::uint16_t entry = primitive.influences.joints[at];
        pulls_.push_back({skin.joints[entry], static_cast<double>(primitive.influences.weights[at]),
                          transform_point(affine_cast<double>(skin.inverse_bind[entry]), rest)});
      }
      first_pull_.push_back(pulls_.size());
    }
}

void SkinProbe::add_joints(const Skeleton& skeleton) {
  const ModelPose model = model_pose(skeleton, rest_pose(skeleton));
  Vec3<double> lower(0.0), upper(0.0);
  for (std::size_t j = 0; j < model.size(); ++j) {
    const Vec3<double> at = translation_of(model[j]);
    lower = j == 0 ? at : glm::min(lower, at);
    upper = j == 0 ? at : glm::max(upper, at);
  }
  const double size = safe_length(upper - lower), shell = size > 0.0 ? 0.05 * size : 0.03;
  for (std::uint32_t j = 0; j < model.size(); ++j)
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      Vec3<double> place(0.0);
      place[axis] = shell;
      add_point({j, 1.0, place});
    }
}

Vec3<double> SkinProbe::point(std::size_t i, std::span<const Affined> model) const {
  Vec3<double> sum(0.0);
  for (std::size_t k = first_pull_[i]; k < first_pull_[i + 1]; ++k)
    sum += pulls_[k].weight * transform_point(model[pulls_[k].joint], pulls_[k].place);
  return sum;
}

double SkinProbe::distance_m(std::span<const Affined> a, std::span<const Affined> b) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < point_count(); ++i) largest = std::max(largest, safe_length(point(i, a) - point(i, b)));
  return largest;
}

std::string SkinProbe::description() const {
  if (!has_vertices_) return "three points around each joint, a twentieth of the skeleton's size away";
  return point_count() == vertices_of_scene_ ? fmt::format("all {} vertices", point_count())
                                             : fmt::format("{} of the {} vertices", point_count(), vertices_of_scene_);
}

}  // namespace sinew::cost
