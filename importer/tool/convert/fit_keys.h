// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "importer/import_error.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// Animations of a scene, its own or mirrored ones, without the keys that the budget allows to leave out. Progress is
/// shown on a terminal.
std::vector<Animation> fit_keys(const Scene& scene, std::span<const Animation> truths, double budget_m);

/// Reads the written file again; a table of how far its clips move anything of the scene from where `truths`, one for
/// each clip, have it.
/// err   as import_gltf()
ImportResult<std::string> certificates(const Scene& scene, std::span<const Animation> truths,
                                       const std::filesystem::path& file, double budget_m);

}  // namespace sinew::tool
