// SPDX-License-Identifier: MIT
#pragma once
/// Clips: animations compiled for playing, immutable and small. Copies of a Clip share the keys. Jobs sample clips
/// (pose_jobs.h) and plans play them (plan.h). A clip can be unpacked for speed, reduced to some joints, or decompiled
/// to keys.
///
///     const sinew::Clip clip = compile_clip(animation, scene.skeleton, rest_weights_of(scene), scene.first_weight);
///     const sinew::Clip faster = unpacked(clip);  // more memory, the same bits
#include "runtime/clip/clip.h"
#include "runtime/clip/clip_rest.h"
#include "runtime/clip/decompile_clip.h"
#include "runtime/clip/keep_joints.h"
#include "runtime/clip/unpack_clip.h"
