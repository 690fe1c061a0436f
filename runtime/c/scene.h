// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Everything of one file: joints, clips, meshes. Made by the importer, or by C++ code (runtime/c/handles.h). Only
/// sinew_clips_load and sinew_assets_add_clips change it. For a null scene or an index out of range, functions return
/// empty strings and spans, SINEW_NONE or 0.
typedef struct sinew_scene sinew_scene;

/// Destroys a scene. Destroy its plans first.
SINEW_API void sinew_scene_destroy(sinew_scene* scene);

// Joints: every node of the file is a joint; parents come before children.
SINEW_API size_t sinew_joint_count(const sinew_scene* scene);
SINEW_API sinew_string sinew_joint_name(const sinew_scene* scene, uint32_t joint);
SINEW_API uint32_t sinew_joint_parent(const sinew_scene* scene, uint32_t joint);  ///< SINEW_NONE = root
SINEW_API uint32_t sinew_find_joint(const sinew_scene* scene,
                                    const char* name);  ///< first of that name, SINEW_NONE = none

// Clips.
SINEW_API size_t sinew_clip_count(const sinew_scene* scene);
SINEW_API sinew_string sinew_clip_name(const sinew_scene* scene, uint32_t clip);
SINEW_API double sinew_clip_duration_s(const sinew_scene* scene, uint32_t clip);
SINEW_API uint32_t sinew_find_clip(const sinew_scene* scene, const char* name);

// Events and curves of a clip, which engines read beside the pose.
SINEW_API sinew_doubles sinew_clip_event_times(const sinew_scene* scene, uint32_t clip);  ///< for sinew_crossed_events
SINEW_API sinew_string sinew_clip_event_name(const sinew_scene* scene, uint32_t clip, uint32_t event);
SINEW_API size_t sinew_clip_curve_count(const sinew_scene* scene, uint32_t clip);
SINEW_API sinew_string sinew_clip_curve_name(const sinew_scene* scene, uint32_t clip, uint32_t curve);
/// Samples a curve. Before the first and after the last key it has their value; NaN gives the first.
/// out  value[4]  1 to 4 numbers; a rotation is x y z w, a flag 0 or 1; the others stay as they are
/// Returns how many numbers the curve has; 0 for null pointers and indices out of range.     cost O(log keys)
SINEW_API size_t sinew_clip_curve_value(const sinew_scene* scene, uint32_t clip, uint32_t curve, double time_s,
                                        float* value);

// Skins.
SINEW_API size_t sinew_skin_count(const sinew_scene* scene);
SINEW_API sinew_indices sinew_skin_joints(const sinew_scene* scene, uint32_t skin);

// Meshes and their instances.
SINEW_API size_t sinew_mesh_count(const sinew_scene* scene);
SINEW_API sinew_string sinew_mesh_name(const sinew_scene* scene, uint32_t mesh);
SINEW_API uint32_t sinew_find_mesh(const sinew_scene* scene, const char* name);
SINEW_API size_t sinew_primitive_count(const sinew_scene* scene, uint32_t mesh);
SINEW_API size_t sinew_target_count(const sinew_scene* scene, uint32_t mesh);  ///< number of morph targets
SINEW_API sinew_string sinew_target_name(const sinew_scene* scene, uint32_t mesh, uint32_t target);

/// A mesh attached to a joint. Each frame gives one sinew_instance_result for it.
typedef struct sinew_instance {
  size_t struct_size;
  uint32_t joint, mesh, skin;           ///< skin SINEW_NONE = rigid
  uint32_t first_weight, weight_count;  ///< place of its morph weights in the flat array of all morph weights
} sinew_instance;

SINEW_API size_t sinew_instance_count(const sinew_scene* scene);
SINEW_API size_t sinew_weight_count(const sinew_scene* scene);
/// Describes a mesh instance.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE
SINEW_API sinew_error sinew_get_instance(const sinew_scene* scene, uint32_t instance, sinew_instance* out);

typedef enum sinew_topology { SINEW_POINTS = 0, SINEW_LINES = 1, SINEW_TRIANGLES = 2 } sinew_topology;

/// One draw call of a mesh in its rest shape. Absent attributes are empty; others have one entry per vertex.
typedef struct sinew_primitive {
  size_t struct_size;
  uint32_t topology;      ///< a value of sinew_topology
  uint32_t material;      ///< index of the material in the file; SINEW_NONE = none
  sinew_indices indices;  ///< 1, 2 or 3 per point, line or triangle
  sinew_vec3s positions, normals;
  sinew_vec4s tangents, colors;
  size_t texcoord_count;  ///< number of texture coordinate sets
} sinew_primitive;

/// Describes a primitive of a mesh.
/// err  as sinew_get_instance
SINEW_API sinew_error sinew_get_primitive(const sinew_scene* scene, uint32_t mesh, uint32_t primitive,
                                          sinew_primitive* out);
SINEW_API sinew_vec2s sinew_primitive_texcoords(const sinew_scene* scene, uint32_t mesh, uint32_t primitive,
                                                uint32_t set);

/// Influences of a vertex for engines that skin vertices themselves: `count` joints of the skin with their weights,
/// which sum to 1.
typedef struct sinew_influences {
  const uint16_t* joints;  ///< [count] index into sinew_skin_joints
  const float* weights;    ///< [count] in descending order, summing to 1
  size_t count;            ///< 0 = the primitive is not skinned
} sinew_influences;
SINEW_API sinew_influences sinew_vertex_influences(const sinew_scene* scene, uint32_t mesh, uint32_t primitive,
                                                   uint32_t vertex);

#ifdef __cplusplus
}
#endif
