// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/messages.h"
#include "runtime/c/plan.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/result.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_layer_kind {
  SINEW_LAYER_BLEND = 0,        ///< averaged with the other blending layers by weight
  SINEW_LAYER_ADD_TO_REST = 1,  ///< adds the difference of the clip from the rest pose
  SINEW_LAYER_ADD_TO_START = 2  ///< adds the difference of the clip from its own first pose
} sinew_layer_kind;
/// Added to a kind: the clip plays with left and right exchanged, its morph weights too (sinew_needs.mirror). Masks
/// weigh joints of the mirrored pose.
#define SINEW_LAYER_MIRRORED 0x100u

/// One clip playing at one time. This struct never grows.
typedef struct sinew_layer {
  double time_s;
  uint32_t clip;
  uint32_t mask;  ///< SINEW_NONE, or index of a mask of sinew_needs, continued by those of
                  ///< sinew_frame_input.program_inputs
  float weight;   ///< >= 0; additive layers subtract below 0
  uint32_t kind;  ///< sinew_layer_kind, and SINEW_LAYER_MIRRORED
} sinew_layer;

/// A source of vertices that replaces the pose of mesh instances. sinew_geometry_player_source makes it
/// (sinew_geometry.h); it is valid as long as that player. This struct never grows.
typedef struct sinew_vertex_source {
  uint64_t inside[6];  ///< private; all zero = no source
} sinew_vertex_source;

/// The vertex source that plays in one mesh instance. This struct never grows.
typedef struct sinew_geometry_input {
  sinew_vertex_source source;
  double time_s;  ///< on the source's clock; the same for all instances of a source
  float weight;   ///< [0, 1] 1 = only vertices of the source; smaller: blended with the pose in world space
} sinew_geometry_input;

typedef struct sinew_frame_input {
  size_t struct_size;
  const sinew_layer* layers;         ///< none = rest pose, which also gets the remainder if weights sum to less than 1
  size_t layer_count;                ///< at most max_layers + max_adding_layers
  sinew_floats weights;              ///< all morph weights in place of those of the clips; empty = those of the clips
  sinew_affine root;                 ///< world transform above all root joints
  const unsigned char* out_of_view;  ///< [instances] 1 = the mesh is out of view, so it is not morphed, skinned or
                                     ///< bounded; null = all are in view
  uint32_t asleep;                   ///< 1 = nothing of the character is needed: no work is done, the result is empty
  const sinew_layer* next_layers;    ///< layers of a later time; not read while interpolation_factor is 0
  size_t next_layer_count;           ///< at most max_layers + max_adding_layers
  float interpolation_factor;  ///< [0, 1] part of the way from the pose of `layers` to that of `next_layers`; needs
                               ///< SINEW_NEED_BETWEEN_UPDATES, else 0
  const sinew_geometry_input* geometry;  ///< [sinew_needs.cached_instances] null = no source plays
  size_t geometry_count;                 ///< number of cached instances, or 0
  const sinew_page* const* pages;        ///< [layer_count] for layers whose clip is in pages: the page with its keys.
                                         ///< Null, or a null element, if the clip has its keys itself. Pages must
                                         ///< stay alive and unchanged as long as frames use the layers
  const sinew_page* const* next_pages;   ///< [layer_count of next_layers] pages of the next layers
  const sinew_pose_op* program;          ///< [op_count] makes the pose in place of layers, which must then be empty;
                                         ///< needs sinew_needs.program
  size_t op_count;                       ///< 0 = the layers make the pose
  const sinew_program_inputs* program_inputs;  ///< the lists that its operations index, and masks that layers name;
                                               ///< null = all empty
} sinew_frame_input;

/// No layers and no program, root identity, interpolation factor 0; struct_size is set.
SINEW_API sinew_frame_input sinew_default_input(void);

/// All memory of one character. Frames run into it and allocate nothing.
typedef struct sinew_frame sinew_frame;

/// Creates the memory of one character.
/// in   plan  must outlive the frame;   allocator  null = operator new; copied. It is called once, for a block of
///      sinew_plan_frame_bytes
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_frame_create(const sinew_plan* plan, const sinew_allocator* allocator, sinew_frame** out);
/// sinew_frame_create in a block of the caller, which must outlive the frame. The block has at least
/// sinew_plan_frame_bytes and begins at a multiple of SINEW_FRAME_ALIGNMENT.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (too short, or not aligned)
SINEW_API sinew_error sinew_frame_create_in(const sinew_plan* plan, void* block, size_t byte_count, sinew_frame** out);
SINEW_API void sinew_frame_destroy(sinew_frame* frame);

/// Evaluates one frame. If the input is that of the last run, nothing is computed again.
/// in   input  null = the rest pose
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE (clip, mask, an instance that the source
///      does not play; what a program names), SINEW_SIZE_MISMATCH (weights, geometry, poses and masks of a program, its
///      operands, poses that are not aligned), SINEW_TOO_MANY_LAYERS, SINEW_WRONG_PAGE,
///      SINEW_NOT_FINITE, SINEW_NEGATIVE_WEIGHT, SINEW_TOO_LARGE (a weight or the root above 1e9),
///      SINEW_NOT_A_FRACTION (interpolation factor, weight of a source, share or threshold of an operation),
///      SINEW_TWO_TIMES, SINEW_UNSUPPORTED (kind of layer, operation or space; a source in scene space for an instance
///      with copies; layers or an interpolation factor beside a program; a procedure without code), SINEW_NOT_IN_NEEDS
///      (the plan has no mirror, no additive layers, no frames between updates, or one layer and so no weight below 1;
///      it has no room for the program or its lists). After an error the result is still the last good one.
SINEW_API sinew_error sinew_run(sinew_frame* frame, const sinew_frame_input* input);

/// Says why sinew_run refuses this input: which field, which index, which rule ("layers[1].weight: a weight is below
/// 0"). `layers[1].page` is pages[1], and `layers[1].mirrored` is SINEW_LAYER_MIRRORED in its kind. Lists of a program
/// are those of sinew_program_inputs.
/// in   input  null = the rest pose
/// out  why    one line, owned by the caller; NULL where sinew_run does not refuse
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_why_refused(const sinew_frame* frame, const sinew_frame_input* input, sinew_messages** why);

/// Loads the memory that the next run touches first into the caches, without waiting. In a crowd, call it for the next
/// character before this one runs.
SINEW_API void sinew_frame_prefetch(const sinew_frame* frame);

/// 1 = runs write vertices past the processor's caches: for results that no code reads soon, for example those that a
/// GPU reads. The bits are the same.
SINEW_API void sinew_frame_write_past_caches(sinew_frame* frame, int past_caches);

/// The frame's last good result.
SINEW_API const sinew_result* sinew_frame_result(const sinew_frame* frame);

#ifdef __cplusplus
}
#endif
