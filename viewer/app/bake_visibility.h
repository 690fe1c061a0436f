// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "importer/import_gltf.h"
#include "runtime/model/vertex_visibility.h"
#include "viewer/app/loaded_scene.h"

namespace sinew::viewer {

/// Reads the per-vertex ambient visibility that `sinew bake-ao` stored in a file.
/// in    file   imported with ImportOptions::carry_document
///       log_line  receives one line for each attribute that cannot be used
/// out   null if no primitive has such an attribute
std::shared_ptr<const VertexVisibility> file_visibility(const ImportedFile& file,
                                                        const std::function<void(const std::string&)>& log_line);

/// Which poses ambient visibility is baked for at load.
struct VisibilityBaking {
  std::uint32_t key_poses = 1;  ///< 1 = the rest pose; above 1 = number of poses, spread evenly over the clip
  std::uint32_t clip = kNone;
};

/// Bakes per-vertex ambient visibility by casting rays, unless the scene already has it.
/// in    log_line   receives one line: number of poses and rays, and seconds taken
///       progress   receives the finished fraction, 0 to 1; may be empty
/// err   one sentence: the build has no Embree, or memory ran out
/// cost  a few microseconds for each vertex and key pose
tl::expected<void, std::string> bake_missing_visibility(LoadedScene& loaded, const VisibilityBaking& baking,
                                                        const std::function<void(const std::string&)>& log_line,
                                                        const std::function<void(double)>& progress = {});

}  // namespace sinew::viewer
