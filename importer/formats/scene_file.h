// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

#include "importer/formats/import_format.h"
#include "importer/formats/model_draft.h"

namespace sinew::formats {

/// Reads an FBX or COLLADA file by assimp: nodes, meshes, skins, morph targets, materials and animations.
/// - Pivots of FBX are folded: a joint is one node. Keys are added where a pivot makes a straight line between two keys
///   leave the curve.
/// - assimp does not say how keys are joined, so all are LINEAR; tangents of curves are lost.
/// in     is_fbx   else the file is COLLADA
/// err    "assimp", with assimp's own sentence; "no-assimp" in a build without it
std::optional<ImportIssue> add_scene_file(std::span<const std::byte> bytes, bool is_fbx,
                                          const std::filesystem::path& file, const FormatOptions& options,
                                          ModelDraft& draft, ImportedFormat& out);

}  // namespace sinew::formats
