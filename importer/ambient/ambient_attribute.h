// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/ambient/key_pose_names.h"
#include "importer/import_gltf.h"
#include "importer/rewrite_gltf.h"
#include "runtime/model/vertex_access.h"

namespace sinew {

/// The attributes of a file, in the file's order of vertices. A vertex that the importer split at the edges of flat
/// faces gets the mean of its copies.
/// in    access   of the imported scene; its key poses are spread evenly over their clip; empty lists get no attribute
std::vector<AddedAttribute> ambient_attributes(const Scene& scene, const VertexAccess& access);

/// The names of all attributes of ambient access in a file.
/// in    file     imported with ImportOptions::carry_document
std::vector<std::string> ambient_attribute_names(const ImportedFile& file);

/// Reads the attributes of a file. Of several clips with key poses it is the first; a primitive without values of its
/// key poses has those of the one pose, if it has some.
/// in    file     imported with ImportOptions::carry_document
/// out   issues   warnings, for attributes that are no fraction for each vertex and for clips and poses that are not
///                there; those are taken as absent
VertexAccess read_ambient_access(const ImportedFile& file, std::vector<ImportIssue>& issues);

}  // namespace sinew
