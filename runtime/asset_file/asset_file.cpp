// SPDX-License-Identifier: MIT
#include "runtime/asset_file/asset_file.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "runtime/asset_file/asset_format.h"
#include "runtime/base/checksum.h"
#include "runtime/clip/byte_stream.h"

namespace sinew {
namespace {

/// The magic of files that contain only compiled clips (clip/clip_file.h).
constexpr char kClipMagic[8] = {'S', 'I', 'N', 'E', 'W', 'C', 'L', 'P'};

bool begins_with(std::span<const std::byte> bytes, const char (&magic)[8]) noexcept {
  return bytes.size() >= sizeof magic && std::memcmp(bytes.data(), magic, sizeof magic) == 0;
}

tl::unexpected<AssetFileError> refuse(const char* rule, std::uint64_t offset, std::string detail) {
  return tl::unexpected(AssetFileError{rule, "", offset, std::move(detail)});
}

tl::unexpected<AssetFileError> refuse_block(const char* rule, AssetKind kind, std::string detail) {
  return tl::unexpected(AssetFileError{rule, std::string(name_of(kind)), 0, std::move(detail)});
}

/// An entry of the table with its checksum and storage flags.
struct Entry {
  AssetBlock block;
  std::uint32_t storage = 0, reserved = 0;
  std::uint64_t sum = 0, reserved_end = 0;
};

Entry read_entry(ByteReader& in) {
  Entry entry;
  AssetBlock& block = entry.block;
  block.kind = static_cast<AssetKind>(in.number<std::uint32_t>());
  block.version = in.number<std::uint32_t>();
  entry.storage = in.number<std::uint32_t>();
  entry.reserved = in.number<std::uint32_t>();
  block.offset = in.number<std::uint64_t>();
  block.stored_bytes = in.number<std::uint64_t>();
  block.bytes = in.number<std::uint64_t>();
  entry.sum = in.number<std::uint64_t>();
  block.skeleton_signature = in.number<std::uint64_t>();
  entry.reserved_end = in.number<std::uint64_t>();
  block.is_packed = entry.storage == kPackedByZstd;
  block.is_known = !name_of(block.kind).empty() && block.version == kAssetBlockVersion;
  return entry;
}

/// Describes what is wrong with an entry by itself; null if nothing is.
const char* fault_of(const Entry& entry) noexcept {
  const AssetBlock& block = entry.block;
  if (entry.reserved != 0 || entry.reserved_end != 0) return "reserved bytes are not 0";
  if (block.offset % kAssetAlignment != 0) return "a block does not begin at a multiple of 64 bytes";
  if (!block.is_known) return nullptr;
  if (entry.storage > kPackedByZstd) return "a block is stored in no known way";
  if (!block.is_packed && block.bytes != block.stored_bytes) return "a block that is not packed has two sizes";
  return nullptr;
}

bool all_zero(std::span<const std::byte> bytes) noexcept {
  return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
}

/// Checks that blocks follow each other with zeros between them and that the last one ends the file.
tl::expected<void, AssetFileError> check_places(std::span<const std::byte> file, std::span<const AssetBlock> blocks,
                                                std::uint64_t table_end) {
  std::uint64_t end = table_end, limit = kAssetMadeBytes + kAssetMadeTimes * file.size();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const AssetBlock& block = blocks[i];
    const std::uint64_t at = kAssetHead + i * kAssetEntry;
    if (block.offset < end || block.offset - end >= kAssetAlignment)
      return refuse("asset-value", at, "a block does not follow the one before it");
    if (block.offset > file.size() || block.stored_bytes > file.size() - block.offset)
      return refuse("asset-size", at, "a block goes on after the end of the file");
    if (!all_zero(file.subspan(end, block.offset - end)))
      return refuse("asset-value", end, "bytes between blocks are not 0");
    end = block.offset + block.stored_bytes;
    if (!block.is_known) continue;
    if (block.bytes > limit)
      return refuse("asset-memory", at, "a block says that it unpacks to far more than its bytes");
    limit -= block.bytes;
  }
  if (end != file.size()) return refuse("asset-size", end, "bytes follow the last block");
  return {};
}

bool repeats_a_kind(std::span<const AssetBlock> blocks) noexcept {
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!name_of(blocks[i].kind).empty() && blocks[i].kind == blocks[k].kind) return true;
  return false;
}

}  // namespace

std::string_view name_of(AssetKind kind) noexcept {
  switch (kind) {
    case AssetKind::skeleton: return "skeleton";
    case AssetKind::model: return "model";
    case AssetKind::clips: return "clips";
    case AssetKind::animations: return "animations";
    case AssetKind::bounds: return "bounds";
    case AssetKind::pages: return "pages";
    case AssetKind::page_keys: return "page_keys";
    case AssetKind::skeleton_lods: return "skeleton_lods";
    case AssetKind::graphs: return "graphs";
  }
  return "";
}

