// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/geometry_cache/point_cache.h"
#include "importer/import_error.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// Meshes that move as point caches or numbered OBJ files say. `found` is a sentence about how they were read.
struct BakedPoints {
  GeometryTake take;
  std::string found;
};

struct PointsOptions {
  std::string file;          ///< .mdd or .pc2
  std::optional<UpAxis> up;  ///< empty = found by comparing the first frame with the mesh at rest
  double fps = 30.0;
};

/// The mesh of an OBJ file, moved by a point cache. Its points are in the order of the file's lines `v`.
ImportResult<BakedPoints> bake_points(const std::filesystem::path& obj, const PointsOptions& options);

/// The only mesh of a scene, moved by a point cache. Its points are in the order of the file's vertices.
/// err  points-mesh  more than one mesh, primitive or instance, or none
ImportResult<BakedPoints> bake_points(const Scene& scene, const PointsOptions& options);

/// OBJ files whose names end in numbers that count up: cloth_0001.obj, cloth_0002.obj, ... up to the first that does
/// not exist.
/// out  at least the first
/// err  obj-frames  the name of the first ends in no number
ImportResult<std::vector<std::filesystem::path>> numbered_obj_files(const std::filesystem::path& first);

/// A mesh with one OBJ file for each frame.
/// in   files  at least one
/// err  obj-topology  a file has other faces or another number of vertices than the first
ImportResult<BakedPoints> bake_numbered_obj(const std::vector<std::filesystem::path>& files, double fps);

}  // namespace sinew::tool
