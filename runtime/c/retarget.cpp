// SPDX-License-Identifier: MIT
#include "runtime/c/retarget.h"

#include <array>
#include <cmath>
#include <utility>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/enums.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/glue/read_reference.h"
#include "runtime/c/handles.h"
#include "runtime/c/unbound.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/map_scenes.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_properties.h"
#include "runtime/retarget/share_twist.h"

using namespace sinew;

/// A pair of joints, source and target.
template <>
inline constexpr bool sinew::c::kSameBytes<sinew_joint_pair, std::array<std::uint32_t, 2>> = true;

namespace {

constexpr auto kChain = c::fields(c::field<&sinew_chain_rule::joint, &ChainRule::joint>(),
                                  c::field<&sinew_chain_rule::rule, &ChainRule::rule>());
constexpr auto kMapOptions =
    c::fields(c::field<&sinew_skeleton_map_options::limbs, &SkeletonMapOptions::limbs>(),
              c::field<&sinew_skeleton_map_options::translations, &SkeletonMapOptions::translations>(),
              c::span_field<&sinew_skeleton_map_options::pairs, &sinew_skeleton_map_options::pair_count,
                            &SkeletonMapOptions::pairs>(),
              c::copied_field<&sinew_skeleton_map_options::chains, &sinew_skeleton_map_options::chain_count,
                              &SkeletonMapOptions::chains>(kChain));

/// Retargets a clip of the source to the target.
Clip retargeted(const sinew_skeleton_map& own, std::uint32_t clip, bool hold) {
  const Scene &source = own.source->scene, &target = own.target->scene;
  const Animation& animation = source.animations[clip];
  Animation made = retarget_animation(animation, own.map, source.skeleton, target.skeleton);
  share_twist(own.twists, made);
  if (hold) hold_feet(own.feet, animation, source.skeleton, target.skeleton, made);
  retarget_weights(own.weights, animation, source, target, made);
  retarget_properties(animation, own.map, source, target, made);
  std::erase_if(made.properties, [&](const PropertyTrack& track) { return !target.properties.find(track.target); });
  return compile_clip(made, target.skeleton, rest_weights_of(target), target.first_weight, target.properties);
}

}  // namespace

sinew_error sinew_skeleton_map_create(const sinew_scene* source, const sinew_scene* target,
                                      const sinew_skeleton_map_options* options, sinew_skeleton_map** out) {
  return c::call(c::given(source, target, out), [&] {
    const Skeleton &from = source->scene.skeleton, &to = target->scene.skeleton;
    sinew_skeleton_map_options given{};
    if (const sinew_error error = c::read_struct(options, given)) return error;
    SkeletonMapOptions own;
    if (const sinew_error error = kMapOptions.read(given, own).error) return error;
    std::vector<Transform> source_pose, target_pose;
    if (const sinew_error error =
            c::read_reference(given.source_reference, given.source_pose, source->scene, source_pose))
      return error;
    if (const sinew_error error =
            c::read_reference(given.target_reference, given.target_pose, target->scene, target_pose))
      return error;
    own.source_reference = source_pose;
    own.target_reference = target_pose;
    if (const ErrorCode error = check(own, from, to); error != ErrorCode::ok) return c::error_from(error);
    SkeletonMap map = make_skeleton_map(source->scene, target->scene, own);
    RetargetTables tables = make_retarget_tables(map, from, to);
    TwistMap twists = make_twist_map(map, to);
    FeetMap feet = make_feet_map(map, from, to);
    std::vector<sinew_joint_pair> pairs;
    for (const MappedJoint& joint : map.joints) pairs.push_back({joint.source, joint.target});
    WeightMap weights = make_weight_map(source->scene, target->scene);
    const std::uint32_t source_told = c::told_reference(map.source_reference, given.source_reference),
                        target_told = c::told_reference(map.target_reference, given.target_reference);
    *out = new sinew_skeleton_map{
        source,          target,           std::move(map),     std::move(tables), std::move(twists),
        std::move(feet), std::move(pairs), std::move(weights), source_told,       target_told};
    return SINEW_OK;
  });
}

void sinew_skeleton_map_destroy(sinew_skeleton_map* map) { delete map; }

sinew_error sinew_get_skeleton_map(const sinew_skeleton_map* map, sinew_skeleton_map_info* out) {
  return c::call(c::given(map), [&] {
    const SkeletonMap& own = map->map;
    return c::write_struct({.struct_size = 0,
                            .pairs = map->pairs.data(),
                            .pair_count = map->pairs.size(),
                            .unmapped_source = c::to_c(own.unmapped_source),
                            .unmapped_target = c::to_c(own.unmapped_target),
                            .height_ratio = own.height_ratio,
                            .leg_count = c::to_c(map->feet.legs.size()),
                            .twist_count = c::to_c(map->twists.joints.size()),
                            .source_reference = map->source_reference,
                            .target_reference = map->target_reference,
                            .bone_angle_rad = own.bone_angle_rad},
                           out);
  });
}

sinew_error sinew_retarget_pose(const sinew_skeleton_map* map, const sinew_pose* pose, const sinew_pose* scratch,
                                const sinew_pose* retargeted) {
  return c::call(c::given(map), [&] {
    RetargetPoseJob job{.tables = &map->tables, .pose = {}, .retargeted = {}};
    if (const sinew_error error =
            c::read_poses({{pose, job.pose}, {scratch, job.scratch}, {retargeted, job.retargeted}}))
      return error;
    if (const ErrorCode error = run(job); error != ErrorCode::ok) return c::error_from(error);
    return c::error_from(run(ShareTwistJob{&map->twists, job.retargeted}));
  });
}

sinew_error sinew_hold_feet(const sinew_skeleton_map* map, float ground, const sinew_pose* pose,
                            const sinew_pose* held) {
  return c::call(c::given(map), [&] {
    if (!std::isfinite(ground)) return SINEW_NOT_FINITE;
    HoldFeetJob job{.feet = &map->feet, .ground = ground, .pose = {}, .held = {}};
    if (const sinew_error error = c::read_poses({{pose, job.pose}, {held, job.held}})) return error;
    if (job.pose.joint_count != map->source->scene.skeleton.joint_count() ||
        job.held.joint_count != map->target->scene.skeleton.joint_count())
      return SINEW_SIZE_MISMATCH;
    return c::error_from(run(job));
  });
}

sinew_error sinew_find_ground(const sinew_skeleton_map* map, std::uint32_t clip, float* ground) {
  return c::call(c::given(map, ground), [&] {
    const Scene& source = map->source->scene;
    if (clip >= source.animations.size()) return SINEW_INDEX_OUT_OF_RANGE;
    *ground = static_cast<float>(find_ground(map->feet, source.animations[clip], source.skeleton));
    return SINEW_OK;
  });
}

sinew_error sinew_library_add_retargeted(sinew_library* library, const sinew_skeleton_map* map, std::uint32_t clip,
                                         std::uint32_t hold_feet, std::uint32_t if_unbound, sinew_messages** unbound) {
  return c::call(c::given(library, map), [&] {
    if (clip >= map->source->scene.animations.size()) return SINEW_INDEX_OUT_OF_RANGE;
    const Clip made[] = {retargeted(*map, clip, hold_feet != 0)};
    return c::add_to(*library, made, clip_channels(map->target->scene), if_unbound, unbound);
  });
}
