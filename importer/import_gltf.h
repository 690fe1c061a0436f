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

/// What to read from a file, and how much memory it may take. The defaults suit files of unknown origin.
struct ImportOptions {
  bool decode_images = true;              ///< false: images stay empty, without a warning
  bool probe_images = false;              ///< read type and size from the headers of images that are not decoded
  bool keep_encoded_images = false;       ///< fill Image::encoded, so that images can be written unchanged
  bool make_normals = true;               ///< flat normals for triangles that have none
  bool make_tangents = true;              ///< where a normal map needs tangents and the file has none
  bool make_centers_of_rotation = false;  ///< for skinned meshes (Skinning::center_of_rotation); may take long
  std::filesystem::path centers_cache;    ///< folder that caches centers of rotation; empty = no cache
  bool thorough = false;                  ///< also check what the scene does not need: min and max, declarations, spare
                                          ///< and unused parts; the only reports of severity info
  bool collect_all_errors = false;      ///< go on after an error, to list those of later steps too; the file is refused
                                        ///< either way
  bool animate_default_weights = true;  ///< a channel that animates mesh.weights animates each node that shows the
                                        ///< mesh and has no weights; false: such channels are ignored
  bool carry_document = false;          ///< fill ImportedFile::carried, so that rewrite_gltf() can write the file again
  std::uint64_t max_file_bytes = std::uint64_t{4} << 30;  ///< the file with all buffers and images it names
  /// Limit of decompressed data, and again of vertices and keys in memory. Neither goes above 64 MiB + 64 x file.
  std::uint64_t max_unpacked_bytes = std::uint64_t{16} << 30;
  std::uint32_t max_nodes = 1'000'000;  ///< also accessors, buffer views and meshes; other lists have at most 65536
  std::uint32_t max_node_depth = 1'000'000;
  std::uint64_t max_image_pixels = std::uint64_t{1} << 28;
  std::size_t max_listed_per_rule = 64;  ///< of each rule that is broken; further cases are counted in the last one
  /// Called on the thread that imports; may be empty.
  std::function<void(const char* stage, double done_0_to_1)> progress;
};

struct CarriedDocument;
struct VrmCharacter;

/// The scene of a file as the runtime uses it, with what was odd about the file. The file's own vertex and node numbers
/// are in Primitive::source_vertex and Skeleton::node_of_joint.
struct ImportedFile {
  Scene scene;
  std::vector<ImportIssue> warnings;
  std::shared_ptr<const VrmCharacter> vrm;  ///< what VRM says about the file (vrm.h); null where it says nothing
  struct Facts {
    std::string generator, copyright, version;
    std::vector<std::string> extensions_used, extensions_required;
    std::uint64_t file_bytes = 0;  ///< including all buffers and images that were read
    /// The file, and those beside it that it names and that exist. A program that writes must leave all of them alone.
    std::vector<std::filesystem::path> files;
  } facts;
  std::shared_ptr<const CarriedDocument> carried;  ///< the whole file, where the options ask for it
};

/// How the importer handles a glTF extension.
/// - read: its data is in the scene.
/// - read_past: it only refines data that is read, for example a surface's reflection; the file loads without it.
/// - unknown: a file that requires it is refused (G57); a file that merely uses it loads.
enum class ExtensionSupport : std::uint8_t { read, read_past, unknown };
ExtensionSupport extension_support(std::string_view name) noexcept;

/// Reads a .gltf or .glb file, told apart by its first bytes, with its buffers and images. URIs are relative to the
/// folder of the file and cannot leave it. Nothing is guessed: a broken rule that makes data unusable is an error that
/// names file, JSON pointer and rule; a broken rule with a safe and usual repair is a warning that names the repair.
/// No exception leaves the function.
/// out   the scene, which has passed check(Scene)
/// err   the identifiers in importer/rules.inc
/// cost  O(file); memory below a small multiple of the file, bounded by the options
ImportResult<ImportedFile> import_gltf(const std::filesystem::path& file, const ImportOptions& options = {});

/// The same for a file in memory: a whole .glb, or .gltf text whose buffers are data URIs.
/// in    bytes   stay valid during the call
///       name    stands for the file in messages
ImportResult<ImportedFile> import_gltf(std::span<const std::byte> bytes, const std::string& name,
                                       const ImportOptions& options = {});

}  // namespace sinew
