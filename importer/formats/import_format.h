// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "importer/import_error.h"

namespace sinew::formats {

/// Facts that a file does not state, and values that replace the ones that it states.
struct FormatOptions {
  /// Length of a unit. Default: what an FBX or COLLADA file says; a BVH file says nothing and is in centimetres.
  std::optional<double> metres_per_unit;
  /// True if z points up. Default: what the file says; a BVH file says nothing, and y points up.
  std::optional<bool> z_up;
  bool keep_end_sites = true;            ///< BVH: end sites become joints.
  bool positions_add_to_offset = false;  ///< BVH: position channels are added to OFFSET in place of replacing it.
  std::uint64_t max_file_bytes = std::uint64_t{1} << 30;
};

/// A BVH, FBX or COLLADA file converted to glTF, and a summary for the user.
struct ImportedFormat {
  std::vector<std::byte> glb;
  std::string format;               ///< "BVH", "FBX" or "COLLADA"
  std::size_t joints = 0;           ///< Number of nodes in the glTF file.
  std::size_t clips = 0, keys = 0;  ///< `keys` is the count of the track with the most keys.
  std::size_t vertices = 0;
  double duration_s = 0.0;            ///< of the longest clip
  std::vector<ImportIssue> warnings;  ///< repairs; json_pointer holds the place in the source
  std::vector<std::string> left_out;  ///< A sentence for each thing that glTF or this reader cannot keep.
};

/// Reads a BVH, FBX or COLLADA file, told by its first bytes. Y is up and lengths are in metres afterwards; names are
/// kept. FBX and COLLADA are read by assimp, which is not safe for files that somebody else made.
/// err   "file-kind" (another format, which the sentence names), "no-assimp", "file-missing", "assimp", rules of read_bvh()
/// cost  O(file); holds it some five times
ImportResult<ImportedFormat> import_format(const std::filesystem::path& file, const FormatOptions& options = {});

}  // namespace sinew::formats
