// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/file/json_tree.h"

/// Reads the list entries that have tinygltf's types. Values and defaults are those of tinygltf's own reader; tests
/// compare them. Added are parts that it loses: extensions as JSON, names with a zero byte.
/// in   json   an entry that passed check_shape() (gltf_shape.h)
namespace sinew {

tinygltf::Asset read_asset(const JsonNode& json);
gltf::Mesh read_mesh(const JsonNode& json);
gltf::Node read_node(const JsonNode& json);
tinygltf::Skin read_skin(const JsonNode& json);
gltf::Material read_material(const JsonNode& json);
gltf::Texture read_texture(const JsonNode& json);
tinygltf::Sampler read_texture_sampler(const JsonNode& json);
tinygltf::Camera read_camera(const JsonNode& json);
tinygltf::Scene read_scene(const JsonNode& json);

}  // namespace sinew
