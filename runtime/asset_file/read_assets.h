// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/asset_file/asset_file.h"
#include "runtime/model/mesh.h"
#include "runtime/model/scene.h"
#include "runtime/model/skeleton_lod.h"

namespace sinew {

// What these functions answer owns its memory, and the file may be unmapped afterwards: arrays are copied once, at the
// speed of memory, because assets are vectors; compiled clips become lanes for this machine's instruction set. Any
// bytes may be passed: every index, count and float is checked here, once, and memory stays below 16 MiB and a small
// multiple of kAssetMadeTimes the file.

/// What is read of clips that lie in pages (`AssetFileOptions::page_s`).
enum class LongClips : std::uint8_t {
  joined,      ///< all keys
  first_keys,  ///< the first key of each track; a PagedClip (paging/paged_clip.h) plays the pages, as
               ///< read_page_tables (read_pages.h) finds them. Animations that are made of such clips stand still
};

/// The skeleton of a file.
/// err   AssetFileError;  cost O(bytes of the block), allocates
tl::expected<Skeleton, AssetFileError> read_skeleton(const AssetFile& file);

/// The clips of a file, for a skeleton of this signature (animation/skeleton_signature.h). They sample the same bits as
/// those that were written.
/// err   AssetFileError, asset-signature where they were compiled for another skeleton
/// cost  O(bytes of the block), allocates
tl::expected<std::vector<Clip>, AssetFileError> read_clips(const AssetFile& file, std::uint64_t skeleton_signature,
                                                           LongClips long_clips = LongClips::joined);

/// Skeleton, model and clips of a file as a scene that passes check(Scene); a file without model or clips gives a scene
/// without them. `animations` are those of the file where it has them, else the keys of the clips
/// (clip/decompile_clip.h): root motion, bounds and LODs that are derived from them are right for what the clips play.
/// err   AssetFileError;  cost O(bytes), allocates
tl::expected<Scene, AssetFileError> read_scene(const AssetFile& file, LongClips long_clips = LongClips::joined);

/// Appends the clips of a file, with their animations as read_scene has them, to a scene of the same skeleton.
/// err   AssetFileError: asset-signature (another skeleton), asset-binding (the clips move other morph weights or
///       properties than the scene has); the scene is then as before
/// cost  O(bytes of the blocks), allocates
tl::expected<void, AssetFileError> add_clips(const AssetFile& file, Scene& scene,
                                             LongClips long_clips = LongClips::joined);

/// Where the meshes of read_scene(file) are while its clips play, for clip_bounds (lod/clip_bounds.h); nothing where
/// the file does not say, as those of before.
/// in    scene  of this file; clips of others may have been added
/// err   AssetFileError;  cost O(clips * instances), allocates
tl::expected<ClipBoxes, AssetFileError> read_clip_boxes(const AssetFile& file, const Scene& scene);

/// The skeleton LODs of a file in the order in which they were written, for Needs::skeleton_lod of any plan with linear
/// or rigid skinning, and what they cost; nothing where it has none. They were found in the keys of whole clips: scenes
/// of first keys (LongClips::first_keys) have no others.
/// in    skeleton  of this file, or of the same signature
/// err   AssetFileError;  cost O(levels * joints), allocates
tl::expected<std::vector<CompiledSkeletonLod>, AssetFileError> read_skeleton_lods(const AssetFile& file,
                                                                                  const Skeleton& skeleton);

}  // namespace sinew
