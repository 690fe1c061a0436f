// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "importer/import_error.h"
#include "importer/write/glb_buffer.h"
#include "runtime/model/scene.h"

namespace sinew::write {

/// Adds a name to extensionsUsed, once.
void declare_extension(tinygltf::Model& model, const char* name);

/// The parts of export_glb, in the order in which they run; each appends to `model` and `buffer`.
void write_images(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);
void write_materials(const Scene& scene, tinygltf::Model& model);
void write_meshes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);
void write_cameras_and_lights(const Scene& scene, tinygltf::Model& model);

/// Nodes keep the file's indices (Skeleton::node_of_joint). A joint that carries several mesh instances gets a child
/// node for each one after the first. Answers the node of each mesh instance.
std::vector<int> write_nodes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);

/// KHR_materials_variants: the names, and on the meshes written before which materials they give.
void write_variants(const Scene& scene, tinygltf::Model& model);

/// Answers the issue when a track cannot be said in glTF.
std::optional<ImportIssue> write_animations(const Scene& scene, const std::vector<int>& node_of_instance,
                                            tinygltf::Model& model, GlbBuffer& buffer);

}  // namespace sinew::write
