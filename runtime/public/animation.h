// SPDX-License-Identifier: MIT
#pragma once
/// Animations in authoring form: keys as the file has them, in full precision. A Clip (clip.h) is compiled from an
/// Animation. evaluate_truth computes a pose in double precision, for tools and tests. Frames never read this form.
///
///     sinew::Animation swing{.name = "swing", .duration_s = 2.0};
///     if (auto bone = sinew::BoneAnimation::from_keyframes(joint, keys)) swing.bones.push_back(std::move(*bone));
///     const sinew::Clip clip = compile_clip(swing, skeleton, {}, {});
#include "runtime/animation/bone_animation.h"
#include "runtime/animation/close_loop.h"
#include "runtime/animation/property_track.h"
#include "runtime/animation/track.h"
#include "runtime/animation/truth_pose.h"
