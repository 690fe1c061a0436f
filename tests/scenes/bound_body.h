// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/inverse.h"
#include "runtime/model/scene.h"
#include "tests/scenes/two_sided.h"

/// Bodies with skins whose nodes rest in another pose than the one in which their meshes were bound.
namespace sinew::scenes {

inline std::vector<Affined> model_matrices(const Skeleton& skeleton, const std::vector<Transform>& local) {
  std::vector<Transformd> exact;
  for (const Transform& t : local) exact.push_back(in_double(t));
  std::vector<Affined> model(local.size());
  model_from_local(skeleton, exact, model);
  return model;
}

/// Adds a skin of these joints, and a mesh at joint `mesh_at` that uses it.
/// in   bind   [J] the pose of the skeleton in which the mesh was bound
///      space  model matrix of the space in which its vertices are
inline void add_skin(Scene& scene, const std::vector<Transform>& bind, const std::vector<std::uint32_t>& joints,
                     const Affined& space = {}, std::uint32_t mesh_at = 0) {
  const std::vector<Affined> model = model_matrices(scene.skeleton, bind);
  Skin skin;
  skin.joints = joints;
  for (const std::uint32_t j : joints) skin.inverse_bind.push_back(affine_cast<float>(*inverse_of(model[j]) * space));
  scene.meshes.emplace_back();
  scene.instances.push_back({mesh_at,
                             static_cast<std::uint32_t>(scene.meshes.size() - 1),
                             static_cast<std::uint32_t>(scene.skins.size()),
                             {}});
  scene.skins.push_back(std::move(skin));
  scene.first_weight.assign(scene.instances.size() + 1, 0);
}

inline std::vector<std::uint32_t> all_joints(const Skeleton& skeleton, std::uint32_t from = 0) {
  std::vector<std::uint32_t> joints;
  for (std::uint32_t j = from; j < skeleton.joint_count(); ++j) joints.push_back(j);
  return joints;
}

/// A frame of a walk: limbs swing by up to half a radian, and the hips move a little.
inline std::vector<Transform> mid_motion(const std::vector<Transform>& bind, std::uint64_t seed = 3) {
  test::FixedRandom random(seed);
  std::vector<Transform> local = bind;
  for (std::size_t j = 0; j < local.size(); ++j)
    local[j].rotation = normalised(random.rotation_by(j == 0 ? 0.2 : 0.5) * local[j].rotation);
  local[0].translation += glm::vec3(0.05f, -0.03f, 0.2f);
  return local;
}

/// A body whose only skin was bound in the symmetric pose of `two_sided`.
inline Scene bound_body(RightSide right, std::uint64_t seed = 1) {
  Scene scene;
  scene.skeleton = two_sided(right, seed).skeleton;
  add_skin(scene, scene.skeleton.rest, all_joints(scene.skeleton));
  return scene;
}

/// The scale and turn of a file in centimetres with z up.
inline Affined centimetres_z_up() {
  const double half = std::sqrt(0.5);
  return affine_from_transform(Transformd{Vec3<double>(0.0), quat_xyzw(-half, 0.0, 0.0, half), Vec3<double>(0.01)});
}

/// The same body in centimetres with z up, below a node that scales and turns it. Joint 0 is that node.
inline Skeleton below_armature(const Skeleton& body) {
  const double half = std::sqrt(0.5);
  std::vector<std::uint32_t> parents = {kNone};
  for (const std::uint32_t parent : body.parents) parents.push_back(parent == kNone ? 0 : parent + 1);
  Skeleton made = breadth_first(parents, std::vector<glm::vec3>(parents.size()));
  made.names[0] = "Armature";
  made.rest[0].rotation = quat_cast<float>(quat_xyzw(-half, 0.0, 0.0, half));
  made.rest[0].scale = glm::vec3(0.01f);
  for (std::uint32_t j = 0; j < body.joint_count(); ++j) {
    made.rest[j + 1] = body.rest[j];
    made.rest[j + 1].translation *= 100.0f;
    made.names[j + 1] = body.names[j];
    if (body.parents[j] != kNone) continue;
    const Quat<double> back = quat_xyzw(half, 0.0, 0.0, half);
    made.rest[j + 1].rotation = quat_cast<float>(back * quat_cast<double>(body.rest[j].rotation));
    made.rest[j + 1].translation = glm::vec3(rotate_vector(back, Vec3<double>(body.rest[j].translation)) * 100.0);
  }
  return made;
}

/// Rotations of all joints, and a path of the first `moving` ones.
inline Animation walk_of(const Skeleton& skeleton, std::uint32_t moving, std::uint64_t seed = 5) {
  test::FixedRandom random(seed);
  Animation animation{"walk", 1.0, {}, {}};
  for (std::uint32_t j = moving; j < skeleton.joint_count(); ++j) {
    if (j == moving + 3) continue;  // one joint rests
    BoneAnimation bone;
    bone.joint = j;
    bone.rotation = {Interpolation::linear, {0.0f, 0.5f, 1.0f}, {}};
    for (int k = 0; k < 3; ++k)
      bone.rotation.values.push_back(normalised(random.rotation_by(0.7) * skeleton.rest[j].rotation));
    if (j == moving)
      bone.translation = {
          Interpolation::linear, {0.0f, 1.0f}, {skeleton.rest[j].translation, skeleton.rest[j].translation * 1.3f}};
    animation.bones.push_back(std::move(bone));
  }
  return animation;
}

}  // namespace sinew::scenes
