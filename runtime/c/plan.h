// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Parts of the result that frames compute. The plan leaves out parts without a flag, and they cost nothing.
enum {
  SINEW_NEED_JOINTS = 1u << 0,     ///< world matrices of all joints
  SINEW_NEED_POSITIONS = 1u << 1,  ///< positions of deformed vertices
  SINEW_NEED_NORMALS = 1u << 2,
  SINEW_NEED_TANGENTS = 1u << 3,  ///< tangents of primitives that have a normal map in some variant, or no material
  SINEW_NEED_WEIGHTS = 1u << 4,   ///< morph weights with the correctives
  SINEW_NEED_BOUNDS = 1u << 5,
  SINEW_NEED_PROPERTIES = 1u << 6,     ///< animated numbers of materials, lights and cameras
  SINEW_NEED_HIDDEN_MESHES = 1u << 7,  ///< deform meshes on hidden joints too
  SINEW_NEED_ADDITIVE = 1u << 8,       ///< layers may add to the pose
  SINEW_NEED_PALETTES = 1u << 9,       ///< skinning matrices, for engines that skin vertices themselves
  SINEW_NEED_BETWEEN_UPDATES =
      1u << 10,  ///< some frames lie between two poses (sinew_frame_input.interpolation_factor)
  SINEW_NEED_TANGENTS_OF_ALL = 1u << 11,  ///< tangents of all primitives, for engines with their own materials
  SINEW_NEED_CUT =
      1u << 12,  ///< some frames run in two halves, between which the caller changes the pose (cut_frame.h)
  SINEW_NEED_LOCAL_POSE = 1u << 13  ///< local transforms (sinew_result_info.local)
};

typedef enum sinew_skinning {
  SINEW_SKIN_LINEAR = 0,
  SINEW_SKIN_DUAL_QUATERNION = 1,
  SINEW_SKIN_CENTER_OF_ROTATION = 2  ///< linear for meshes without centers of rotation
} sinew_skinning;

typedef enum sinew_normal_rule { SINEW_NORMALS_LINEAR = 0, SINEW_NORMALS_COFACTOR = 1 } sinew_normal_rule;

/// Joints that poses can do without (skeleton_lod.h).
typedef struct sinew_skeleton_lod sinew_skeleton_lod;
/// How left and right are exchanged (mirror.h).
typedef struct sinew_mirror sinew_mirror;

typedef struct sinew_needs {
  size_t struct_size;
  uint32_t flags;                          ///< SINEW_NEED_*, combined with |
  uint32_t max_layers;                     ///< most layers that blend in one frame, at least 1
  uint32_t max_adding_layers;              ///< most layers that add in one frame, with SINEW_NEED_ADDITIVE
  uint32_t skinning;                       ///< a value of sinew_skinning
  uint32_t normal_rule;                    ///< a value of sinew_normal_rule
  uint32_t mask_count;                     ///< at most 255
  const float* masks;                      ///< [mask_count][joints] weights >= 0, one row after another; copied
  const unsigned char* instance_skinning;  ///< [instances] sinew_skinning of each, or null = `skinning` for all; copied
  const sinew_skeleton_lod* skeleton_lod;  ///< made of the same scene; null = all joints; copied
  sinew_indices cached_instances;  ///< rising: mesh instances that sinew_frame_input.geometry may play in; copied
  const sinew_mirror* mirror;      ///< of the same scene, for SINEW_LAYER_MIRRORED; null = nothing is mirrored; shared
  const sinew_program_room* program;  ///< upper limits of the programs that frames run; null = no programs; copied
} sinew_needs;

/// Everything but bounds, palettes, hidden meshes, adding layers, poses between updates and cuts. There are 4 layers
/// of each kind, no programs, linear skinning and all joints; struct_size is set.
SINEW_API sinew_needs sinew_default_needs(void);

/// The stages that a scene needs. Shared by all characters that show the scene. Plans of one scene share the tables
/// that they derive from its meshes.
typedef struct sinew_plan sinew_plan;

/// Compiles the plan of a scene.
/// in   scene  must outlive the plan;   needs  null = sinew_default_needs
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_UNSUPPORTED (an unknown flag or kind, no layer at all, more
///      room than programs can use),
///      SINEW_INDEX_OUT_OF_RANGE (cached instances that do not exist, or do not rise),
///      SINEW_NOT_FINITE (a mask with a weight that is not finite or below 0), SINEW_SIZE_MISMATCH (skeleton LOD or
///      mirror of another scene), SINEW_OUT_OF_MEMORY
/// cost O(size of the scene); memory of operator new, which an engine may replace
SINEW_API sinew_error sinew_plan_create(const sinew_scene* scene, const sinew_needs* needs, sinew_plan** out);
/// Destroys a plan. Destroy its frame buffers, jobs and inputs first.
SINEW_API void sinew_plan_destroy(sinew_plan* plan);

/// The index in poses of a joint of the scene: the joint itself, or with a skeleton LOD a smaller number. SINEW_NONE
/// for a joint that the plan leaves out, and for one that does not exist.     cost O(1)
SINEW_API uint32_t sinew_pose_joint(const sinew_plan* plan, uint32_t joint);

/// Bytes of one frame buffer of the plan. It begins at a multiple of SINEW_FRAME_ALIGNMENT.
SINEW_API size_t sinew_plan_frame_bytes(const sinew_plan* plan);
#define SINEW_FRAME_ALIGNMENT 64

/// One stage of the plan, with the reason why it runs or is left out.
typedef struct sinew_stage {
  size_t struct_size;
  sinew_string name, reason;
  uint64_t count;  ///< items that the stage touches per frame: tracks, joints, vertices
  uint64_t bytes;  ///< frame memory that the stage writes
  uint32_t runs;   ///< 1 or 0
} sinew_stage;

SINEW_API size_t sinew_stage_count(const sinew_plan* plan);
/// Describes stage number `stage`, in the order in which stages run.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE
SINEW_API sinew_error sinew_get_stage(const sinew_plan* plan, uint32_t stage, sinew_stage* out);

#ifdef __cplusplus
}
#endif
