// SPDX-License-Identifier: MIT
#pragma once
// Geometry caches (.sgeo) for engines that speak C. Link sinew::c_geometry beside sinew::c. For C and C++.
#include "runtime/base/api.h"
#include "runtime/c/frame.h"
#include "runtime/c/messages.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The tables of a geometry cache: its meshes, its streams and the positions of its frames. If the whole file is in
/// memory, players read the frames from there.
typedef struct sinew_geometry_cache sinew_geometry_cache;

/// Bytes from the start of a file that sinew_geometry_open needs. 0 if byte_count is too small to tell (40 are enough),
/// or if the bytes are no geometry cache.
SINEW_API uint64_t sinew_geometry_head_bytes(const void* start, size_t byte_count);

/// Opens a geometry cache.
/// in   bytes       the whole file, which must outlive the cache and its players; or only its head, for players with a
///      reader
///      file_bytes  size of the whole file
/// out  messages  why the file was refused; null = not wanted
/// err  SINEW_NULL_ARGUMENT, SINEW_BAD_FILE, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_geometry_open(const void* bytes, size_t byte_count, uint64_t file_bytes,
                                          sinew_geometry_cache** out, sinew_messages** messages);
/// Destroys a cache. Destroy its players first.
SINEW_API void sinew_geometry_close(sinew_geometry_cache* cache);

typedef struct sinew_geometry_info {
  size_t struct_size;
  uint32_t mesh_count, frame_count;
  uint32_t segment_frames;       ///< most frames that a seek decodes
  double start_s, duration_s;    ///< time of the first frame, and from it to the last
  double frame_s;                ///< seconds from one frame to the next
  uint64_t largest_frame_bytes;  ///< a player with a reader needs memory for window_frames times this
} sinew_geometry_info;
SINEW_API sinew_error sinew_geometry_get_info(const sinew_geometry_cache* cache, sinew_geometry_info* out);

typedef struct sinew_geometry_mesh {
  size_t struct_size;
  sinew_string name;
  uint32_t vertex_count, triangle_count;
  sinew_box bounds;            ///< box around the mesh in all frames
  double asked_m, measured_m;  ///< largest allowed and largest measured distance of a decoded vertex from its place
} sinew_geometry_mesh;
/// Describes a mesh of the cache.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE
SINEW_API sinew_error sinew_geometry_get_mesh(const sinew_geometry_cache* cache, uint32_t mesh,
                                              sinew_geometry_mesh* out);

/// A read that was requested from the engine and has not finished yet.
typedef struct sinew_frame_read sinew_frame_read;
/// Ends a pending read. ok = 1: the bytes have arrived; 0: they could not be read, and the player requests them again
/// when it needs them. Call it once for each pending read, from any thread.
SINEW_API void sinew_frame_read_finish(sinew_frame_read* read, int ok);

typedef enum sinew_read_outcome {
  SINEW_READ_DONE = 0,     ///< the bytes have arrived
  SINEW_READ_PENDING = 1,  ///< sinew_frame_read_finish will be called later
  SINEW_READ_FAILED = 2    ///< the player asks again when it needs the frame
} sinew_read_outcome;

/// How the engine reads a file. Several players may share one function, each with its own context.
typedef struct sinew_frame_reader {
  /// Reads into[byte_count] from `offset` of the file, now or later. Called on the thread that runs the frame.
  sinew_read_outcome (*read)(void* context, uint64_t offset, void* into, size_t byte_count, sinew_frame_read* read);
  void* context;
} sinew_frame_reader;

/// Makes a scene from the cache alone: for each of its meshes a node, a mesh and an instance. The rest shape is that of
/// the first frame.
/// in   reader  must read at once; null = the whole file is in memory
/// err  SINEW_NULL_ARGUMENT, SINEW_BAD_FILE (the first frame is damaged or not loaded), SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_geometry_scene(const sinew_geometry_cache* cache, const sinew_frame_reader* reader,
                                           sinew_scene** out);

/// The mesh of a cache that a primitive of a mesh instance takes its vertices from. This struct never grows.
typedef struct sinew_geometry_binding {
  uint32_t instance, primitive, mesh;
} sinew_geometry_binding;

typedef struct sinew_geometry_player_options {
  size_t struct_size;
  const sinew_geometry_binding* bindings;  ///< null = meshes bind by the names that `sinew bake` writes
  size_t binding_count;
  uint32_t in_mesh_space;  ///< 1: vertices are in the mesh's own space, as point caches are; 0: below the frame's root
  uint32_t window_frames;  ///< with a reader: number of frames that are loaded ahead
  sinew_frame_reader reader;  ///< read = null: the whole file is in memory
} sinew_geometry_player_options;
/// Defaults: meshes bind by name, vertices in the scene's space, file in memory, 16 frames; struct_size is set.
SINEW_API sinew_geometry_player_options sinew_default_geometry_player_options(void);

/// Plays a cache in the mesh instances of one character. A frame of that character decodes into it: nothing else may
/// use it while the frame runs.
typedef struct sinew_geometry_player sinew_geometry_player;

/// Creates a player.
/// in   cache    must outlive the player;   scene  is not kept;   options  null = the defaults
/// out  unbound  a sentence for each mesh and instance that does not play; null = not wanted
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE (no such instance, primitive or mesh),
///      SINEW_SIZE_MISMATCH (other triangles or vertices), SINEW_UNSUPPORTED (an instance of which only some primitives
///      are bound; nothing plays; no frame in the window; no reader and only the head of the file), SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_geometry_player_create(const sinew_geometry_cache* cache, const sinew_scene* scene,
                                                   const sinew_geometry_player_options* options,
                                                   sinew_geometry_player** out, sinew_messages** unbound);
/// Destroys a player. Every read must have finished.
SINEW_API void sinew_geometry_player_destroy(sinew_geometry_player* player);

/// Mesh instances that the player moves, rising: for sinew_needs.cached_instances.
SINEW_API sinew_indices sinew_geometry_player_instances(const sinew_geometry_player* player);
/// The player's source for sinew_geometry_input.source; all zero if `player` is null.
SINEW_API sinew_vertex_source sinew_geometry_player_source(sinew_geometry_player* player);

/// A box that contains the vertices of an instance at one time, in the space of the cache. Nothing is decoded, so use
/// it for culling.
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_FINITE, SINEW_INDEX_OUT_OF_RANGE
SINEW_API sinew_error sinew_geometry_player_bounds(const sinew_geometry_player* player, uint32_t instance,
                                                   double time_s, sinew_box* out);

typedef struct sinew_geometry_work {
  size_t struct_size;
  uint64_t frames_decoded;  ///< number of frames since the player was made
  uint64_t bytes_asked;     ///< bytes requested from the reader since the player was made
  uint64_t memory_bytes;    ///< memory of the decoder and the window
  size_t pending_reads;
} sinew_geometry_work;
SINEW_API sinew_error sinew_geometry_player_work(const sinew_geometry_player* player, sinew_geometry_work* out);

#ifdef __cplusplus
}
#endif
