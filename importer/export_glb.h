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

/// What a file says about itself beside the scene.
struct ExportOptions {
  std::string copyright;                                                ///< asset.copyright
  std::function<void(const char* stage, double done_0_to_1)> progress;  ///< may be empty
};

/// The scene as one binary glTF 2.0 file: nodes, meshes, skins, animations, morph targets (sparse where that is
/// smaller), materials, images (as they were where Image::encoded has them, else PNG), cameras, lights. Importing it
/// again gives equal assets. Normals that the importer made flat are left out, since a missing NORMAL means flat;
/// vertices keep the numbers that they had in their file where that is possible. What glTF cannot leave empty gets a
/// harmless entry: a clip without tracks a channel without node, a missing image one visible pixel.
/// Centers of rotation are left out: an import that wants them makes them again.
/// Correctives have no place in glTF and are not written.
/// The overload with a file writes it whole or not at all.
/// err  "squad-in-gltf" (glTF has no such interpolation), "glb-size" (4 GiB and more), "write-file"
/// cost O(scene); holds the binary part twice while writing
ImportResult<std::vector<std::byte>> export_glb(const Scene& scene, const ExportOptions& options = {});
ImportResult<std::size_t> export_glb(const Scene& scene, const std::filesystem::path& file,
                                     const ExportOptions& options = {});  ///< answers bytes written

}  // namespace sinew
