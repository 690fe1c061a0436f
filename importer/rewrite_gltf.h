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

/// A vertex attribute of one number a vertex.
struct AddedAttribute {
  std::uint32_t mesh = 0, primitive = 0;  ///< of the file
  std::string name;                       ///< with an underscore before it: an attribute that glTF does not define
  std::vector<float> values;              ///< one for each vertex of the file's primitive, in the file's order
};

/// How a file is written again. Without a choice its data stay as they are, except that compressed data are decoded.
struct RewriteOptions {
  /// Keys to write instead of the file's, parallel to Scene::animations; empty = the file's. Channels that the importer
  /// ignored, and channels of other properties than translation, rotation, scale and weights, keep their keys.
  std::span<const Animation> animations = {};
  /// [joints of the scene] the joint that the channels of each joint move in the new file, for animations that were
  /// mirrored; empty = the same one. `animations` has the keys of the joints that are moved then.
  std::span<const std::uint32_t> channels_to = {};
  /// Animations to write behind the file's: of joints, of all morph weights of mesh instances, and of properties that
  /// the file defines (property_is_defined()), by KHR_animation_pointer. Tracks of some weights are not written.
  std::span<const Animation> added_animations = {};
  /// Vertex attributes to leave out of every primitive; what only they use goes with them. No attribute that glTF
  /// defines: others may need it.
  std::span<const std::string> left_out_attributes = {};
  /// Vertex attributes to write beside those of the file; one of the same name is replaced.
  std::span<const AddedAttribute> added_attributes = {};
  /// Smaller numbers, with a loss that importer/rewrite/quantize_streams.h bounds: normals and tangents in 8 bits
  /// (KHR_mesh_quantization), texture coordinates in 12, colours and weights in 8, rotation keys in 16 (12 with
  /// `meshopt`). Positions stay floats; with `meshopt` they keep 15 bits, and keys of translations and scales 16.
  /// Vertices of triangles that are equal then become one, so vertices get other numbers.
  bool quantize = false;
  /// Compressed streams (EXT_meshopt_compression, required by the file). Triangles and vertices get the order that
  /// suits the codec, so vertices get other numbers; without `quantize` their values stay bit for bit.
  bool meshopt = false;
  /// Names of what may be lost (an extension or a rule such as "image-missing"); "all" allows everything.
  std::set<std::string> drop = {};
  /// Empty = a .glb. Otherwise a .gltf, whose buffer has this URI.
  std::string buffer_uri = {};
};

/// A file that rewrite_gltf() made.
struct RewrittenFile {
  std::vector<std::byte> file;     ///< the .glb, or the text of the .gltf
  std::vector<std::byte> buffer;   ///< what `buffer_uri` names; empty for a .glb
  std::vector<ImportIssue> drops;  ///< what was lost, as options.drop allows
};

/// Writes a file again that was imported with ImportOptions::carry_document. Everything that the file says is carried,
/// also what the importer does not know: extras, extensions, attributes, names, images of any kind, and all indices.
/// All bytes come into one buffer; compressed data are decoded. Edits of the scene are not written: this is the file,
/// and export_glb() the scene. Rewriting what was rewritten changes no byte.
/// in    file   from import_gltf(); its scene must be unchanged where options.animations are given
/// err   "not-carried": the first thing that the new file could not hold and options.drop does not name; the others
///       are in more_errors. "glb-size": the file would have 4 GiB or more.
/// cost  O(file); holds the binary part twice
ImportResult<RewrittenFile> rewrite_gltf(const ImportedFile& file, const RewriteOptions& options = {});

}  // namespace sinew
