// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/api.h"

namespace sinew {

/// Content of a block of an asset file.
enum class AssetKind : std::uint32_t {
  skeleton = 1,
  model,          ///< meshes, skins, morph sets, materials, textures, images, instances, correctives, cameras, lights
  clips,          ///< compiled, as save_clips (clip/clip_file.h) writes them
  animations,     ///< the clips in authoring form; optional
  bounds,         ///< ClipBoxes of the file's clips and model; optional
  pages,          ///< how long clips are cut into pages (PageTable); `clips` then has only their first keys; optional
  page_keys,      ///< the pages of these clips; each has its own checksum, so one can be read without the others
  skeleton_lods,  ///< joints that poses can leave out, and how far that moves vertices (CompiledSkeletonLod); optional
  graphs,         ///< motion graphs by name (StoredGraph); optional
};

/// The name of the enumerator, as "page_keys"; empty for unknown kinds.
SINEW_API std::string_view name_of(AssetKind kind) noexcept;

/// Why an asset file is refused: the broken rule, where it was found, and a sentence.
///
///     asset-magic       the file does not start with the magic of asset files
///     asset-version     another version of the library wrote the file or the block
///     asset-size        the file or the block ends too early, or goes on after its end
///     asset-checksum    bytes have changed since they were written
///     asset-value       a number has no valid meaning in its field
///     asset-memory      the file asks for far more memory than its bytes account for
///     asset-missing     the file has no block of this kind
///     asset-signature   a block belongs to another skeleton
///     clip-...          rules of compiled clips (ClipFileError)
struct AssetFileError {
  std::string rule;
  std::string block;         ///< name_of(kind); empty = the head or the table of blocks
  std::uint64_t offset = 0;  ///< byte of the unpacked block; without a block, byte of the file
  std::string detail;
};

/// One line for logs: "asset-checksum in block model, byte 0: ...".
SINEW_API std::string describe(const AssetFileError& error);

/// An entry of the table of blocks.
struct AssetBlock {
  AssetKind kind{};
  std::uint32_t version = 0;
  std::uint64_t offset = 0;              ///< byte of the file, a multiple of kAssetAlignment
  std::uint64_t stored_bytes = 0;        ///< bytes of the block in the file
  std::uint64_t bytes = 0;               ///< unpacked; equal to stored_bytes where the block is not packed
  std::uint64_t skeleton_signature = 0;  ///< signature of the skeleton that the block contains or belongs to
  bool is_packed = false;                ///< the block is packed by zstd
  bool is_known = false;                 ///< this library can read this kind and version
};

/// The table of contents of an asset file (.sinew). The caller has read or mapped the file into memory. Little-endian:
///
///     head      kAssetHead bytes: magic, version, number of blocks, bytes of the file, checksum of the table
///     table     kAssetEntry bytes per block: kind, version, storage, 0, offset, stored bytes, bytes, checksum of the
///               stored bytes, signature of the skeleton, 0
///     blocks    without pointers; each begins at a multiple of kAssetAlignment, and gaps between them are 0
///
/// A block is read on demand (read_assets.h). Blocks of unknown kinds are ignored, so that later versions may add
/// kinds.
/// owns  the table; the file must outlive it and the results of `bytes_of`
class SINEW_API AssetFile {
 public:
  /// Any bytes may be passed.
  /// err   AssetFileError; unknown blocks are no error
  /// cost  O(blocks), whatever the size of the file; allocates the table
  static tl::expected<AssetFile, AssetFileError> open(std::span<const std::byte> file);

  std::span<const AssetBlock> blocks() const noexcept { return blocks_; }
  /// Null if the file has no block of this kind.
  const AssetBlock* find(AssetKind kind) const noexcept;

  /// The unpacked bytes of a block, after comparing their checksum.
  /// out   a view of the file; for a packed block a view of `unpacked`, which is overwritten
  /// err   asset-missing, asset-version, asset-checksum, asset-size
  /// cost  O(bytes); a block that is not packed is read once and not copied
  tl::expected<std::span<const std::byte>, AssetFileError> bytes_of(AssetKind kind,
                                                                    std::vector<std::byte>& unpacked) const;

  /// The bytes of a block as they lie in the file, without reading them or comparing the checksum. For blocks whose
  /// parts have their own checksums (AssetKind::page_keys).
  /// err   asset-missing, asset-version, asset-value if the block is packed;  cost O(1)
  tl::expected<std::span<const std::byte>, AssetFileError> view_of(AssetKind kind) const;

  /// Compares the checksums of all blocks, known or not. The error names the first block whose bytes have changed.
  /// Contents are not checked; read_assets.h does that.
  /// cost  O(bytes of the file)
  tl::expected<void, AssetFileError> check_sums() const;

 private:
  tl::expected<const AssetBlock*, AssetFileError> known_block(AssetKind kind) const;
  bool sum_is_right(std::size_t block) const noexcept;

  std::span<const std::byte> file_;
  std::vector<AssetBlock> blocks_;
  std::vector<std::uint64_t> sums_;  // [blocks] checksum of each block
};

/// True if the bytes start with the magic of asset files.
SINEW_API bool looks_like_asset_file(std::span<const std::byte> start) noexcept;

inline constexpr std::uint32_t kAssetFileVersion = 1;
inline constexpr std::uint32_t kAssetBlockVersion = 3;  ///< same for all kinds
inline constexpr std::size_t kAssetHead = 32, kAssetEntry = 64, kAssetAlignment = 64;
/// Unpacked known blocks may take at most this much memory: kAssetMadeBytes plus kAssetMadeTimes the size of the file.
inline constexpr std::uint64_t kAssetMadeBytes = std::uint64_t{16} << 20, kAssetMadeTimes = 64;

}  // namespace sinew
