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

/// Metadata of the exported file, and a progress callback.
struct ExportOptions {
  std::string copyright;                                                ///< asset.copyright
  std::function<void(const char* stage, double done_0_to_1)> progress;  ///< may be empty
};

/// Writes a scene as one binary glTF 2.0 file: nodes, meshes, skins, animations, morph targets (sparse where that is
/// smaller), materials, images, cameras and lights. Importing the file again gives equal assets.
/// - Images are written from Image::encoded if present, else encoded as PNG.
/// - Flat normals made by the importer are omitted: in glTF a missing NORMAL means flat shading.
/// - Vertices are written in the order of their source file where possible.
/// - glTF forbids some empty entries. So a clip without tracks gets one channel without a node, and a missing image
///   becomes a single visible pixel.
/// - Not written: centers of rotation (an import recomputes them on request) and pose correctives (glTF cannot
///   represent them). The overload with a path writes the file atomically and returns its size in bytes.
/// in    scene   has passed check(Scene)
/// out   the bytes of the file, owned by the caller
/// err   "squad-in-gltf" (glTF has no squad interpolation), "glb-size" (the file would have 4 GiB or more),
///       "write-file"
/// cost  O(scene); holds the binary chunk twice while writing
ImportResult<std::vector<std::byte>> export_glb(const Scene& scene, const ExportOptions& options = {});
ImportResult<std::size_t> export_glb(const Scene& scene, const std::filesystem::path& file,
                                     const ExportOptions& options = {});

}  // namespace sinew
