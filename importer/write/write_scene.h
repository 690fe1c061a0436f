// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "importer/import_error.h"
#include "importer/write/glb_buffer.h"
#include "runtime/model/scene.h"

namespace sinew::write {

/// Distance from near to far plane of an orthographic camera without a far plane: glTF requires one.
inline constexpr double kFarPlane_m = 10'000.0;

/// Adds a name to extensionsUsed, if missing.
void declare_extension(tinygltf::Model& model, const char* name);

/// True if the texture reference needs KHR_texture_transform.
bool has_transform(const TextureUse& use) noexcept;

/// Makes the object of KHR_texture_transform and declares the extension.
tinygltf::Value transform_of(const TextureUse& use, tinygltf::Model& model);

/// Writes the layers of a material as extensions, if they differ from the defaults.
void write_material_layers(const Material& material, tinygltf::Model& model, tinygltf::Material& out);

/// The parts of export_glb() in the order in which they run. Each appends to `model` and `buffer`.
void write_images(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);
void write_materials(const Scene& scene, tinygltf::Model& model);
void write_meshes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);
void write_cameras_and_lights(const Scene& scene, tinygltf::Model& model);

/// Nodes keep the file's indices (Skeleton::node_of_joint). A joint with several mesh instances, cameras or lights gets
/// a child node for each one after the first.
/// out   the node of each mesh instance
std::vector<int> write_nodes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer);

/// Writes KHR_materials_variants: the names of the variants, and their materials on the meshes, which must be written
/// already.
void write_variants(const Scene& scene, tinygltf::Model& model);

/// Writes all animations.
/// err   the issue, if glTF cannot express a track ("squad-in-gltf")
std::optional<ImportIssue> write_animations(const Scene& scene, const std::vector<int>& node_of_instance,
                                            tinygltf::Model& model, GlbBuffer& buffer);

}  // namespace sinew::write