std::string describe(const AssetFileError& error) {
  const std::string where = error.block.empty() ? "" : " in block " + error.block;
  return error.rule + where + ", byte " + std::to_string(error.offset) + ": " + error.detail;
}

bool looks_like_asset_file(std::span<const std::byte> start) noexcept { return begins_with(start, kAssetMagic); }

tl::expected<AssetFile, AssetFileError> AssetFile::open(std::span<const std::byte> file) {
  if (begins_with(file, kClipMagic))
    return refuse(
        "asset-magic", 0,
        "these are compiled clips without a skeleton, of an earlier `sinew compile`: compile the model again, "
        "or read them with load_clips");
  if (!looks_like_asset_file(file)) return refuse("asset-magic", 0, "this is no asset file");
  if (file.size() < kAssetHead) return refuse("asset-size", file.size(), "the file ends inside of its head");
  ByteReader head(file, sizeof kAssetMagic);
  if (const auto version = head.number<std::uint32_t>(); version != kAssetFileVersion)
    return refuse("asset-version", 8,
                  "the file is of version " + std::to_string(version) + ", this library reads version " +
                      std::to_string(kAssetFileVersion) + ": compile the model again");
  const auto count = head.number<std::uint32_t>();
  if (head.number<std::uint64_t>() != file.size())
    return refuse("asset-size", 16, "the file is longer or shorter than it says");
  if (count > kMaxBlocks) return refuse("asset-value", 12, "the file has too many blocks");
  if (count > (file.size() - kAssetHead) / kAssetEntry)
    return refuse("asset-size", 12, "the file ends inside of its table");
  const auto table = file.subspan(kAssetHead, count * kAssetEntry);
  if (head.number<std::uint64_t>() != checksum(table))
    return refuse("asset-checksum", 24, "the table has changed since it was written");
  AssetFile out;
  out.file_ = file;
  ByteReader in(table);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Entry entry = read_entry(in);
    if (const char* fault = fault_of(entry)) return refuse("asset-value", kAssetHead + i * kAssetEntry, fault);
    out.blocks_.push_back(entry.block);
    out.sums_.push_back(entry.sum);
  }
  if (repeats_a_kind(out.blocks_)) return refuse("asset-value", kAssetHead, "two blocks are of one kind");
  if (const auto placed = check_places(file, out.blocks_, kAssetHead + table.size()); !placed)
    return tl::unexpected(placed.error());
  return out;
}

const AssetBlock* AssetFile::find(AssetKind kind) const noexcept {
  const auto found = std::find_if(blocks_.begin(), blocks_.end(), [&](const AssetBlock& b) { return b.kind == kind; });
  return found == blocks_.end() ? nullptr : &*found;
}

bool AssetFile::sum_is_right(std::size_t block) const noexcept {
  return checksum(file_.subspan(blocks_[block].offset, blocks_[block].stored_bytes)) == sums_[block];
}

tl::expected<void, AssetFileError> AssetFile::check_sums() const {
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (!sum_is_right(i))
      return refuse_block("asset-checksum", blocks_[i].kind, "the block has changed since it was written");
  return {};
}

tl::expected<const AssetBlock*, AssetFileError> AssetFile::known_block(AssetKind kind) const {
  const AssetBlock* block = find(kind);
  if (block == nullptr) return refuse_block("asset-missing", kind, "the file has no such block");
  if (!block->is_known)
    return refuse_block("asset-version", kind,
                        "the block is of version " + std::to_string(block->version) + ", this library reads version " +
                            std::to_string(kAssetBlockVersion) + ": compile the model again");
  return block;
}

tl::expected<std::span<const std::byte>, AssetFileError> AssetFile::view_of(AssetKind kind) const {
  const auto block = known_block(kind);
  if (!block) return tl::unexpected(block.error());
  if ((*block)->is_packed) return refuse_block("asset-value", kind, "the block is packed");
  return file_.subspan((*block)->offset, (*block)->stored_bytes);
}

tl::expected<std::span<const std::byte>, AssetFileError> AssetFile::bytes_of(AssetKind kind,
                                                                             std::vector<std::byte>& unpacked) const {
  const auto known = known_block(kind);
  if (!known) return tl::unexpected(known.error());
  const AssetBlock* block = *known;
  if (!sum_is_right(static_cast<std::size_t>(block - blocks_.data())))
    return refuse_block("asset-checksum", kind, "the block has changed since it was written");
  const auto stored = file_.subspan(block->offset, block->stored_bytes);
  if (!block->is_packed) return stored;
  unpacked.resize(block->bytes);
  const std::size_t size = ZSTD_decompress(unpacked.data(), unpacked.size(), stored.data(), stored.size());
  if (ZSTD_isError(size) != 0u || size != block->bytes)
    return refuse_block("asset-size", kind, "the packed block does not unpack to the size that it says");
  return std::span<const std::byte>(unpacked);
}

}  // namespace sinew
