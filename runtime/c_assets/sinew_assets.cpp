// SPDX-License-Identifier: MIT
#include "runtime/c_assets/sinew_assets.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/read_pages.h"
#include "runtime/c/glue/call.h"
#include "runtime/c/glue/write_messages.h"
#include "runtime/c/handles.h"

using namespace sinew;

namespace {

std::span<const std::byte> span_of(const void* bytes, std::size_t byte_count) noexcept {
  return {static_cast<const std::byte*>(bytes), byte_count};
}

sinew_error refuse(const AssetFileError& error, sinew_messages** messages) {
  return c::bad_file(describe(error), messages);
}

struct ReadFile {
  std::unique_ptr<sinew_scene> scene;
  std::vector<PageTable> tables;
};

tl::expected<ReadFile, AssetFileError> read_file(std::span<const std::byte> bytes, LongClips long_clips) {
  const auto file = AssetFile::open(bytes);
  if (!file) return tl::unexpected(file.error());
  auto scene = read_scene(*file, long_clips);
  if (!scene) return tl::unexpected(scene.error());
  auto boxes = read_clip_boxes(*file, *scene);
  if (!boxes) return tl::unexpected(boxes.error());
  auto tables = read_page_tables(*file);
  if (!tables) return tl::unexpected(tables.error());
  return ReadFile{std::unique_ptr<sinew_scene>(new sinew_scene{*std::move(scene), {}, *std::move(boxes)}),
                  *std::move(tables)};
}

}  // namespace

struct sinew_page_tables {
  std::vector<PageTable> clips;
};

int sinew_looks_like_assets(const void* bytes, std::size_t byte_count) {
  return bytes != nullptr && looks_like_asset_file(span_of(bytes, byte_count));
}

sinew_error sinew_assets_read(const void* bytes, std::size_t byte_count, sinew_scene** scene,
                              sinew_messages** messages) {
  return c::call(c::given(bytes, scene), [&] {
    auto read = read_file(span_of(bytes, byte_count), LongClips::joined);
    if (!read) return refuse(read.error(), messages);
    *scene = read->scene.release();
    return SINEW_OK;
  });
}

sinew_error sinew_assets_read_first_keys(const void* bytes, std::size_t byte_count, sinew_scene** scene,
                                         sinew_page_tables** tables, sinew_messages** messages) {
  return c::call(c::given(bytes, scene, tables), [&] {
    auto read = read_file(span_of(bytes, byte_count), LongClips::first_keys);
    if (!read) return refuse(read.error(), messages);
    *tables = new sinew_page_tables{std::move(read->tables)};
    *scene = read->scene.release();
    return SINEW_OK;
  });
}

void sinew_page_tables_destroy(sinew_page_tables* tables) { delete tables; }

std::size_t sinew_page_tables_count(const sinew_page_tables* tables, std::uint32_t clip, double* page_s) {
  const bool is_there = tables != nullptr && clip < tables->clips.size();
  if (page_s != nullptr) *page_s = is_there ? tables->clips[clip].page_s : 0.0;
  return is_there ? tables->clips[clip].page_count() : 0;
}

std::size_t sinew_page_tables_place(const sinew_page_tables* tables, std::uint32_t clip, std::size_t page,
                                    std::uint64_t* offset) {
  const bool is_there = page < sinew_page_tables_count(tables, clip, nullptr);
  if (offset != nullptr) *offset = is_there ? tables->clips[clip].offsets[page] : 0;
  return is_there ? tables->clips[clip].offsets[page + 1] - tables->clips[clip].offsets[page] : 0;
}

sinew_error sinew_assets_load_page(sinew_paged_clip* paged, std::size_t page, const void* bytes, std::size_t byte_count,
                                   int* taken, sinew_messages** messages) {
  return c::call(c::given(paged, bytes), [&] {
    std::vector<std::byte> unpacked;
    const auto stored = unpack_page(span_of(bytes, byte_count), unpacked);
    if (!stored) return refuse(stored.error(), messages);
    return sinew_paged_clip_load_page(paged, page, stored->data(), stored->size(), taken, messages);
  });
}

sinew_error sinew_assets_read_skeleton_lod(const void* bytes, std::size_t byte_count, const sinew_scene* scene,
                                           std::size_t level, sinew_skeleton_lod** out, sinew_messages** messages) {
  return c::call(c::given(bytes, scene, out), [&] {
    const auto file = AssetFile::open(span_of(bytes, byte_count));
    if (!file) return refuse(file.error(), messages);
    auto lods = read_skeleton_lods(*file, scene->scene.skeleton);
    if (!lods) return refuse(lods.error(), messages);
    if (level >= lods->size()) return SINEW_INDEX_OUT_OF_RANGE;
    *out = new sinew_skeleton_lod(std::move((*lods)[level]));
    return SINEW_OK;
  });
}

sinew_error sinew_assets_add_clips(sinew_scene* scene, const void* bytes, std::size_t byte_count,
                                   sinew_messages** messages) {
  return c::call(c::given(scene, bytes), [&] {
    if (scene->plan_count != 0) return SINEW_BUSY;
    const auto file = AssetFile::open(span_of(bytes, byte_count));
    if (!file) return refuse(file.error(), messages);
    const auto added = add_clips(*file, scene->scene);
    return added ? SINEW_OK : refuse(added.error(), messages);
  });
}

sinew_error sinew_assets_read_graph(const void* bytes, std::size_t byte_count, const char* name, sinew_graph** out,
                                    sinew_messages** messages) {
  return c::call(c::given(bytes, name, out), [&] {
    const auto file = AssetFile::open(span_of(bytes, byte_count));
    if (!file) return refuse(file.error(), messages);
    const auto graphs = read_graphs(*file);
    if (!graphs) return refuse(graphs.error(), messages);
    const auto graph =
        std::find_if(graphs->begin(), graphs->end(), [&](const StoredGraph& one) { return one.name == name; });
    if (graph == graphs->end()) return SINEW_INDEX_OUT_OF_RANGE;
    const void* const own = graph->bytes.empty() ? "" : static_cast<const void*>(graph->bytes.data());
    return sinew_graph_create(own, graph->bytes.size(), out, messages);
  });
}
