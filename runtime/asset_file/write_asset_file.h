// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/asset_file/stored_graph.h"
#include "runtime/base/api.h"
#include "runtime/model/scene.h"
#include "runtime/model/skeleton_lod.h"

namespace sinew {

/// Which blocks a file gets, and how they are stored.
struct AssetFileOptions {
  bool skeleton = true, model = true, clips = true;
  /// Writes the authoring form of the clips too. Without it a reader makes one from the keys of the compiled clips
  /// (read_assets.h). That file is smaller, and the animations are as accurate as the clips' certificates say.
  bool truth = false;
  /// Bounds of the scene's clips (clip_boxes in lod/clip_bounds.h). Written only together with model and clips.
  std::span<const std::vector<Aabb>> clip_boxes = {};
  /// Skeleton LODs of the scene (lod/compile_skeleton_lod.h).
  std::span<const CompiledSkeletonLod> skeleton_lods = {};
  /// Motion graphs, with names that differ.
  std::span<const StoredGraph> graphs = {};
  /// Clips longer than this are written in pages of this many seconds (read_pages.h), so that an engine need not load
  /// all of a long clip. 0 = no pages. Each page is packed by itself (unpack_page).
  double page_s = 0.0;
  int zstd_level = 0;  ///< 0 = nothing is packed; 1 to 19 pack the blocks that get smaller
};

/// Writes a scene as an asset file (asset_file.h). Every stored field keeps its bits. Clips are written as they are:
/// for a small file, first replace Scene::clips by those of compile_clip_within. Scene::animations need not change.
/// in    scene  must have passed check(Scene)
/// cost  O(bytes), allocates about twice the size of the file
SINEW_API std::vector<std::byte> write_asset_file(const Scene& scene, const AssetFileOptions& options = {});

}  // namespace sinew
