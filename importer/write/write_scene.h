// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "importer/import_error.h"
#include "importer/write/glb_buffer.h"
#include "runtime/model/scene.h"

namespace sinew::write {

/// How far behind the near plane an orthographic camera sees when nothing says how far: glTF demands a number.
inline constexpr double kFarPlane_m = 10'000.0;

/// Adds a name to extensionsUsed, unless it is there.
void declare_extension(tinygltf::Model& model, const char* name);

/// A use of a texture needs KHR_texture_transform.
bool has_transform(const TextureUse& use) noexcept;

/// The object of KHR_texture_transform; declares the extension.
tinygltf::Value transform_of(const TextureUse& use, tinygltf::Model& model);

/// Writes the members specular, clearcoat, sheen and transmission as extensions, where they differ from the defaults.
void write_material_layers(const Material& material, tinygltf::Model& model, tinygltf::Material& out);

/// The parts of export_glb() in the order in which they run. Each appends to `model` and `buffer`.
void write_images(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);
void write_materials(const Scene& scene, tinygltf::Model& model);
void write_meshes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);
void write_cameras_and_lights(const Scene& scene, tinygltf::Model& model);

/// Nodes keep the file's indices (Skeleton::node_of_joint). A joint with several mesh instances gets a child node for
/// each instance after the first; so does one with several cameras or lights.
/// out   the node of each mesh instance
std::vector<int> write_nodes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);

/// KHR_materials_variants: the names of the variants, and on the meshes, which must be written already, the materials
/// that each variant gives.
void write_variants(const Scene& scene, tinygltf::Model& model);

/// err   the issue, where glTF cannot express a track ("squad-in-gltf")
std::optional<ImportIssue> write_animations(const Scene& scene, const std::vector<int>& node_of_instance,
                                            tinygltf::Model& model, GlbBuffer& buffer);

}  // namespace sinew::write
