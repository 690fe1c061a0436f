// SPDX-License-Identifier: MIT
#pragma once
/// Jobs on poses, for engines that run stages themselves; plans (plan.h) run the same jobs. A job is a struct of spans
/// into memory of the caller. check(job) returns the first broken rule, and run(job) does the work and allocates
/// nothing.
///
///     sinew::PoseMemory memory(joints);
///     const sinew::SampleClipJob sample{.clip = &clip, .time_s = 0.5, .pose = memory.span(), .weights = {}};
///     if (check(sample) == sinew::ErrorCode::ok) run(sample);
///     // In order: sample, mirror (mirror.h), blend, add, correct, local to model, palette of a skin.
#include "runtime/pose/add_pose.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/correct_pose.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/pose.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"
