// SPDX-License-Identifier: MIT
#include "runtime/asset_file/read_pages.h"

#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "runtime/asset_file/asset_fields.h"
#include "runtime/asset_file/asset_reader.h"
#include "runtime/clip/clip_file.h"
#include "runtime/paging/join_clips.h"

namespace sinew {
namespace {

tl::unexpected<AssetFileError> refuse(AssetKind kind, const char* rule, std::uint64_t offset, std::string detail) {
  return tl::unexpected(AssetFileError{rule, std::string(name_of(kind)), offset, std::move(detail)});
}

/// Describes what is wrong with a page table; null if nothing is.
const char* fault_of(const PageTable& table, std::uint64_t bytes) noexcept {
  if (table.offsets.empty()) return nullptr;
  if (!std::isfinite(table.page_s) || table.page_s <= 0.0) return "the length of pages is not a time";
  if (table.offsets.size() < 2) return "a clip has pages, but none is there";
  if (std::adjacent_find(table.offsets.begin(), table.offsets.end(), std::greater_equal<>()) != table.offsets.end() ||
      table.offsets.back() > bytes)
    return "pages do not lie one after another among the keys";
  return nullptr;
}

/// Joins the pages of one clip.
class PageJoin {
 public:
  PageJoin(std::span<const std::byte> keys, const Clip& head) : keys_(keys), head_(head), joiner_(head) {}

  tl::expected<Clip, AssetFileError> join(const PageTable& table) {
    for (std::size_t page = 0; page < table.page_count(); ++page)
      if (auto added = add(table.offsets[page], table.offsets[page + 1], name_of_page(head_.name(), page)); !added)
        return tl::unexpected(added.error());
    return joiner_.clip();
  }

 private:
  tl::expected<void, AssetFileError> add(std::uint64_t first, std::uint64_t end, const std::string& name) {
    const auto bytes = unpack_page(keys_.subspan(first, end - first), unpacked_);
    if (!bytes) return refuse(AssetKind::page_keys, bytes.error().rule.c_str(), first, bytes.error().detail);
    const auto pages = load_clips(*bytes);
    if (!pages)
      return refuse(AssetKind::page_keys, pages.error().rule.c_str(), first + pages.error().offset,
                    "page \"" + name + "\": " + pages.error().detail);
    if (pages->size() != 1 || pages->front().name() != name)
      return refuse(AssetKind::page_keys, "asset-value", first, "here is no page \"" + name + "\"");
    if (!joiner_.add(pages->front()))
      return refuse(AssetKind::page_keys, "asset-value", first,
                    "page \"" + name + "\" does not continue the clip before it");
    return {};
  }

  std::span<const std::byte> keys_;
  const Clip& head_;
  ClipJoiner joiner_;
  std::vector<std::byte> unpacked_;
};

/// Reads the page tables. Their offsets count from the start of the block page_keys.
tl::expected<std::vector<PageTable>, AssetFileError> tables_of(const AssetFile& file, std::uint64_t bytes) {
  std::vector<std::byte> unpacked;
  const auto block = file.bytes_of(AssetKind::pages, unpacked);
  if (!block) return tl::unexpected(block.error());
  std::vector<PageTable> tables;
  AssetReader reader(*block, AssetKind::pages);
  reader.read(tables);
  if (!reader.finish()) return tl::unexpected(reader.error());
  for (const PageTable& table : tables)
    if (const char* fault = fault_of(table, bytes)) return refuse(AssetKind::pages, "asset-value", 0, fault);
  return tables;
}

}  // namespace

tl::expected<std::span<const std::byte>, AssetFileError> unpack_page(std::span<const std::byte> stored,
                                                                     std::vector<std::byte>& unpacked) {
  const unsigned long long size = ZSTD_getFrameContentSize(stored.data(), stored.size());
  if (size == ZSTD_CONTENTSIZE_ERROR) return stored;  // no zstd frame: not packed
  if (size / kAssetMadeTimes > stored.size())         // also true for unknown sizes, which are the largest number
    return refuse(AssetKind::page_keys, "asset-memory", 0, "a page says that it unpacks to far more than its bytes");
  unpacked.resize(size);
  const std::size_t made = ZSTD_decompress(unpacked.data(), unpacked.size(), stored.data(), stored.size());
  if (ZSTD_isError(made) != 0u || made != size)
    return refuse(AssetKind::page_keys, "asset-size", 0, "a packed page does not unpack to the size that it says");
  return std::span<const std::byte>(unpacked);
}

tl::expected<std::vector<PageTable>, AssetFileError> read_page_tables(const AssetFile& file) {
  if (file.find(AssetKind::pages) == nullptr) return std::vector<PageTable>();
  const auto keys = file.view_of(AssetKind::page_keys);
  if (!keys) return tl::unexpected(keys.error());
  auto tables = tables_of(file, keys->size());
  if (!tables) return tables;
  const std::uint64_t first = file.find(AssetKind::page_keys)->offset;
  for (PageTable& table : *tables)
    for (std::uint64_t& offset : table.offsets) offset += first;
  return tables;
}

tl::expected<std::vector<Clip>, AssetFileError> join_pages(const AssetFile& file, std::vector<Clip> heads) {
  if (file.find(AssetKind::pages) == nullptr) return heads;
  const auto keys = file.view_of(AssetKind::page_keys);
  if (!keys) return tl::unexpected(keys.error());
  const auto tables = tables_of(file, keys->size());
  if (!tables) return tl::unexpected(tables.error());
  if (tables->size() != heads.size())
    return refuse(AssetKind::pages, "asset-value", 0, "there are tables of more or fewer clips than the file has");
  for (std::size_t c = 0; c < heads.size(); ++c) {
    if ((*tables)[c].offsets.empty()) continue;
    if ((*tables)[c].page_count() != page_count_of(heads[c].duration_s(), (*tables)[c].page_s))
      return refuse(AssetKind::pages, "asset-value", 0,
                    "clip \"" + heads[c].name() + "\" has more or fewer pages than its duration asks for");
    auto joined = PageJoin(*keys, heads[c]).join((*tables)[c]);
    if (!joined) return tl::unexpected(joined.error());
    heads[c] = *std::move(joined);
  }
  return heads;
}

}  // namespace sinew
