// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

#include "runtime/deform/vertex_streams.h"
#include "runtime/model/scene.h"
#include "tests/support/fixed_random.h"

namespace sinew::scenes {

/// Model-space matrices of all joints at rest, computed in double.
inline std::vector<Affine> rest_matrices(const Skeleton& skeleton) {
  std::vector<Affined> model(skeleton.joint_count());
  std::vector<Affine> out;
  for (std::size_t j = 0; j < model.size(); ++j) {
    const Transform& t = skeleton.rest[j];
    const Transformd local{Vec3<double>(t.translation), Quat<double>(t.rotation), Vec3<double>(t.scale)};
    model[j] = affine_from_transform(local);
    if (skeleton.parents[j] != kNone) model[j] = model[skeleton.parents[j]] * model[j];
    out.push_back(affine_cast<float>(model[j]));
  }
  return out;
}

/// A skin over all joints, whose rest pose is the bind pose. Rest rotations must be identities and scales one.
inline Skin skin_of_all_joints(const Skeleton& skeleton) {
  Skin skin;
  const auto rest = rest_matrices(skeleton);
  for (std::uint32_t j = 0; j < rest.size(); ++j) {
    skin.joints.push_back(j);
    skin.inverse_bind.push_back(affine_from(Mat3<float>(1), -translation_of(rest[j])));
  }
  return skin;
}

/// Order of the vertices: grouped by their joints, as the importer writes them, or alternating between joints.
enum class VertexOrder : unsigned char { by_joints, in_turns };

/// `vertex_count` vertices around the joints, each moved by `influence_count` neighbouring joints.
inline Primitive skinned_surface(const Skeleton& skeleton, std::uint32_t vertex_count, std::uint32_t influence_count,
                                 VertexOrder order = VertexOrder::by_joints) {
  test::FixedRandom random(vertex_count + influence_count);
  const auto rest = rest_matrices(skeleton);
  const auto joints = static_cast<std::uint32_t>(rest.size());
  Primitive p;
  p.influences.groups = {{0, vertex_count, influence_count, 0}};
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const auto center = order == VertexOrder::in_turns
                            ? v % joints
                            : static_cast<std::uint32_t>(std::uint64_t{v} * joints / vertex_count);
    const glm::vec3 n = random.direction();
    p.positions.push_back(translation_of(rest[center]) + n * 0.05f);
    p.normals.push_back(n);
    p.tangents.emplace_back(random.direction(), v % 2 ? 1.0f : -1.0f);
    std::vector<float> weights;
    for (std::uint32_t i = 0; i < influence_count; ++i) weights.push_back(static_cast<float>(random.in(0.1, 1)));
    std::sort(weights.rbegin(), weights.rend());
    float sum = 0;
    for (const float w : weights) sum += w;
    for (std::uint32_t i = 0; i < influence_count; ++i) {
      p.influences.joints.push_back(static_cast<std::uint16_t>((center + i) % joints));
      p.influences.weights.push_back(weights[i] / sum);
    }
  }
  for (std::uint32_t v = 0; v + 2 < vertex_count; v += 3) p.indices.insert(p.indices.end(), {v, v + 1, v + 2});
  for (const glm::vec3& position : p.positions) p.bounds.add(position);
  return p;
}

/// A whole scene: the skeleton swings, a surface of `vertex_count` vertices follows it.
inline Scene swinging_surface(Skeleton skeleton, Animation animation, std::uint32_t vertex_count,
                              std::uint32_t influence_count) {
  Scene scene;
  scene.skins.push_back(skin_of_all_joints(skeleton));
  scene.meshes.push_back({"surface", {skinned_surface(skeleton, vertex_count, influence_count)}, {}, {}});
  scene.instances.push_back({0, 0, 0, {}});
  scene.skeleton = std::move(skeleton);
  scene.animations.push_back(std::move(animation));
  finish_scene(scene);
  return scene;
}

}  // namespace sinew::scenes
