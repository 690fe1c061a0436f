// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/ambient/key_pose_names.h"
#include "importer/import_gltf.h"
#include "importer/rewrite_gltf.h"
#include "runtime/model/vertex_visibility.h"

namespace sinew {

/// Makes the vertex attributes of a file, in file order. A vertex that the importer split (at edges of flat faces) gets
/// the mean of its copies.
/// in    visibility   of the imported scene, with key poses spread evenly over their clip; empty lists get no attribute
std::vector<AddedAttribute> ambient_attributes(const Scene& scene, const VertexVisibility& visibility);

/// The names of all attributes of ambient visibility in a file.
/// in    file     imported with ImportOptions::carry_document
std::vector<std::string> ambient_attribute_names(const ImportedFile& file);

/// Reads the attributes of a file. If several clips have key poses, uses the first. A primitive without key poses uses
/// its single-pose attribute, if any.
/// in    file     imported with ImportOptions::carry_document
/// out   issues   warnings about unusable attributes (not one fraction for each vertex) and about missing clips or
///       poses; these are ignored
VertexVisibility read_ambient_visibility(const ImportedFile& file, std::vector<ImportIssue>& issues);

}  // namespace sinew
