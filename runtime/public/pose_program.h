// SPDX-License-Identifier: MIT
#pragma once
/// Pose programs: short lists of operations on poses, run by frames (FrameInput::program) or by a job of their own.
/// find_op_shares says how much of each clip is in the pose.
#include "runtime/pose_program/op_shares.h"
#include "runtime/pose_program/run_pose_program.h"
