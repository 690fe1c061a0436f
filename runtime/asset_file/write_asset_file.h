// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/model/skeleton_lod.h"

namespace sinew {

/// Which blocks a file gets, and how they are stored.
struct AssetFileOptions {
  bool skeleton = true, model = true, clips = true;
  /// Also the authoring form of the clips. Without it a reader makes one of the keys of the compiled clips
  /// (read_assets.h), which takes less room and is as far from the truth as the clips' certificates say.
  bool truth = false;
  /// Of the scene's clips (clip_boxes of lod/clip_bounds.h). They are written with model and clips.
  std::span<const std::vector<Aabb>> clip_boxes = {};
  /// Of the scene's skeleton (lod/compile_skeleton_lod.h).
  std::span<const CompiledSkeletonLod> skeleton_lods = {};
  /// Clips longer than this are written in pages of this many seconds (read_pages.h), so that an engine can play them
  /// from a bounded part of the file; 0 = none are. Each page is packed by itself (unpack_page).
  double page_s = 0.0;
  int zstd_level = 0;  ///< 0 = blocks lie as they are; 1 to 19 pack those that get smaller
};

/// An asset file (asset_file.h) of a scene: every field of what it holds, to the last bit. Clips are written as they
/// are: put those of compile_clip_within in their place for small files, and leave `animations` as the truth.
/// in    scene  passed check(Scene)
/// cost  O(bytes), allocates about twice the file
std::vector<std::byte> write_asset_file(const Scene& scene, const AssetFileOptions& options = {});

}  // namespace sinew
