// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "importer/import_error.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// The scene's animations without the keys that the budget allows to leave out. Progress is shown on a terminal.
std::vector<Animation> fit_keys(const Scene& scene, double budget_m);

/// Reads the written file again; a table of how far its clips move anything from where `scene` has it.
/// err   as import_gltf()
ImportResult<std::string> certificates(const Scene& scene, const std::filesystem::path& file, double budget_m);

}  // namespace sinew::tool
