// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "importer/import_error.h"
#include "runtime/assets/scene.h"

namespace sinew {

/// The scene as one binary glTF 2.0 file: nodes, meshes, skins, animations, morph targets (sparse where that is smaller),
/// materials, images (as PNG), cameras, lights. Importing it again gives equal assets. Normals that the importer made flat are
/// left out, since a missing NORMAL means flat; vertices are written in the scene's order.
/// err  "squad-in-gltf" (glTF has no such interpolation), "glb-size" (4 GiB and more), "write-file"
/// cost O(scene); holds the binary part twice while writing
ImportResult<std::vector<std::byte>> export_glb(const Scene& scene);
ImportResult<std::size_t> export_glb(const Scene& scene, const std::filesystem::path& file);  ///< answers bytes written

}  // namespace sinew
