// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/messages.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Options of an import, and limits on size.
typedef struct sinew_import_options {
  size_t struct_size;
  uint32_t decode_images;             ///< 1 or 0
  uint32_t make_normals;              ///< make flat normals where triangles have none
  uint32_t make_tangents;             ///< make tangents where a normal map needs them
  uint32_t make_centers_of_rotation;  ///< needed for SINEW_SKIN_CENTER_OF_ROTATION; may take seconds
  uint64_t max_file_bytes;
  uint64_t max_unpacked_bytes;
} sinew_import_options;
sinew_import_options sinew_default_import_options(void);

/// Reads a .gltf or .glb file with its buffers and images.
/// in   path      UTF-8;   options  null = the defaults
/// out  scene     owned by the caller
///      messages  owned by the caller: errors, then warnings; filled even if the file is refused; null = not wanted
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_BAD_FILE, SINEW_OUT_OF_MEMORY
sinew_error sinew_import_file(const char* path, const sinew_import_options* options, sinew_scene** scene,
                              sinew_messages** messages);

/// Imports a file from memory: a whole .glb, or .gltf text whose buffers are data URIs. Messages use `name` as the
/// file's name.
sinew_error sinew_import_memory(const void* bytes, size_t byte_count, const char* name,
                                const sinew_import_options* options, sinew_scene** scene, sinew_messages** messages);

#ifdef __cplusplus
}
#endif
