// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/pose.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// Pose programs: the pose of a frame as a short list of operations, which a graph or a script of the engine writes
// (sinew_frame_input.program). An operation takes its operands from a stack of poses and leaves one pose there. With
// the pose go its morph weights and its properties. A program is plain bytes: copy it, compare it, store it.

typedef enum sinew_op_kind {
  SINEW_OP_REST = 0,              ///< pushes the rest pose
  SINEW_OP_SAMPLE = 1,            ///< pushes clip `index` at `time_s`
  SINEW_OP_SAMPLE_MIRRORED = 2,   ///< the same, left and right exchanged
  SINEW_OP_REST_MIRRORED = 3,     ///< the rest pose, left and right exchanged
  SINEW_OP_EXTERNAL = 4,          ///< pushes pose `index` of the caller: a ragdoll, the network
  SINEW_OP_MEAN = 5,              ///< weighted mean of the `index` topmost poses; no operands give the rest pose
  SINEW_OP_OVERLAY = 6,           ///< lays the topmost pose over the one below, by weight and mask
  SINEW_OP_OVERLAY_MODEL = 7,     ///< SINEW_OP_OVERLAY, but rotations are mixed in model space
  SINEW_OP_ADD_TO_REST = 8,       ///< adds the difference of the topmost pose from the rest pose to the pose below
  SINEW_OP_ADD = 9,               ///< adds the difference of the second pose from the topmost to the third
  SINEW_OP_OVERRIDE_JOINTS = 10,  ///< sets joints of the topmost pose to the transforms of override `index`
  SINEW_OP_PROCEDURE = 11,        ///< lets procedure `index` of the caller change the topmost pose: IK, springs
  SINEW_OP_INERTIALIZE = 12,      ///< a transition: adds the offset that source and target had at its start, while it
                                  ///< decays
  SINEW_OP_DEAD_BLEND = 13,       ///< a transition: fades the source, which goes on by itself, into the target
  SINEW_OP_CACHED = 14            ///< the topmost pose, kept while the operations that make it are the same
} sinew_op_kind;
#define SINEW_OP_NO_MASK 255u
#define SINEW_MOST_OPS 255u  ///< of one program

/// One operation. `weight` and `mask` weigh its pose in the mean, overlay or addition that takes it. In an overlay that
/// is the upper pose, in an addition the layer. Operands of transitions, the lowest first: the target's pose now, the
/// source's pose at the start and one step before. SINEW_OP_INERTIALIZE also takes the target's pose at the start and
/// one step before. This struct never grows: its 16 bytes may be stored and sent.
typedef struct sinew_pose_op {
  double time_s;   ///< sample: seconds in the clip;  mean: threshold in (0, 1]; if the weights sum to less, the rest
                   ///< pose gets the remainder;  override, procedure: its share in [0, 1].  transitions: their progress
                   ///< in [0, 1]
  float weight;    ///< finite, >= 0
  uint16_t index;  ///< of a clip, an external pose, an override or a procedure;  mean: number of operands;
                   ///< additions: 0 to turn joints in their parent's frame, 1 in their own.  transitions: steps
                   ///< in the duration, >= 1. A step of 0.1 to 1 ms measures velocities well
  uint8_t mask;    ///< whose joint weights multiply `weight`; SINEW_OP_NO_MASK = all joints. Masks of the caller
                   ///< (sinew_program_inputs.masks) follow those of sinew_needs
  uint8_t kind;    ///< sinew_op_kind
} sinew_pose_op;

/// An operation of weight 1 without a mask, at index 0. Its threshold or share is 1; the time of other kinds is 0. A
/// transition has one step.
SINEW_API sinew_pose_op sinew_default_op(uint32_t kind);

/// Upper limits of what the programs of a plan use: operations, stack slots, and the lists that they index.
typedef struct sinew_program_room {
  size_t struct_size;
  uint32_t ops;                               ///< at most SINEW_MOST_OPS
  uint32_t slots;                             ///< poses on the stack at once, at most `ops`
  uint32_t externals, overrides, procedures;  ///< of the caller, at most 65535 of each
  uint32_t masks;                             ///< of sinew_needs and of the caller together, at most 255
  uint32_t overridden_joints;                 ///< of all overrides together
  uint32_t overlays_in_model_space;           ///< 1 if programs use SINEW_OP_OVERLAY_MODEL
  uint32_t kept;                              ///< operations of kinds SINEW_OP_INERTIALIZE and higher
} sinew_program_room;

