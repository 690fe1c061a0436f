// SPDX-License-Identifier: MIT
#include "runtime/c/root_motion.h"

#include <algorithm>
#include <cmath>

#include "runtime/animation/joint_tracks.h"
#include "runtime/c/glue/call.h"
#include "runtime/c/glue/enums.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/handles.h"
#include "runtime/clip/decompile_clip.h"
#include "runtime/playback/root_motion.h"

namespace sinew::c {

template <>
inline constexpr bool kSameBytes<sinew_dual_quat, DualQuatd> = true;

}  // namespace sinew::c

namespace {

using namespace sinew;

constexpr auto kParts = c::fields(
    c::field<&sinew_root_parts::x, &RootMotionParts::x>(), c::field<&sinew_root_parts::y, &RootMotionParts::y>(),
    c::field<&sinew_root_parts::z, &RootMotionParts::z>(), c::field<&sinew_root_parts::turn, &RootMotionParts::turn>());

DualQuatd motion_in(const sinew_dual_quat* given) noexcept {
  DualQuatd motion;
  if (given != nullptr) c::copy_bytes(*given, motion);
  return motion;
}

/// A joint of a clip, and the parts of its motion that carry the character.
struct RootOfClip {
  BoneAnimation joined;  // empty unless several entries of the clip animate the joint
  const BoneAnimation* animation = &joined;
  Transform rest;
  RootMotionParts parts;
};

/// Refers to the animation of a joint if there is one entry for it. Joins the tracks of several entries.
void take_tracks(const Animation& clip, std::uint32_t joint, RootOfClip& root) {
  const auto is_own = [&](const BoneAnimation& bone) { return bone.joint == joint; };
  const auto first = std::ranges::find_if(clip.bones, is_own);
  if (first == clip.bones.end()) return;
  if (std::find_if(first + 1, clip.bones.end(), is_own) == clip.bones.end()) {
    root.animation = &*first;
    return;
  }
  const JointTracks tracks = tracks_of_joint(clip, joint);
  if (tracks.translation != nullptr) root.joined.translation = *tracks.translation;
  if (tracks.rotation != nullptr) root.joined.rotation = *tracks.rotation;
}

sinew_error find_root(const sinew_scene* scene, std::uint32_t clip, std::uint32_t joint, const sinew_root_parts* parts,
                      RootOfClip& root) {
  if (const sinew_error error = c::read_fields(parts, kParts, root.parts)) return error;
  const Scene& own = scene->scene;
  if (clip >= own.animations.size() || joint >= own.skeleton.joint_count()) return SINEW_INDEX_OUT_OF_RANGE;
  root.rest = own.skeleton.rest[joint];
  take_tracks(own.animations[clip], joint, root);
  return SINEW_OK;
}

bool all_finite(const PlaybackStep& step) noexcept {
  return std::isfinite(step.duration_s) && std::isfinite(step.from_turns) && std::isfinite(step.from_s) &&
         std::isfinite(step.to_turns) && std::isfinite(step.to_s);
}

sinew_error read_step(const sinew_step& given, PlaybackStep& step) noexcept {
  c::copy_bytes(given, step);
  if (!c::kEnum<PlayMode>.has(static_cast<std::uint32_t>(step.mode))) return SINEW_UNSUPPORTED;
  return all_finite(step) ? SINEW_OK : SINEW_NOT_FINITE;
}

}  // namespace

sinew_dual_quat sinew_dual_quat_identity(void) { return c::to_c(DualQuatd{}); }

sinew_dual_quat sinew_dual_quat_product(const sinew_dual_quat* a, const sinew_dual_quat* b) {
  return c::to_c(normalised(motion_in(a) * motion_in(b)));
}

sinew_dual_quat sinew_dual_quat_inverse(const sinew_dual_quat* motion) {
  return c::to_c(dual_quat_conjugate(motion_in(motion)));
}

sinew_affine sinew_dual_quat_matrix(const sinew_dual_quat* motion) {
  return c::to_c(affine_cast<float>(affine_from_dual_quat(motion_in(motion))));
}

sinew_root_parts sinew_default_root_parts(void) { return c::written<sinew_root_parts>(kParts, RootMotionParts{}); }

sinew_error sinew_root_place(const sinew_scene* scene, std::uint32_t clip, std::uint32_t joint,
                             const sinew_root_parts* parts, double time_s, sinew_dual_quat* out) {
  return c::call(c::given(scene, out), [&] {
    if (!std::isfinite(time_s)) return SINEW_NOT_FINITE;
    RootOfClip root;
    if (const sinew_error error = find_root(scene, clip, joint, parts, root)) return error;
    *out = c::to_c(root_place(*root.animation, root.rest, root.parts, time_s));
    return SINEW_OK;
  });
}

sinew_error sinew_root_motion(const sinew_scene* scene, std::uint32_t clip, std::uint32_t joint,
                              const sinew_root_parts* parts, const sinew_step* step, sinew_dual_quat* out) {
  return c::call(c::given(scene, step, out), [&] {
    PlaybackStep own;
    RootOfClip root;
    if (const sinew_error error = read_step(*step, own)) return error;
    if (const sinew_error error = find_root(scene, clip, joint, parts, root)) return error;
    *out = c::to_c(root_motion(*root.animation, root.rest, root.parts, own));
    return SINEW_OK;
  });
}

sinew_error sinew_root_track_create(const sinew_scene* scene, const sinew_library* library, std::uint32_t clip,
                                    std::uint32_t joint, const sinew_root_parts* parts, sinew_root_track** out) {
  return c::call(c::given(scene, library, out), [&] {
    RootMotionParts own;
    if (const sinew_error error = c::read_fields(parts, kParts, own)) return error;
    if (clip >= library->clips.size() || joint >= scene->scene.skeleton.joint_count()) return SINEW_INDEX_OUT_OF_RANGE;
    const BoundClips bound = clips_for(library->clips, scene->scene);
    *out = new sinew_root_track{decompile_joint(bound.clips[clip], joint), scene->scene.skeleton.rest[joint], own};
    return SINEW_OK;
  });
}

void sinew_root_track_destroy(sinew_root_track* track) { delete track; }

sinew_error sinew_root_track_place(const sinew_root_track* track, double time_s, sinew_dual_quat* out) {
  return c::call(c::given(track, out), [&] {
    if (!std::isfinite(time_s)) return SINEW_NOT_FINITE;
    *out = c::to_c(root_place(track->animation, track->rest, track->parts, time_s));
    return SINEW_OK;
  });
}

sinew_error sinew_root_track_motion(const sinew_root_track* track, const sinew_step* step, sinew_dual_quat* out) {
  return c::call(c::given(track, step, out), [&] {
    PlaybackStep own;
    if (const sinew_error error = read_step(*step, own)) return error;
    *out = c::to_c(root_motion(track->animation, track->rest, track->parts, own));
    return SINEW_OK;
  });
}
