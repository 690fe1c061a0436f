// SPDX-License-Identifier: MIT
#include "importer/tool/assets/asset_parts.h"

#include <utility>

namespace sinew::tool {

tl::expected<AssetParts, AssetFileError> asset_parts(std::span<const std::byte> bytes) {
  auto file = AssetFile::open(bytes);
  if (!file) return tl::unexpected(file.error());
  if (const auto sums = file->check_sums(); !sums) return tl::unexpected(sums.error());
  AssetParts parts{*std::move(file), std::nullopt, {}, {}, {}};
  auto graphs = read_graphs(parts.file);
  if (!graphs) return tl::unexpected(graphs.error());
  parts.graphs = *std::move(graphs);
  if (parts.file.find(AssetKind::skeleton) != nullptr) {
    auto scene = read_scene(parts.file);
    if (!scene) return tl::unexpected(scene.error());
    if (const auto boxes = read_clip_boxes(parts.file, *scene); !boxes) return tl::unexpected(boxes.error());
    auto lods = read_skeleton_lods(parts.file, scene->skeleton);
    if (!lods) return tl::unexpected(lods.error());
    parts.lods = *std::move(lods);
    parts.clips = scene->clips;
    parts.scene = *std::move(scene);
  } else if (const AssetBlock* block = parts.file.find(AssetKind::clips)) {
    auto clips = read_clips(parts.file, block->skeleton_signature);
    if (!clips) return tl::unexpected(clips.error());
    parts.clips = *std::move(clips);
  }
  return parts;
}

}  // namespace sinew::tool
