// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Local transforms of the joints of a scene, in memory of the caller: ten planes of floats, in an order that only the
/// library knows. This struct never grows.
typedef struct sinew_pose {
  float* planes;       ///< [sinew_pose_floats(joint_count)] at a multiple of SINEW_POSE_ALIGNMENT bytes
  size_t joint_count;  ///< number of joints of the scene
} sinew_pose;
#define SINEW_POSE_ALIGNMENT 64

/// Floats that the planes of a pose take.
SINEW_API size_t sinew_pose_floats(size_t joint_count);

/// A transform relative to the parent joint: scale first, then rotation, then translation.
typedef struct sinew_transform {
  sinew_vec3 translation;
  sinew_vec4 rotation;  ///< unit quaternion x y z w
  sinew_vec3 scale;
} sinew_transform;

// All functions below return SINEW_NULL_ARGUMENT for null pointers, and SINEW_SIZE_MISMATCH for poses that are not
// aligned or have another number of joints than the scene. None of them allocates.

/// Reads the local transform of a joint.
/// err  SINEW_INDEX_OUT_OF_RANGE
SINEW_API sinew_error sinew_pose_get(const sinew_pose* pose, uint32_t joint, sinew_transform* out);
/// Writes the local transform of a joint.
/// in   transform  finite, rotation unit;   err  SINEW_INDEX_OUT_OF_RANGE, SINEW_NOT_FINITE
SINEW_API sinew_error sinew_pose_set(const sinew_pose* pose, uint32_t joint, const sinew_transform* transform);

/// Writes the rest pose of a scene.
SINEW_API sinew_error sinew_pose_rest(const sinew_scene* scene, const sinew_pose* out);

/// Samples a clip of the scene at a time; times outside of the clip clamp.
/// err  SINEW_INDEX_OUT_OF_RANGE (clip), SINEW_NOT_FINITE (time)
SINEW_API sinew_error sinew_pose_sample(const sinew_scene* scene, uint32_t clip, double time_s, const sinew_pose* out);

/// Computes the world matrices of all joints.
/// in   root  world transform above all root joints; null = identity
/// out  model[capacity]
/// err  SINEW_SIZE_MISMATCH (capacity below the joints)
SINEW_API sinew_error sinew_pose_to_model(const sinew_scene* scene, const sinew_pose* pose, const sinew_affine* root,
                                          sinew_affine* model, size_t capacity);

#ifdef __cplusplus
}
#endif
