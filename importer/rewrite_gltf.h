// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "importer/import_gltf.h"

namespace sinew {

/// A scalar vertex attribute.
struct AddedAttribute {
  std::uint32_t mesh = 0, primitive = 0;  ///< indices in the file
  std::string name;                       ///< must start with an underscore: an application-specific attribute
  std::vector<float> values;              ///< one value for each vertex of the file's primitive, in file order
};

/// How far RewriteOptions::quantize rounds keys: to `coarse` bits, to some more, or not at all.
enum class KeyRounding : std::uint8_t { coarse, fine, none };

/// How to rewrite a file. By default all data stay unchanged, except that compressed data are decoded.
struct RewriteOptions {
  /// Replacement keys, parallel to Scene::animations; empty = keep the file's. Ignored channels keep their keys, as do
  /// channels other than translation, rotation, scale and weights.
  std::span<const Animation> animations = {};
  /// [joints of the scene] new target joint of each joint's channels, for mirrored animations; empty = unchanged.
  /// `animations` must hold the keys of the new targets.
  std::span<const std::uint32_t> channels_to = {};
  /// Animations to append: of joints, of all morph weights of a mesh instance, and (by KHR_animation_pointer) of
  /// properties that the file defines (property_is_defined()). Tracks of single weights are not written.
  std::span<const Animation> added_animations = {};
  /// Vertex attributes to remove from every primitive, with the data that only they use. Attributes defined by glTF are
  /// not allowed: others may depend on them.
  std::span<const std::string> left_out_attributes = {};
  /// Vertex attributes to add; an existing attribute of the same name is replaced.
  std::span<const AddedAttribute> added_attributes = {};
  /// Quantize data; importer/rewrite/quantize_streams.h bounds the error. Normals and tangents get 8 bits
  /// (KHR_mesh_quantization), texture coordinates 12, colours and weights 8, rotation keys 16 (12 with `meshopt`).
  /// Positions stay floats; with `meshopt` they keep 15 bits, and translation and scale keys 16. Weights get 16 bits
  /// where 8 would move a vertex by more than 0.1 % of the model's size. Vertices keep their order and number.
  bool quantize = false;
  /// `fine` keeps 16 bits of rotations and 20 of translation and scale keys, `none` every bit of all keys.
  KeyRounding key_rounding = KeyRounding::coarse;
  /// Merge vertices that are equal (with `quantize`: that become equal) in everything, and remove unused ones. This
  /// renumbers vertices.
  bool merge_vertices = false;
  /// Compress with EXT_meshopt_compression, which the new file then requires. Triangles and vertices are reordered for
  /// the codec and equal ones merged, which renumbers vertices. Without `quantize`, values stay bit-identical.
  bool meshopt = false;
  /// Write WebP, AVIF and KTX2 images as PNG, which every reader knows; their extensions go. An image that cannot be
  /// decoded is a loss ("image-missing").
  bool decode_images = false;
  /// Names of permitted losses: an extension, or a rule such as "image-missing"; "all" permits everything.
  std::set<std::string> drop = {};
  /// Empty = write a .glb; otherwise a .gltf whose buffer has this URI.
  std::string buffer_uri = {};
};

/// Output of rewrite_gltf().
struct RewrittenFile {
  std::vector<std::byte> file;     ///< the .glb, or the text of the .gltf
  std::vector<std::byte> buffer;   ///< content of the file `buffer_uri`; empty for a .glb
  std::vector<ImportIssue> drops;  ///< losses, all permitted by options.drop
};

/// Rewrites a file that was imported with ImportOptions::carry_document. Preserves all content, also what the importer
/// does not know: extras, extensions, attributes, names, images of any kind, and all indices. All data go into one
/// buffer; compressed data are decoded. Edits of the scene are not written: use export_glb() for those. Rewriting is
/// idempotent: a second pass changes no byte.
/// in    file   from import_gltf(); if options.animations is used, its scene must be unchanged
/// err   "not-carried": the first loss that options.drop does not permit; further ones are in more_errors. "glb-size":
///       the file would have 4 GiB or more.
/// cost  O(file); holds the binary data twice
ImportResult<RewrittenFile> rewrite_gltf(const ImportedFile& file, const RewriteOptions& options = {});

}  // namespace sinew
