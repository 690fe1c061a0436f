// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/plan.h"
#include "runtime/c/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The result of a frame. It belongs to the frame or the jobs that gave it, and is valid until they run again.
typedef struct sinew_result sinew_result;

typedef struct sinew_result_info {
  size_t struct_size;
  uint64_t frame;           ///< counts up by one per run
  uint64_t since_frame;     ///< the result is bit-identical since this frame
  sinew_affines model;      ///< [joints] world matrix of each joint
  sinew_floats weights;     ///< all morph weights
  sinew_floats properties;  ///< animated numbers of materials, lights and cameras
  sinew_flags hidden;       ///< [joints] 1 = not shown; empty when nothing is ever hidden
  size_t instance_count, shape_count;
  sinew_pose local;  ///< local transforms that `model` is composed of; not to be written
} sinew_result_info;
SINEW_API sinew_error sinew_get_result(const sinew_result* result, sinew_result_info* out);

/// World matrix of any joint of the scene, even of a joint that the plan's skeleton LOD leaves out. Use it to attach
/// things that the character carries.
/// in   result  of a frame of the plan;   offset  from the joint, applied first; null = none
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (joint), SINEW_UNSUPPORTED (the result has no joints: they are
///      not in the needs, or the character is asleep), SINEW_SIZE_MISMATCH (a result of another plan)
SINEW_API sinew_error sinew_world_of(const sinew_plan* plan, const sinew_result* result, uint32_t joint,
                                     const sinew_affine* offset, sinew_affine* out);

/// Skinning matrices of a skin, columns of four. Empty unless the needs ask for them and a visible mesh uses the skin.
SINEW_API sinew_joint_matrices sinew_get_palette(const sinew_result* result, uint32_t skin);

typedef struct sinew_instance_result {
  size_t struct_size;
  sinew_affine world_from_mesh;  ///< identity for skinned meshes: their vertices are in world space
  sinew_box bounds;              ///< world space; empty unless the needs ask for it
  uint32_t first_shape;          ///< one shape per primitive of its mesh
  uint32_t mirrored;             ///< 1: front faces wind clockwise
  uint32_t visible;              ///< 0: on a hidden joint, or out of view
  uint32_t from_cache;           ///< 1: some or all vertices come from a vertex source
  uint32_t late;  ///< 1: the source had not loaded this frame yet, so an older one (or the pose) is shown
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

typedef enum sinew_vertex_format {
  SINEW_VERTEX_FLOAT = 0,  ///< 3 floats of a position, 3 of a normal, 4 of a tangent
  SINEW_VERTEX_16_BIT = 1  ///< 3 uint16_t of a position: 0 and 65535 are the sides of the box. 2 int16_t of a normal
                           ///< and 3 of a tangent: octahedral x and y, then the handedness; 32767 is 1
} sinew_vertex_format;
/// Vertices of the engine, for example in an interleaved buffer.
typedef struct sinew_vertex_buffer {
  size_t struct_size;
  uint32_t format;         ///< a value of sinew_vertex_format
  size_t vertex_count;     ///< vertices that there is room for
  void* positions;         ///< of the first vertex; null = not written, also below
  size_t position_stride;  ///< bytes from one vertex to the next, also below
  void* normals;
  size_t normal_stride;
  void* tangents;
  size_t tangent_stride;
  sinew_box box;  ///< 16-bit positions only; positions outside of it are moved to its sides
} sinew_vertex_buffer;
/// Copies the vertices of a shape to a buffer of the engine. 16-bit positions are off by at most 0.51 / 65535 of the
/// side of the box and the rounding of float, directions by 7e-5 radians.
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (shape), SINEW_WRONG_STRUCT_SIZE, SINEW_SIZE_MISMATCH
///      (vertex_count; strides below the size of an attribute), SINEW_NOT_FINITE (box; also an empty one),
///      SINEW_UNSUPPORTED (format; an attribute that the shape does not have)
SINEW_API sinew_error sinew_write_shape(const sinew_result* result, uint32_t shape, const sinew_vertex_buffer* to);

#ifdef __cplusplus
}
#endif
