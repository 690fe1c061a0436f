// SPDX-License-Identifier: MIT
#include "runtime/c/retarget.h"

#include <cmath>
#include <utility>

#include "runtime/c/handles.h"
#include "runtime/c/pose_span.h"
#include "runtime/c/read_reference.h"
#include "runtime/c/unbound.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/map_scenes.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_properties.h"
#include "runtime/retarget/share_twist.h"

using namespace sinew;

namespace {

static_assert(static_cast<int>(LimbDirections::of_source) == SINEW_LIMBS_OF_SOURCE &&
              static_cast<int>(LimbDirections::of_rest) == SINEW_LIMBS_OF_REST &&
              static_cast<int>(TranslationRule::hips_by_height) == SINEW_HIPS_BY_HEIGHT &&
              static_cast<int>(TranslationRule::by_length) == SINEW_BY_LENGTH &&
              static_cast<int>(TranslationRule::keep) == SINEW_KEEP);

sinew_error read_pairs(const sinew_skeleton_map_options& given, const Skeleton& source, const Skeleton& target,
                       SkeletonMapOptions& options) {
  if (given.pairs == nullptr && given.pair_count > 0) return SINEW_NULL_ARGUMENT;
  std::vector<bool> is_mapped(target.joint_count());
  for (std::size_t i = 0; i < given.pair_count; ++i) {
    const auto [from, to] = given.pairs[i];
    if (from >= source.joint_count() || to >= target.joint_count()) return SINEW_INDEX_OUT_OF_RANGE;
    if (is_mapped[to]) return SINEW_UNSUPPORTED;
    is_mapped[to] = true;
    options.pairs.push_back({from, to});
  }
  return SINEW_OK;
}

sinew_error read_chains(const sinew_skeleton_map_options& given, const Skeleton& target, SkeletonMapOptions& options) {
  if (given.chains == nullptr && given.chain_count > 0) return SINEW_NULL_ARGUMENT;
  std::vector<bool> has_rule(target.joint_count());
  for (std::size_t i = 0; i < given.chain_count; ++i) {
    const auto [joint, rule] = given.chains[i];
    if (joint >= target.joint_count()) return SINEW_INDEX_OUT_OF_RANGE;
    if (has_rule[joint] || rule > SINEW_KEEP) return SINEW_UNSUPPORTED;
    has_rule[joint] = true;
    options.chains.push_back({joint, static_cast<TranslationRule>(rule)});
  }
  return SINEW_OK;
}

sinew_error read_options(const sinew_skeleton_map_options& given, const Skeleton& source, const Skeleton& target,
                         SkeletonMapOptions& options) {
  if (given.limbs > SINEW_LIMBS_OF_REST || given.translations > SINEW_KEEP) return SINEW_UNSUPPORTED;
  options.limbs = static_cast<LimbDirections>(given.limbs);
  options.translations = static_cast<TranslationRule>(given.translations);
  if (const sinew_error error = read_pairs(given, source, target, options); error != SINEW_OK) return error;
  return read_chains(given, target, options);
}

/// A clip of the source on the target.
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
  if (source == nullptr || target == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  const Skeleton &from = source->scene.skeleton, &to = target->scene.skeleton;
  return c::guarded([&] {
    sinew_skeleton_map_options given{};
    SkeletonMapOptions own;
    std::vector<Transform> source_pose, target_pose;
    sinew_error error = c::read_struct(options, given);
    if (error == SINEW_OK) error = read_options(given, from, to, own);
    if (error == SINEW_OK)
      error = c::read_reference(given.source_reference, given.source_pose, source->scene, source_pose);
    if (error == SINEW_OK)
      error = c::read_reference(given.target_reference, given.target_pose, target->scene, target_pose);
    if (error != SINEW_OK) return error;
    own.source_reference = source_pose;
    own.target_reference = target_pose;
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
  if (map == nullptr) return SINEW_NULL_ARGUMENT;
  const SkeletonMap& own = map->map;
  return c::write_struct({.struct_size = 0,
                          .pairs = map->pairs.data(),
                          .pair_count = map->pairs.size(),
                          .unmapped_source = {own.unmapped_source.data(), own.unmapped_source.size()},
                          .unmapped_target = {own.unmapped_target.data(), own.unmapped_target.size()},
                          .height_ratio = own.height_ratio,
                          .leg_count = static_cast<std::uint32_t>(map->feet.legs.size()),
                          .twist_count = static_cast<std::uint32_t>(map->twists.joints.size()),
                          .source_reference = map->source_reference,
                          .target_reference = map->target_reference,
                          .bone_angle_rad = own.bone_angle_rad},
                         out);
}

sinew_error sinew_retarget_pose(const sinew_skeleton_map* map, const sinew_pose* pose, const sinew_pose* scratch,
                                const sinew_pose* retargeted) {
  if (map == nullptr) return SINEW_NULL_ARGUMENT;
  RetargetPoseJob job{.tables = &map->tables, .pose = {}, .retargeted = {}};
  sinew_error error = c::read_pose(pose, job.pose);
  if (error == SINEW_OK) error = c::read_pose(scratch, job.scratch);
  if (error == SINEW_OK) error = c::read_pose(retargeted, job.retargeted);
  if (error == SINEW_OK) error = c::run_job(job);
  return error == SINEW_OK ? c::run_job(ShareTwistJob{&map->twists, job.retargeted}) : error;
}

sinew_error sinew_hold_feet(const sinew_skeleton_map* map, float ground, const sinew_pose* pose,
                            const sinew_pose* held) {
  if (map == nullptr) return SINEW_NULL_ARGUMENT;
  if (!std::isfinite(ground)) return SINEW_NOT_FINITE;
  HoldFeetJob job{.feet = &map->feet, .ground = ground, .pose = {}, .held = {}};
  const std::size_t source_joints = map->source->scene.skeleton.joint_count(),
                    target_joints = map->target->scene.skeleton.joint_count();
  sinew_error error = c::read_pose(pose, source_joints, job.pose);
  if (error == SINEW_OK) error = c::read_pose(held, target_joints, job.held);
  return error == SINEW_OK ? c::run_job(job) : error;
}

sinew_error sinew_find_ground(const sinew_skeleton_map* map, std::uint32_t clip, float* ground) {
  if (map == nullptr || ground == nullptr) return SINEW_NULL_ARGUMENT;
  const Scene& source = map->source->scene;
  if (clip >= source.animations.size()) return SINEW_INDEX_OUT_OF_RANGE;
  return c::guarded([&] {
    *ground = static_cast<float>(find_ground(map->feet, source.animations[clip], source.skeleton));
    return SINEW_OK;
  });
}

sinew_error sinew_library_add_retargeted(sinew_library* library, const sinew_skeleton_map* map, std::uint32_t clip,
                                         std::uint32_t hold_feet, std::uint32_t if_unbound, sinew_messages** unbound) {
  if (library == nullptr || map == nullptr) return SINEW_NULL_ARGUMENT;
  if (clip >= map->source->scene.animations.size()) return SINEW_INDEX_OUT_OF_RANGE;
  return c::guarded([&] {
    const Clip made[] = {retargeted(*map, clip, hold_feet != 0)};
    return c::add_to(*library, made, clip_channels(map->target->scene), if_unbound, unbound);
  });
}