/// The room that a program needs. Lists are as long as its largest index asks for. `overridden_joints` is left at 0,
/// since a program does not say how many joints an override has.
/// out  room  with struct_size set by the caller
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE;   cost O(ops), no allocation
SINEW_API sinew_error sinew_program_room_of(const sinew_pose_op* ops, size_t op_count, sinew_program_room* room);
/// Raises `room` to what either of the two needs, for plans whose frames run several programs.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_raise_program_room(sinew_program_room* room, const sinew_program_room* other);

// Indices of a program name entries of the lists below. Each entry has a version: equal versions promise the same
// content as in the frame before, 0 promises nothing. Joints are those of poses: the scene's own, or where
// sinew_needs.skeleton_lod leaves joints out, what sinew_pose_joint answers. The structs of entries never grow.

/// A pose of the caller.
typedef struct sinew_external_pose {
  sinew_pose pose;          ///< not written
  sinew_floats weights;     ///< all morph weights of the scene; empty = their rest values
  sinew_floats properties;  ///< all animated numbers of the scene; empty = their rest values
  uint64_t version;
} sinew_external_pose;

/// Space of an overriding transform.
typedef enum sinew_override_space {
  SINEW_OVERRIDE_LOCAL = 0,  ///< against the parent joint
  SINEW_OVERRIDE_MODEL = 1   ///< above all root joints, below sinew_frame_input.root
} sinew_override_space;

/// A joint that the caller places.
typedef struct sinew_joint_override {
  uint32_t joint;
  sinew_transform transform;
  uint8_t space;  ///< sinew_override_space
} sinew_joint_override;

/// Joints that one operation places, in this order: a parent before its children.
typedef struct sinew_joint_overrides {
  const sinew_joint_override* joints;
  size_t joint_count;
  uint64_t version;
} sinew_joint_overrides;

/// Joint weights of the caller, which multiply the weight of an operation.
typedef struct sinew_joint_mask {
  sinew_floats weights;  ///< [joints of poses] finite, >= 0
  uint64_t version;
} sinew_joint_mask;

/// The pose that a procedure may change, in memory of the frame. Valid only during the call.
typedef struct sinew_procedure_pose {
  size_t struct_size;     ///< sizeof this struct in the library; fields beyond it do not exist
  sinew_pose local;       ///< may be written
  float* weights;         ///< [weight_count] may be written
  size_t weight_count;    ///< 0 where sinew_frame_input.weights gives all morph weights
  float* properties;      ///< [property_count] may be written
  size_t property_count;  ///< 0 where they are not wanted
  float share;            ///< (0, 1] the share of the operation, which the procedure interprets
} sinew_procedure_pose;

/// A function of the caller that changes the pose in the middle of a program. It runs on the thread that runs the
/// frame, and must return: it must not throw or longjmp. An unchanged version promises the same output pose for the
/// same input pose.
typedef struct sinew_pose_procedure {
  void (*run)(void* context, const sinew_procedure_pose* pose);
  void* context;
  uint64_t version;
} sinew_pose_procedure;

/// The keys of a clip for one time (pages.h).
typedef struct sinew_page sinew_page;

/// The tables that operations of a program refer to by index, and the keys of clips that lie in pages.
typedef struct sinew_program_inputs {
  size_t struct_size;
  const sinew_external_pose* externals;
  size_t external_count;
  const sinew_joint_overrides* overrides;
  size_t override_count;
  const sinew_pose_procedure* procedures;  ///< not copied, even where other inputs are: must not change until the
                                           ///< frames that use it are done
  size_t procedure_count;
  const sinew_joint_mask* masks;
  size_t mask_count;
  const sinew_page* const* pages;  ///< [operations] for those that sample a clip in pages: the page with its keys.
                                   ///< Null, or a null element, if the clip has its keys itself. Pages must stay alive
                                   ///< and unchanged as long as frames use them
} sinew_program_inputs;

#ifdef __cplusplus
}
#endif
