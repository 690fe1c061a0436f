// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/ambient/access_surfaces.h"
#include "importer/import_gltf.h"
#include "importer/rewrite_gltf.h"

namespace sinew {

/// The vertex attribute of a file that holds ambient access: one float in [0, 1] a vertex. Names with an underscore are
/// the application's own in glTF, so other programs pass over it. COLOR_0 would be no place for it: that multiplies the
/// base colour, and so darkens the light of lamps too. Normalised integers would save nothing, because vertex
/// attributes are aligned to four bytes.
inline constexpr const char* kAmbientAccessAttribute = "_AMBIENT_ACCESS";

/// The attributes of a file, in the file's order of vertices. A vertex that the importer split at the edges of flat
/// faces gets the mean of its copies.
/// in    access   of the imported scene; empty lists get no attribute
std::vector<AddedAttribute> ambient_attributes(const Scene& scene, const MeshAccess& access);

/// Reads the attributes of a file.
/// in    file     imported with ImportOptions::carry_document
/// out   issues   warnings, for attributes that are no fraction for each vertex; those are taken as absent
///       [mesh][primitive][V of the scene]; empty where a primitive has none
MeshAccess read_ambient_access(const ImportedFile& file, std::vector<ImportIssue>& issues);

}  // namespace sinew
