// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/plan.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_layer_kind {
  SINEW_LAYER_BLEND = 0,        ///< averaged with its like by weight
  SINEW_LAYER_ADD_TO_REST = 1,  ///< adds what the clip differs from the rest pose
  SINEW_LAYER_ADD_TO_START = 2  ///< adds what the clip differs from its own first instant
} sinew_layer_kind;
/// Added to a kind: the clip plays with left and right exchanged, its morph weights too (sinew_needs.mirror). Masks
/// weigh joints of the mirrored pose.
#define SINEW_LAYER_MIRRORED 0x100u

/// One clip playing at one time. This struct never grows.
typedef struct sinew_layer {
  double time_s;
  uint32_t clip;
  uint32_t mask;  ///< of sinew_needs, SINEW_NONE = all joints
  float weight;
  uint32_t kind;  ///< sinew_layer_kind, and SINEW_LAYER_MIRRORED
} sinew_layer;

/// Vertices of mesh instances in place of their pose, from sinew_geometry_player_source (sinew_geometry.h). Valid as
/// long as that player. This struct never grows.
typedef struct sinew_vertex_source {
  uint64_t inside[6];  ///< all zero = none
} sinew_vertex_source;

/// The vertex source that plays in one mesh instance. This struct never grows.
typedef struct sinew_geometry_input {
  sinew_vertex_source source;
  double time_s;  ///< on the source's clock; the same for all instances of a source
  float weight;   ///< [0, 1] 1 = vertices of the source alone; below: blended with the pose in world space
} sinew_geometry_input;

/// The keys of a clip for one time (pages.h).
typedef struct sinew_page sinew_page;

typedef struct sinew_frame_input {
  size_t struct_size;
  const sinew_layer* layers;         ///< none = rest pose. Where weights sum to less than 1 the rest pose fills up
  size_t layer_count;                ///< at most max_layers + max_adding_layers
  sinew_floats weights;              ///< all morph weights in place of the clips' own; empty = the clips'
  sinew_affine root;                 ///< placed above all root joints
  const unsigned char* out_of_view;  ///< [instances] 1 = nobody sees the mesh: neither morphed nor skinned nor bounded;
                                     ///< null = all in view
  uint32_t asleep;                 ///< 1 = nobody needs anything of the character: no work is done, the result is empty
  const sinew_layer* next_layers;  ///< layers of a later time; not looked at while interpolation_factor is 0
  size_t next_layer_count;         ///< at most max_layers + max_adding_layers
  float interpolation_factor;      ///< [0, 1] part of the way from the pose of `layers` to that of `next_layers`; needs
                                   ///< SINEW_NEED_BETWEEN_UPDATES, else 0
  const sinew_geometry_input* geometry;  ///< [sinew_needs.cached_instances] null = nothing plays
  size_t geometry_count;                 ///< of these, or 0
  const sinew_page* const* pages;        ///< [layer_count] the keys of layers whose clips lie in pages. Null, and null
                                         ///< elements: the clips have them. Pages live, and stay as
                                         ///< they are, as long as frames get the layers
  const sinew_page* const* next_pages;   ///< [next_layer_count] the same for next_layers
} sinew_frame_input;

/// No layers, root identity, interpolation factor 0; struct_size is set.
SINEW_API sinew_frame_input sinew_default_input(void);

/// All memory of one character. Frames run into it and allocate nothing.
typedef struct sinew_frame sinew_frame;

/// in   plan  must outlive the frame;   allocator  null = operator new; copied. Asked once, for sinew_plan_frame_bytes
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_frame_create(const sinew_plan* plan, const sinew_allocator* allocator, sinew_frame** out);
/// The same in the caller's block, of at least sinew_plan_frame_bytes at a multiple of SINEW_FRAME_ALIGNMENT, which
/// must outlive the frame.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (too short, or not aligned)
SINEW_API sinew_error sinew_frame_create_in(const sinew_plan* plan, void* block, size_t byte_count, sinew_frame** out);
SINEW_API void sinew_frame_destroy(sinew_frame* frame);

