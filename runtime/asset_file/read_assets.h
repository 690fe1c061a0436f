// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/asset_file/asset_file.h"
#include "runtime/asset_file/stored_graph.h"
#include "runtime/base/api.h"
#include "runtime/model/mesh.h"
#include "runtime/model/scene.h"
#include "runtime/model/skeleton_lod.h"

namespace sinew {

// The results own their memory, so the file may be unmapped afterwards. Arrays are copied once, because assets are
// vectors. Compiled clips are rearranged for this machine's vector width. Any bytes may be passed: every index, count
// and float is checked here once. Memory stays below 16 MiB plus a small multiple of kAssetMadeTimes times the size of
// the file.

/// How clips that lie in pages (`AssetFileOptions::page_s`) are read.
enum class LongClips : std::uint8_t {
  joined,  ///< all keys of all pages are read
  /// With only the first key of each track; animations made from such clips stand still. A PagedClip
  /// (paging/paged_clip.h) plays the pages; read_page_tables (read_pages.h) finds them.
  first_keys,
};

/// Reads the skeleton of a file.
/// err   AssetFileError;  cost O(bytes of the block), allocates
SINEW_API tl::expected<Skeleton, AssetFileError> read_skeleton(const AssetFile& file);

/// Reads the clips of a file for a skeleton of this signature (animation/skeleton_signature.h). They sample to the same
/// bits as the clips that were written.
/// err   AssetFileError, asset-signature if they were compiled for another skeleton
/// cost  O(bytes of the block), allocates
SINEW_API tl::expected<std::vector<Clip>, AssetFileError> read_clips(const AssetFile& file,
                                                                     std::uint64_t skeleton_signature,
                                                                     LongClips long_clips = LongClips::joined);

/// Reads skeleton, model and clips as a scene that passes check(Scene); model and clips may be absent. Its `animations`
/// are those of the file, or else are made from the keys of the clips (clip/decompile_clip.h). Root motion, bounds and
/// LODs derived from them therefore fit what the clips play.
/// err   AssetFileError;  cost O(bytes), allocates
SINEW_API tl::expected<Scene, AssetFileError> read_scene(const AssetFile& file,
                                                         LongClips long_clips = LongClips::joined);

/// Appends the clips of a file to a scene of the same skeleton, with their animations as in read_scene.
/// err   AssetFileError: asset-signature (another skeleton), asset-binding (the clips move other morph weights or
///       properties than the scene has); the scene is then unchanged
/// cost  O(bytes of the blocks), allocates
SINEW_API tl::expected<void, AssetFileError> add_clips(const AssetFile& file, Scene& scene,
                                                       LongClips long_clips = LongClips::joined);

/// Reads the stored bounds of the file's meshes under each of its clips, for clip_bounds (lod/clip_bounds.h). Empty if
/// the file has none, like files of older versions.
/// in    scene  read from this file; clips of other files may have been added
/// err   AssetFileError;  cost O(clips * instances), allocates
SINEW_API tl::expected<ClipBoxes, AssetFileError> read_clip_boxes(const AssetFile& file, const Scene& scene);

/// Reads the skeleton LODs of a file in the order of writing, for Needs::out.skeleton_lod of plans with linear or rigid
/// skinning. Empty if the file has none. compile_skeleton_lod can find LODs only in whole clips. Scenes that were read
/// with LongClips::first_keys therefore depend on these stored LODs.
/// in    skeleton  of this file, or of the same signature
/// err   AssetFileError;  cost O(levels * joints), allocates
SINEW_API tl::expected<std::vector<CompiledSkeletonLod>, AssetFileError> read_skeleton_lods(const AssetFile& file,
                                                                                            const Skeleton& skeleton);

/// Reads the motion graphs of a file, in the order of writing. read_graph_bytes (graph/graph_bytes.h) checks each.
/// Empty if the file has none.
/// err   AssetFileError; asset-value if two graphs have one name;  cost O(bytes of the block), allocates
SINEW_API tl::expected<std::vector<StoredGraph>, AssetFileError> read_graphs(const AssetFile& file);

}  // namespace sinew
