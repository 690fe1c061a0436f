// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/pose.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// Pose programs: the pose of a frame as operations (sinew_frame_input.program). Each takes its operands from a stack of
// poses, with morph weights and properties, and leaves one there. A program is plain bytes.

typedef enum sinew_op_kind {
  SINEW_OP_REST = 0,             ///< pushes the rest pose
  SINEW_OP_SAMPLE = 1,           ///< pushes clip `index` at `time_s`
  SINEW_OP_SAMPLE_MIRRORED = 2,  ///< as SINEW_OP_SAMPLE, with left and right exchanged
  SINEW_OP_REST_MIRRORED = 3,    ///< pushes the rest pose with left and right exchanged
  SINEW_OP_EXTERNAL = 4,         ///< pushes pose `index` of the caller: a ragdoll, the network
  SINEW_OP_MEAN = 5,             ///< weighted mean of the `index` topmost poses; no operands give the rest pose
  SINEW_OP_OVERLAY = 6,          ///< lays the topmost pose over the pose below it, by weight and mask
  SINEW_OP_OVERLAY_MODEL = 7,    ///< as SINEW_OP_OVERLAY, but rotations are mixed in model space
  SINEW_OP_ADD_TO_REST = 8,      ///< adds the topmost pose minus the rest pose to the pose below
  SINEW_OP_ADD = 9,  ///< adds layer minus reference to base: third, second and topmost are base, layer, reference
  SINEW_OP_OVERRIDE_JOINTS = 10,  ///< sets joints of the topmost pose to the transforms of override `index`
  SINEW_OP_PROCEDURE = 11,        ///< lets procedure `index` of the caller change the topmost pose: IK, springs
  SINEW_OP_INERTIALIZE = 12,      ///< transition: adds the source's offset from the target at the start, which decays
  SINEW_OP_DEAD_BLEND = 13,       ///< transition: fades the source, which moves on by its velocity, into the target
  SINEW_OP_CACHED = 14  ///< keeps the topmost pose for later frames while the operations that make it are the same
} sinew_op_kind;
#define SINEW_OP_NO_MASK 255u
#define SINEW_MOST_OPS 255u  ///< most operations of one program

/// One operation. `weight` and `mask` apply when a later mean, overlay (as upper pose) or addition (as layer) takes its
/// pose. Transitions take the target's pose now, then the source's pose at the start and one step before.
/// SINEW_OP_INERTIALIZE also takes the target's pose at the start and one step before. This struct never grows: its 16
/// bytes may be stored and sent.
typedef struct sinew_pose_op {
  double time_s;   ///< sample: seconds in the clip;  mean: threshold in (0, 1], below which the rest pose fills up;
                   ///< override, procedure: its share in [0, 1];  transitions: their progress in [0, 1]
  float weight;    ///< finite, >= 0; below 0 only as the layer of an addition, which then subtracts
  uint16_t index;  ///< of a clip, an external pose, an override or a procedure;  mean: number of operands;  additions:
                   ///< 0 = turn joints in their parent's frame, 1 = in their own.  Transitions: steps in the duration,
                   ///< >= 1; steps of 0.1 to 1 ms measure velocities well
  uint8_t mask;  ///< index of joint weights that multiply `weight`; SINEW_OP_NO_MASK = all joints. Masks of the caller
                 ///< (sinew_program_inputs.masks) follow those of sinew_needs
  uint8_t kind;  ///< a value of sinew_op_kind
} sinew_pose_op;

/// An operation of weight 1 without a mask: `index` is 0, and the threshold or share is 1. A transition has one step.
SINEW_API sinew_pose_op sinew_default_op(uint32_t kind);

/// Upper limits of what the programs of a plan use: operations, stack slots, and the lists that they index.
typedef struct sinew_program_room {
  size_t struct_size;
  uint32_t ops;                               ///< at most SINEW_MOST_OPS
  uint32_t slots;                             ///< poses on the stack at once, at most `ops`
  uint32_t externals, overrides, procedures;  ///< entries in each of the caller's lists, at most 65535
  uint32_t masks;                             ///< masks of sinew_needs and of the caller together, at most 255
  uint32_t overridden_joints;                 ///< joints of all overrides together
  uint32_t overlays_in_model_space;           ///< 1 if programs use SINEW_OP_OVERLAY_MODEL
  uint32_t kept;                              ///< transitions and operations SINEW_OP_CACHED, at most `ops`
} sinew_program_room;

