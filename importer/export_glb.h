// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "importer/import_error.h"
#include "runtime/model/scene.h"

namespace sinew {

/// What the file says besides the scene, and who is told about progress.
struct ExportOptions {
  std::string copyright;                                                ///< asset.copyright
  std::function<void(const char* stage, double done_0_to_1)> progress;  ///< may be empty
};

/// Writes a scene as one binary glTF 2.0 file: nodes, meshes, skins, animations, morph targets (sparse where that is
/// smaller), materials, images, cameras and lights. Importing the file again gives equal assets.
/// - Images keep their encoded bytes where Image::encoded has them; others are written as PNG.
/// - Normals that the importer made for flat shading are left out: in glTF a missing NORMAL means flat.
/// - Vertices keep the numbers of the file that they came from where that is possible.
/// - glTF forbids some empty entries. A clip without tracks gets one channel without a node, and a missing image
///   becomes one visible pixel.
/// - Not written: centers of rotation, which an import computes again on request, and pose correctives, which glTF has
///   no place for.
/// The overload that takes a path writes the file completely or not at all, and returns the number of bytes.
/// in    scene   has passed check(Scene)
/// out   the bytes of the file, owned by the caller
/// err   "squad-in-gltf" (glTF has no squad interpolation), "glb-size" (the file would have 4 GiB or more),
///       "write-file"
/// cost  O(scene); holds the binary part twice while writing
ImportResult<std::vector<std::byte>> export_glb(const Scene& scene, const ExportOptions& options = {});
ImportResult<std::size_t> export_glb(const Scene& scene, const std::filesystem::path& file,
                                     const ExportOptions& options = {});

}  // namespace sinew
