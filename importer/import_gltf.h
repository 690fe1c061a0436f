// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "importer/import_error.h"
#include "runtime/model/scene.h"

namespace sinew {

/// What to read and how much of it to allow. The defaults suit files of unknown origin.
struct ImportOptions {
  bool decode_images = true;         ///< false: images stay empty, nothing is missing
  bool probe_images = false;         ///< where they are not decoded: kind and size all the same, from their headers
  bool keep_encoded_images = false;  ///< Image::encoded, for writing images back unchanged
  bool make_normals = true;          ///< where triangles have none
  bool make_tangents = true;         ///< where a normal map needs them and the file has none
  bool make_centers_of_rotation = false;  ///< of skinned meshes, for Skinning::center_of_rotation; may take long
  std::filesystem::path centers_cache;    ///< folder that keeps them for the next import; empty = none
  bool check_bounds = false;              ///< compare min and max of accessors, which are never used, with the data
  bool animate_default_weights = true;    ///< what moves mesh.weights moves the nodes without weights of their own;
                                          ///< false: only channels of nodes do
  std::uint64_t max_file_bytes = std::uint64_t{4} << 30;  ///< of the file and all that it refers to
  std::uint64_t max_unpacked_bytes = std::uint64_t{16}
                                     << 30;  ///< decompressed, and as vertices and keys; at most 64 MiB + 64 x file
  std::uint32_t max_nodes = 1'000'000;       ///< and accessors, buffer views, meshes; of other lists at most 65536
  std::uint32_t max_node_depth = 1'000'000;
  std::uint64_t max_image_pixels = std::uint64_t{1} << 28;
  std::function<void(const char* stage, double done_0_to_1)>
      progress;  ///< called on the importing thread, may be empty
};

/// A file as the runtime sees it, and what was odd about it. Vertex and node indices of the file are kept in
/// Primitive::source_vertex and Skeleton::node_of_joint.
struct ImportedFile {
  Scene scene;
  std::vector<ImportIssue> warnings;
  struct Facts {
    std::string generator, copyright, version;
    std::vector<std::string> extensions_used, extensions_required;
    std::uint64_t file_bytes = 0;  ///< with all buffers and images read
  } facts;
};

/// What the importer does about an extension: reads it; reads past it, since it only refines what is read; or does not
/// know it, and refuses files that require it (G57).
enum class ExtensionSupport : std::uint8_t { read, read_past, unknown };
ExtensionSupport extension_support(std::string_view name) noexcept;

/// Reads a .gltf or .glb file (told apart by content) with its buffers and images. URIs are relative to the file's
/// folder and cannot leave it. No exception escapes, nothing is guessed: a broken rule that would make data unusable is
/// an error with file, JSON pointer and rule; one that has a safe, usual repair is a warning. cost O(file), memory
/// below a small multiple of the file
ImportResult<ImportedFile> import_gltf(const std::filesystem::path& file, const ImportOptions& options = {});

/// The same from memory: a whole .glb, or .gltf text whose buffers are data URIs. `name` stands in for the file in
/// messages.
ImportResult<ImportedFile> import_gltf(std::span<const std::byte> bytes, const std::string& name,
                                       const ImportOptions& options = {});

}  // namespace sinew
