// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "importer/import_error.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Options of an import, and limits on memory. The defaults are safe for untrusted files.
struct ImportOptions {
  bool decode_images = true;              ///< false: images stay empty, without a warning
  bool probe_images = false;              ///< read format and size from the headers of images that are not decoded
  bool keep_encoded_images = false;       ///< fill Image::encoded, so that an export can write images unchanged
  bool make_normals = true;               ///< make flat normals for triangles without normals
  bool make_tangents = true;              ///< make missing tangents where a normal map needs them
  bool make_centers_of_rotation = false;  ///< for skinned meshes (Skinning::center_of_rotation); may take seconds
  std::filesystem::path centers_cache;    ///< folder that caches centers of rotation; empty = no cache
  /// Also check data that the scene does not need: min and max, declarations, unused parts. Only this reports issues of
  /// severity info.
  bool thorough = false;
  /// Continue after a step with an error, to report errors of later steps too. A file that would be refused without
  /// this option is refused all the same.
  bool collect_all_errors = false;
  /// A channel of mesh.weights animates all nodes that show the mesh and have no weights of their own; false: ignored.
  bool animate_default_weights = true;
  bool carry_document = false;                            ///< fill ImportedFile::carried, which rewrite_gltf() needs
  std::uint64_t max_file_bytes = std::uint64_t{4} << 30;  ///< limit of the file with all its buffers and images
  /// Limit of decompressed data, and separately of vertices and keys in memory. Both are also limited to 64 MiB + 64
  /// times the file size.
  std::uint64_t max_unpacked_bytes = std::uint64_t{16} << 30;
  /// Limit of nodes, accessors, buffer views and meshes each; other lists are limited to 65536.
  std::uint32_t max_nodes = 1'000'000;
  std::uint32_t max_node_depth = 1'000'000;
  std::uint64_t max_image_pixels = std::uint64_t{1} << 28;
  std::size_t max_listed_per_rule = 64;  ///< issues listed per rule; further ones are only counted, in the last entry
  /// Called on the importing thread; may be empty.
  std::function<void(const char* stage, double done_0_to_1)> progress;
};

struct CarriedDocument;
struct VrmCharacter;

/// An imported scene, with warnings and facts about its file. Primitive::source_vertex and Skeleton::node_of_joint map
/// back to the file's vertex and node indices.
struct ImportedFile {
  Scene scene;
  /// Everything that was found. Entries of severity error name animation channels that are left out or cut (rule and
  /// place); the scene is sound without them.
  std::vector<ImportIssue> warnings;
  std::shared_ptr<const VrmCharacter> vrm;  ///< VRM data (vrm.h); null if the file has none
  struct Facts {
    std::string generator, copyright, version;
    std::vector<std::string> extensions_used, extensions_required;
    std::uint64_t file_bytes = 0;  ///< size of the file with all buffers and images that were read
    /// The file, and all existing files that it refers to. A program must not overwrite any of them.
    std::vector<std::filesystem::path> files;
  } facts;
  std::shared_ptr<const CarriedDocument> carried;  ///< the parsed file, if ImportOptions::carry_document is set
};

/// How the importer handles a glTF extension.
/// - read: its data is in the scene.
/// - read_past: ignored, because it only refines data that is read, such as a surface's reflection.
/// - unknown: a file that requires it is refused; a file that only uses it is loaded.
enum class ExtensionSupport : std::uint8_t { read, read_past, unknown };
ExtensionSupport extension_support(std::string_view name) noexcept;

/// Imports a .gltf or .glb file with its buffers and images; the format is detected from the first bytes. URIs are
/// relative to the file's folder and cannot leave it. A broken rule that makes data unusable is an error; one with a
/// safe and common repair is a warning that names the repair. An error that only touches animation channels does not
/// fail the import: these channels are left out. `sinew check --rules` lists the consequence of every rule. Never
/// throws.
/// out   the scene, validated by check(Scene)
/// err   rule identifiers (rules.inc of the importer)
/// cost  O(file); memory: a small multiple of the file, bounded by the options
ImportResult<ImportedFile> import_gltf(const std::filesystem::path& file, const ImportOptions& options = {});

/// Imports a file from memory: a whole .glb, or .gltf text whose buffers are data URIs.
/// in    bytes   must stay valid during the call
///       name    name of the file in messages
ImportResult<ImportedFile> import_gltf(std::span<const std::byte> bytes, const std::string& name,
                                       const ImportOptions& options = {});

}  // namespace sinew
