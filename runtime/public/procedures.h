// SPDX-License-Identifier: MIT
#pragma once
/// Inverse kinematics: limbs that reach targets, heads and eyes that look at them, chains and whole bodies, and limits
/// of joints. Feet stay where they stand, on any ground. As jobs on a local pose, or as operations of pose programs,
/// which plans and the job thread run.
///
///     sinew::TwoBoneIk arm{.goal = {.root = shoulder, .middle = elbow, .tip = hand, .target = {0.3, 1.2, 0.4}}};
///     const sinew::PoseProcedure procedure = as_procedure(arm);
///     program.sample(walk, time_s).procedure(0);
///     input.program_inputs.procedures = {&procedure, 1};
///     // After the frame: arm.result.status, arm.result.metres_left.
#include "runtime/procedures/aim.h"
#include "runtime/procedures/chain_ik.h"
#include "runtime/procedures/feet.h"
#include "runtime/procedures/ik_result.h"
#include "runtime/procedures/joint_limit.h"
#include "runtime/procedures/look_at/look_at.h"
#include "runtime/procedures/procedure.h"
#include "runtime/procedures/two_bone_ik.h"