/// Evaluates one frame; the same input again does nothing.
/// in   input  null = the rest pose
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE (clip, mask, an instance that the source
///      does not play), SINEW_SIZE_MISMATCH (weights, geometry), SINEW_TOO_MANY_LAYERS, SINEW_WRONG_PAGE,
///      SINEW_NOT_FINITE, SINEW_NEGATIVE_WEIGHT, SINEW_TOO_LARGE (a weight or the root above 1e9),
///      SINEW_NOT_A_FRACTION (interpolation factor or weight of a source), SINEW_TWO_TIMES, SINEW_UNSUPPORTED (kind of
///      layer; a source in scene space for an instance with copies), SINEW_NOT_IN_NEEDS (the plan has no mirror, no
///      additive layers, no frames between updates, or one layer and so no weight below 1). Afterwards the last good
///      frame is still there.
SINEW_API sinew_error sinew_run(sinew_frame* frame, const sinew_frame_input* input);

/// Loads the memory that the next run touches first into the caches, without waiting. In a crowd, call it for the next
/// character before this one runs.
SINEW_API void sinew_frame_prefetch(const sinew_frame* frame);

/// 1 = runs write vertices past the caches: for results that no code reads soon, as for a GPU. The bits are the same.
SINEW_API void sinew_frame_write_past_caches(sinew_frame* frame, int past_caches);

/// The result of a frame. It belongs to the frame or the jobs that gave it, and is valid until they run again.
typedef struct sinew_result sinew_result;
SINEW_API const sinew_result* sinew_frame_result(const sinew_frame* frame);

typedef struct sinew_result_info {
  size_t struct_size;
  uint64_t frame;           ///< counts up by one per run
  uint64_t since_frame;     ///< the result is bit-identical since this frame
  sinew_affines model;      ///< [joints] world matrices
  sinew_floats weights;     ///< all morph weights
  sinew_floats properties;  ///< animated numbers
  sinew_flags hidden;       ///< [joints] 1 = not shown; empty when nothing is ever hidden
  size_t instance_count, shape_count;
} sinew_result_info;
SINEW_API sinew_error sinew_get_result(const sinew_result* result, sinew_result_info* out);

/// World matrix of any joint of the scene, also of one that the plan's skeleton LOD leaves out: a socket for what the
/// character carries.
/// in   result  of a frame of the plan;   offset  from the joint, applied first; null = none
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (joint), SINEW_UNSUPPORTED (the result has no joints: not asked
///      for, or asleep), SINEW_SIZE_MISMATCH (a result of another plan)
SINEW_API sinew_error sinew_world_of(const sinew_plan* plan, const sinew_result* result, uint32_t joint,
                                     const sinew_affine* offset, sinew_affine* out);

/// Skinning matrices of a skin, columns of four; empty unless asked for and used by a mesh that is shown.
SINEW_API sinew_joint_matrices sinew_get_palette(const sinew_result* result, uint32_t skin);

typedef struct sinew_instance_result {
  size_t struct_size;
  sinew_affine world_from_mesh;  ///< identity for skinned meshes: their vertices are in world space
  sinew_box bounds;              ///< world space; empty unless asked for
  uint32_t first_shape;          ///< one shape per primitive of its mesh
  uint32_t mirrored;             ///< 1: front faces wind clockwise
  uint32_t visible;              ///< 0: on a hidden joint, or out of view
  uint32_t from_cache;           ///< 1: vertices are those of its source, in part or in full
  uint32_t late;                 ///< 1: the cache had not loaded this frame yet, so an older one (or the pose) is shown
} sinew_instance_result;
SINEW_API sinew_error sinew_get_instance_result(const sinew_result* result, uint32_t instance,
                                                sinew_instance_result* out);

/// Deformed vertices of one primitive of one instance. Empty spans: use the primitive's own.
typedef struct sinew_shape {
  size_t struct_size;
  uint32_t instance, primitive;
  sinew_vec3s positions, normals;
  sinew_vec4s tangents, colors;
  uint64_t since_frame;  ///< vertices are bit-identical since this frame; 0 = nothing to upload
} sinew_shape;
SINEW_API sinew_error sinew_get_shape(const sinew_result* result, uint32_t shape, sinew_shape* out);

#ifdef __cplusplus
}
#endif
