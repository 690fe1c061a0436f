// SPDX-License-Identifier: MIT
#include "viewer/app/motion/character_rig.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "importer/graph/graph_files.h"
#include "importer/vrm.h"
#include "importer/vrm_expressions.h"
#include "importer/vrm_springs.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/model/scene.h"

namespace sinew::viewer {
namespace {

Affined rest_matrix(const Skeleton& skeleton, std::uint32_t joint) {
  Affined matrix;
  for (; joint != kNone; joint = skeleton.parents[joint]) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[joint];
    matrix = (fixed == kNone ? affine_from_transform(in_double(skeleton.rest[joint]))
                             : affine_cast<double>(skeleton.fixed_matrices[fixed])) *
             matrix;
  }
  return matrix;
}

/// True if the track's values differ along one of these axes.
bool moves_along(const Vec3Track& track, const RootMotionParts& parts) {
  const auto differs = [&](int axis) {
    return std::any_of(track.values.begin(), track.values.end(),
                       [&](const glm::vec3& value) { return value[axis] != track.values.front()[axis]; });
  };
  return (parts.x && differs(0)) || (parts.y && differs(1)) || (parts.z && differs(2));
}

/// The parts that lie along the ground if the joint's parent stands like this.
RootMotionParts parts_below(const Affined& parent) {
  const Vec3<double> up(parent.row[1].x, parent.row[1].y, parent.row[1].z);
  const Vec3<double> size = glm::abs(up);
  if (size.y >= size.x && size.y >= size.z) return {.turn = up.y > 0.0 ? RootTurn::heading : RootTurn::none};
  if (size.z >= size.x) return {.x = true, .y = true, .z = false, .turn = RootTurn::none};
  return {.x = false, .y = true, .z = true, .turn = RootTurn::none};
}

const BoneAnimation* bone_of(const Animation& animation, std::uint32_t joint) {
  for (const BoneAnimation& bone : animation.bones)
    if (bone.joint == joint) return &bone;
  return nullptr;
}

}  // namespace

RootJoint find_root_joint(const Scene& scene) {
  for (std::uint32_t joint = 0; joint < scene.skeleton.joint_count(); ++joint) {
    const std::uint32_t parent = scene.skeleton.parents[joint];
    const RootJoint root{joint, {}, parent == kNone ? Affined() : rest_matrix(scene.skeleton, parent)};
    const RootMotionParts parts = parts_below(root.parent);
    for (const Animation& animation : scene.animations)
      if (const BoneAnimation* bone = bone_of(animation, joint); bone && moves_along(bone->translation, parts))
        return {joint, parts, root.parent};
  }
  return {};
}

CharacterRig make_rig(const Scene& scene, const VrmCharacter* vrm, std::vector<std::string>& left_out) {
  CharacterRig rig;
  rig.root = find_root_joint(scene);
  if (!vrm) return rig;
  VrmSprings from = spring_setup_of(*vrm, scene.skeleton);
  left_out.insert(left_out.end(), from.left_out.begin(), from.left_out.end());
  auto springs = compile_springs(scene.skeleton, from.setup);
  if (!springs)
    left_out.push_back("its springs cannot be used: " + springs.error().text);
  else if (springs->joint_count() > 0)
    rig.springs = *std::move(springs);
  auto constraints = sort_constraints(scene.skeleton, node_constraints_of(*vrm));
  if (!constraints)
    left_out.push_back("its constraints cannot be used: " + constraints.error().text);
  else if (!constraints->ordered().empty())
    rig.constraints = *std::move(constraints);
  rig.expressions = expressions_of(*vrm, scene);
  return rig;
}

tl::expected<std::shared_ptr<const GraphOnScene>, std::string> read_graph_for(const std::string& file,
                                                                              const Scene& scene, const RootJoint& root,
                                                                              std::vector<GraphSetting> script) {
  auto loaded = load_graph(file, scene, {.root_joint = root.joint, .root_parts = root.parts});
  if (!loaded) return tl::unexpected(loaded.error());
  auto settings = settings_for(loaded->graph, std::move(script));
  if (!settings) return tl::unexpected(settings.error());
  return std::make_shared<const GraphOnScene>(GraphOnScene{*std::move(loaded), *std::move(settings)});
}

}  // namespace sinew::viewer
