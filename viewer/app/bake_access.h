// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "importer/import_gltf.h"
#include "runtime/model/vertex_access.h"
#include "viewer/app/exhibit.h"

namespace sinew::viewer {

/// Takes the ambient access that a file has at its vertices (`sinew bake-ao`).
/// in    file   imported with ImportOptions::carry_document
///       say    receives a line for each attribute that cannot be used
/// out   null where no primitive has any
std::shared_ptr<const VertexAccess> access_of_file(const ImportedFile& file,
                                                   const std::function<void(const std::string&)>& say);

/// How ambient access is baked at load.
struct AccessBaking {
  std::uint32_t key_poses = 1;  ///< 1 = the rest pose; else that many, spread evenly over the clip
  std::uint32_t clip = kNone;
};

/// Bakes the ambient access of an exhibit, unless it has some.
/// in    say        receives what was baked and how long it took
///       progress   receives the finished part, 0 to 1; may be empty
/// err   a sentence: the build has no Embree, or there is no memory
/// cost  some microseconds a vertex and key pose
tl::expected<void, std::string> add_missing_access(Exhibit& exhibit, const AccessBaking& baking,
                                                   const std::function<void(const std::string&)>& say,
                                                   const std::function<void(double)>& progress = {});

}  // namespace sinew::viewer
