// SPDX-License-Identifier: MIT
#pragma once
/// Vectors, quaternions, transforms and matrices. Read detail/math/conventions.h first: axes, units and the order of
/// products. Types are GLM's. Functions are ours where GLM's fail: near half turns, for opposite quaternions, for tiny
/// or mirroring scales.
///
///     const sinew::Transform hand{.translation = {0, 1, 0}};
///     const sinew::Affine world = root * affine_from_transform(hand);
///     const sinew::Vec3<float> tip = transform_point(world, {0.0f, 0.2f, 0.0f});
#include "runtime/math/affine.h"
#include "runtime/math/axis_angle.h"
#include "runtime/math/conventions.h"
#include "runtime/math/decompose.h"
#include "runtime/math/determinant_sign.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/math/euler.h"
#include "runtime/math/interpolate.h"
#include "runtime/math/inverse.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/negligible.h"
#include "runtime/math/normal_transform.h"
#include "runtime/math/quat_log_exp.h"
#include "runtime/math/quaternion.h"
#include "runtime/math/rotation_between.h"
#include "runtime/math/swing_twist.h"
#include "runtime/math/transform.h"
#include "runtime/math/two_bones.h"