/// The room that a program needs, by its largest indices. `overridden_joints` is left at 0.
/// out  room  with struct_size set.   err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_program_room_of(const sinew_pose_op* ops, size_t op_count, sinew_program_room* room);
/// Raises each number of `room` to at least that of `other`.     err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_raise_program_room(sinew_program_room* room, const sinew_program_room* other);

// Operations refer to entries of the lists below by index. Equal versions of an entry promise equal content; version 0
// promises nothing. Joint indices are those of the scene, or with a skeleton_lod those of sinew_pose_joint. The structs
// of entries never grow.

/// A pose of the caller.
typedef struct sinew_external_pose {
  sinew_pose pose;          ///< only read
  sinew_floats weights;     ///< all morph weights of the scene; empty = their rest values
  sinew_floats properties;  ///< all animated numbers of the scene; empty = their rest values
  uint64_t version;
} sinew_external_pose;

typedef enum sinew_override_space {
  SINEW_OVERRIDE_LOCAL = 0,  ///< relative to the parent joint
  SINEW_OVERRIDE_MODEL = 1,  ///< model space, relative to sinew_frame_input.root
  SINEW_OVERRIDE_WORLD = 2
} sinew_override_space;

/// A joint that the caller places, and its transform.
typedef struct sinew_joint_override {
  uint32_t joint;
  sinew_transform transform;
  uint8_t space;  ///< a value of sinew_override_space
} sinew_joint_override;

/// Joints that one operation places, in this order. A parent comes before its children.
typedef struct sinew_joint_overrides {
  const sinew_joint_override* joints;
  size_t joint_count;
  uint64_t version;
} sinew_joint_overrides;

/// Weights of the caller, >= 0, that multiply the weight of an operation. An empty list stands for ones.
typedef struct sinew_pose_mask {
  sinew_floats joints;      ///< [joints of poses]
  sinew_floats weights;     ///< all morph weights of the scene
  sinew_floats properties;  ///< all animated numbers of the scene
  uint64_t version;
} sinew_pose_mask;

/// The pose that a procedure may change, in memory of the frame. Valid only during the call.
typedef struct sinew_procedure_pose {
  size_t struct_size;     ///< sizeof this struct in the library; fields beyond it do not exist
  sinew_pose local;       ///< may be written
  float* weights;         ///< [weight_count] may be written
  size_t weight_count;    ///< 0 if sinew_frame_input.weights gives all morph weights
  float* properties;      ///< [property_count] may be written
  size_t property_count;  ///< 0 if properties are not wanted
  float share;            ///< (0, 1] the share of the operation, which the procedure interprets
} sinew_procedure_pose;

/// A function of the caller that changes the pose in the middle of a program. It runs on the thread that runs the
/// frame, and must not throw or longjmp. An unchanged version promises the same output pose for the same input pose.
typedef struct sinew_pose_procedure {
  void (*run)(void* context, const sinew_procedure_pose* pose);
  void* context;
  uint64_t version;
} sinew_pose_procedure;

/// The part of a clip that holds the keys for one time (pages.h).
typedef struct sinew_page sinew_page;

/// The tables that operations of a program refer to by index, and the keys of clips that lie in pages.
typedef struct sinew_program_inputs {
  size_t struct_size;
  const sinew_external_pose* externals;
  size_t external_count;
  const sinew_joint_overrides* overrides;
  size_t override_count;
  const sinew_pose_procedure* procedures;  ///< not copied: must not change until the frames that use it are done
  size_t procedure_count;
  const sinew_pose_mask* masks;
  size_t mask_count;
  const sinew_page* const* pages;  ///< [operations] or null: the page with the keys of the operation's clip and time,
                                   ///< or null where the clip has them. Must not change while frames use it
} sinew_program_inputs;

#ifdef __cplusplus
}
#endif
