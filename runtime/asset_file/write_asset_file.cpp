// SPDX-License-Identifier: MIT
#include "runtime/asset_file/write_asset_file.h"

#include <zstd.h>

#include <utility>

#include "runtime/animation/skeleton_signature.h"
#include "runtime/asset_file/asset_fields.h"
#include "runtime/asset_file/asset_file.h"
#include "runtime/asset_file/asset_writer.h"
#include "runtime/asset_file/look_fields.h"
#include "runtime/base/checksum.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/clip/clip_file.h"
#include "runtime/model/mesh.h"
#include "runtime/paging/cut_clip.h"

namespace sinew {
namespace {

using Bytes = std::vector<std::byte>;

struct Block {
  AssetKind kind{};
  Bytes stored;
  std::uint64_t bytes = 0;  ///< unpacked size
  std::uint32_t storage = 0;
};

/// Packs bytes; empty if that does not make them smaller. Also empty if they get so small that a reader would refuse
/// them as a decompression bomb.
Bytes packed(const Bytes& bytes, int zstd_level) {
  if (zstd_level <= 0) return {};
  Bytes packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), zstd_level);
  if (ZSTD_isError(size) != 0u || size >= bytes.size() || bytes.size() / size >= kAssetMadeTimes) return {};
  packed.resize(size);
  return packed;
}

Block block_of(AssetKind kind, Bytes bytes, int zstd_level) {
  const std::uint64_t size = bytes.size();
  Bytes smaller = packed(bytes, zstd_level);
  if (smaller.empty()) return {kind, std::move(bytes), size};
  return {kind, std::move(smaller), size, kPackedByZstd};
}

template <class T>
Bytes bytes_of(const T& asset) {
  AssetWriter out;
  out.add(asset);
  return std::move(out.bytes());
}

Bytes bytes_of_graphs(std::span<const StoredGraph> graphs) {
  AssetWriter out;
  out.add(static_cast<std::uint64_t>(graphs.size()));
  for (const StoredGraph& graph : graphs) {
    out.add(graph.name);
    out.add(graph.bytes);
  }
  return std::move(out.bytes());
}

Bytes bytes_of_lods(std::span<const CompiledSkeletonLod> lods) {
  std::vector<StoredSkeletonLod> stored;
  for (const CompiledSkeletonLod& lod : lods) stored.push_back({lod, {lod.detail.kept.begin(), lod.detail.kept.end()}});
  return bytes_of(stored);
}

Bytes bytes_of_model(const Scene& scene) {
  AssetWriter out;
  std::apply([&](const auto&... field) { (out.add(field), ...); }, model_fields(scene));
  return std::move(out.bytes());
}

Bytes bytes_of_clips(const std::vector<Clip>& clips) {
  std::vector<const Clip*> saved;
  for (const Clip& clip : clips) saved.push_back(&clip);
  return save_clips(saved);
}

/// The clips of a scene. Long clips keep only their first keys; their other keys are in pages.
struct PagedClips {
  std::vector<Clip> clips;
  std::vector<PageTable> tables;  ///< empty if no clip is long
  Bytes keys;
};

PageTable write_pages(const Clip& clip, double page_s, int zstd_level, Bytes& keys) {
  PageTable table{page_s, {keys.size()}};
  for (std::size_t page = 0; page < page_count_of(clip.duration_s(), page_s); ++page) {
    const Clip cut = cut_page(clip, page_s, page);
    const Clip* const saved[] = {&cut};
    const Bytes bytes = save_clips(saved), smaller = packed(bytes, zstd_level);
    const Bytes& stored = smaller.empty() ? bytes : smaller;
    keys.insert(keys.end(), stored.begin(), stored.end());
    table.offsets.push_back(keys.size());
  }
  return table;
}

PagedClips paged(const std::vector<Clip>& clips, const AssetFileOptions& options) {
  const double page_s = options.page_s;
  PagedClips paged{clips, {}, {}};
  for (std::size_t c = 0; c < clips.size(); ++c) {
    if (page_s <= 0.0 || clips[c].duration_s() <= page_s) continue;
    paged.tables.resize(clips.size());
    paged.tables[c] = write_pages(clips[c], page_s, options.zstd_level, paged.keys);
    paged.clips[c] = first_keys(clips[c]);
  }
  return paged;
}

std::uint64_t aligned(std::uint64_t at) noexcept {
  return (at + kAssetAlignment - 1) / kAssetAlignment * kAssetAlignment;
}

void write_table(const std::vector<Block>& blocks, std::uint64_t signature, ByteWriter& out) {
  std::uint64_t at = kAssetHead + blocks.size() * kAssetEntry;
  for (const Block& block : blocks) {
    at = aligned(at);
    for (const std::uint32_t x : {static_cast<std::uint32_t>(block.kind), kAssetBlockVersion, block.storage, 0u})
      out.add(x);
    for (const std::uint64_t x : {at, static_cast<std::uint64_t>(block.stored.size()), block.bytes,
                                  checksum(block.stored), signature, std::uint64_t{0}})
      out.add(x);
    at += block.stored.size();
  }
}

Bytes file_of(const std::vector<Block>& blocks, std::uint64_t signature) {
  ByteWriter table;
  write_table(blocks, signature, table);
  std::uint64_t size = kAssetHead + table.bytes().size();
  for (const Block& block : blocks) size = aligned(size) + block.stored.size();
  ByteWriter out;
  out.bytes().reserve(size);
  for (const char c : kAssetMagic) out.add(c);
  out.add(kAssetFileVersion);
  out.add(static_cast<std::uint32_t>(blocks.size()));
  out.add(size);
  out.add(checksum(table.bytes()));
  Bytes& file = out.bytes();
  file.insert(file.end(), table.bytes().begin(), table.bytes().end());
  for (const Block& block : blocks) {
    file.resize(aligned(file.size()));
    file.insert(file.end(), block.stored.begin(), block.stored.end());
  }
  return std::move(file);
}

}  // namespace

std::vector<std::byte> write_asset_file(const Scene& scene, const AssetFileOptions& options) {
  std::vector<Block> blocks;
  const auto add = [&](AssetKind kind, Bytes bytes) {
    blocks.push_back(block_of(kind, std::move(bytes), options.zstd_level));
  };
  if (options.skeleton) add(AssetKind::skeleton, bytes_of(scene.skeleton));
  if (options.model) add(AssetKind::model, bytes_of_model(scene));
  if (options.clips) {
    PagedClips clips = paged(scene.clips, options);
    add(AssetKind::clips, bytes_of_clips(clips.clips));
    if (!clips.tables.empty()) {
      add(AssetKind::pages, bytes_of(clips.tables));
      blocks.push_back(block_of(AssetKind::page_keys, std::move(clips.keys), 0));
    }
  }
  if (options.clips && options.truth) add(AssetKind::animations, bytes_of(scene.animations));
  if (options.model && options.clips && !options.clip_boxes.empty())
    add(AssetKind::bounds, bytes_of(ClipBoxes(options.clip_boxes.begin(), options.clip_boxes.end())));
  if (!options.skeleton_lods.empty()) add(AssetKind::skeleton_lods, bytes_of_lods(options.skeleton_lods));
  if (!options.graphs.empty()) add(AssetKind::graphs, bytes_of_graphs(options.graphs));
  return file_of(blocks, skeleton_signature(scene.skeleton));
}

}  // namespace sinew
