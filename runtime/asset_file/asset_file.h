// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace sinew {

/// What a block of an asset file holds.
enum class AssetKind : std::uint32_t {
  skeleton = 1,
  model,          ///< meshes, skins, morph sets, materials, textures, images, instances, correctives, cameras, lights
  clips,          ///< compiled, as save_clips (clip/clip_file.h) writes them
  animations,     ///< the authoring form of the clips, the truth; optional
  bounds,         ///< ClipBoxes of the file's clips and model; optional
  pages,          ///< which of the clips lie in pages (PageTable), of which `clips` has the first keys only; optional
  page_keys,      ///< these pages, each with a checksum of its own, so that one is read without the others
  skeleton_lods,  ///< joints that poses can do without, and how far that moves vertices (CompiledSkeletonLod); optional
};

/// "skeleton", "model", "clips", "animations", "bounds", "pages", "page_keys", "skeleton_lods"; empty for others.
std::string_view name_of(AssetKind kind) noexcept;

/// Why an asset file is refused: the broken rule, where, and the case in words.
///
///     asset-magic       the file does not begin as such files do
///     asset-version     another version of the library wrote the file or the block
///     asset-size        the file or the block ends too early, or goes on after its end
///     asset-checksum    bytes have changed since they were written
///     asset-value       a number makes no sense where it is
///     asset-memory      the file asks for far more memory than its bytes account for
///     asset-missing     the file has no block of this kind
///     asset-signature   a block belongs to another skeleton
///     clip-...          rules of compiled clips (ClipFileError)
struct AssetFileError {
  std::string rule;
  std::string block;         ///< name_of(kind); empty = the head and the table of blocks
  std::uint64_t offset = 0;  ///< byte of the unpacked block; without a block, byte of the file
  std::string detail;
};

/// One line for people: "asset-checksum in block model, byte 0: ...".
std::string describe(const AssetFileError& error);

/// Where a block lies and what it says of itself.
struct AssetBlock {
  AssetKind kind{};
  std::uint32_t version = 0;
  std::uint64_t offset = 0;              ///< byte of the file, a multiple of kAssetAlignment
  std::uint64_t stored_bytes = 0;        ///< in the file
  std::uint64_t bytes = 0;               ///< unpacked; equal to stored_bytes where the block is not packed
  std::uint64_t skeleton_signature = 0;  ///< of the skeleton that it is, or belongs to
  bool is_packed = false;                ///< by zstd
  bool is_known = false;                 ///< this library reads this kind and this version
};

/// The table of contents of an asset file (.sinew), which lies in memory: read or mapped by the caller. Little-endian:
///
///     head      kAssetHead bytes: magic, version, number of blocks, bytes of the file, checksum of the table
///     table     kAssetEntry bytes a block: kind, version, storage, 0, offset, stored bytes, bytes, checksum of the
///               stored bytes, signature of the skeleton, 0
///     blocks    without pointers; each begins at a multiple of kAssetAlignment, and what lies between is 0
///
/// A block is read when it is asked for (read_assets.h). Blocks of unknown kinds are left alone, so that later versions
/// may add some.
/// owns  the table; the file must outlive it and what `bytes_of` answers
class AssetFile {
 public:
  /// Any bytes may be passed.
  /// err   AssetFileError; unknown blocks are no error
  /// cost  O(blocks), whatever the size of the file; allocates the table
  static tl::expected<AssetFile, AssetFileError> open(std::span<const std::byte> file);

  std::span<const AssetBlock> blocks() const noexcept { return blocks_; }
  /// Null where the file has no block of this kind.
  const AssetBlock* find(AssetKind kind) const noexcept;

  /// The unpacked bytes of a block, with their checksum compared.
  /// out   a view of the file; of a packed block a view of `unpacked`, which is overwritten
  /// err   asset-missing, asset-version, asset-checksum, asset-size
  /// cost  O(bytes); a block that is not packed is read once and not copied
  tl::expected<std::span<const std::byte>, AssetFileError> bytes_of(AssetKind kind,
                                                                    std::vector<std::byte>& unpacked) const;

  /// The bytes of a block as they lie in the file. None is read, and no checksum compared: for blocks of parts that
  /// have checksums of their own (AssetKind::page_keys).
  /// err   asset-missing, asset-version, asset-value where the block is packed;  cost O(1)
  tl::expected<std::span<const std::byte>, AssetFileError> view_of(AssetKind kind) const;

  /// The first block whose bytes have changed, unknown ones among them; what read_assets.h checks beyond that is its
  /// own.
  /// cost  O(bytes of the file)
  tl::expected<void, AssetFileError> check_sums() const;

 private:
  tl::expected<const AssetBlock*, AssetFileError> known_block(AssetKind kind) const;
  bool sum_is_right(std::size_t block) const noexcept;

  std::span<const std::byte> file_;
  std::vector<AssetBlock> blocks_;
  std::vector<std::uint64_t> sums_;  // [blocks]
};

/// True when the bytes begin as asset files do.
bool looks_like_asset_file(std::span<const std::byte> start) noexcept;

inline constexpr std::uint32_t kAssetFileVersion = 1;
inline constexpr std::uint32_t kAssetBlockVersion = 2;  ///< of every kind
inline constexpr std::size_t kAssetHead = 32, kAssetEntry = 64, kAssetAlignment = 64;
/// Limit of the memory that known blocks may take when unpacked: kAssetMadeBytes, and kAssetMadeTimes the file.
inline constexpr std::uint64_t kAssetMadeBytes = std::uint64_t{16} << 20, kAssetMadeTimes = 64;

}  // namespace sinew
