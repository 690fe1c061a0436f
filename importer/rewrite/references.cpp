// SPDX-License-Identifier: MIT
#include "importer/rewrite/references.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "importer/file/json_pointer.h"
#include "importer/import_gltf.h"

namespace sinew::rewrite {
namespace {

using Visit = std::function<void(Referenced, Json&)>;

/// A path in a document; "*" matches every entry of an array or object.
struct KnownPlace {
  Referenced kind;
  std::string_view path;
};

constexpr KnownPlace kCore[] = {
    {Referenced::view, "accessors/*/bufferView"},
    {Referenced::view, "accessors/*/sparse/indices/bufferView"},
    {Referenced::view, "accessors/*/sparse/values/bufferView"},
    {Referenced::view, "images/*/bufferView"},
    {Referenced::accessor, "meshes/*/primitives/*/attributes/*"},
    {Referenced::accessor, "meshes/*/primitives/*/indices"},
    {Referenced::accessor, "meshes/*/primitives/*/targets/*/*"},
    {Referenced::accessor, "skins/*/inverseBindMatrices"},
    {Referenced::accessor, "animations/*/samplers/*/input"},
    {Referenced::accessor, "animations/*/samplers/*/output"},
};

/// A path inside an extension object.
struct ExtensionPlace {
  std::string_view extension;
  KnownPlace place;
};

constexpr ExtensionPlace kExtensions[] = {
    {"EXT_mesh_gpu_instancing", {Referenced::accessor, "attributes/*"}},
    {"EXT_structural_metadata", {Referenced::view, "propertyTables/*/properties/*/values"}},
    {"EXT_structural_metadata", {Referenced::view, "propertyTables/*/properties/*/arrayOffsets"}},
    {"EXT_structural_metadata", {Referenced::view, "propertyTables/*/properties/*/stringOffsets"}},
    {"CESIUM_primitive_outline", {Referenced::accessor, "indices"}},
    {"EXT_mesh_manifold", {Referenced::accessor, "manifoldPrimitive/indices"}},
    {"EXT_mesh_manifold", {Referenced::accessor, "mergeIndices"}},
    {"EXT_mesh_manifold", {Referenced::accessor, "mergeValues"}},
};

/// Extensions whose numbers are not accessor or view indices, except those in kExtensions and members named "accessor"
/// or "bufferView". Materials, textures and lights only refer to each other.
constexpr std::string_view kHarmlessPrefixes[] = {"KHR_materials_",
                                                  "EXT_materials_",
                                                  "KHR_texture_",
                                                  "EXT_texture_",
                                                  "KHR_lights_",
                                                  "EXT_lights_",
                                                  "KHR_node_",
                                                  "VRM",
                                                  "KHR_xmp",
                                                  "KHR_audio",
                                                  "MSFT_lod",
                                                  "MSFT_audio_emitter",
                                                  "KHR_physics_",
                                                  "KHR_implicit_",
                                                  "EXT_mesh_",
                                                  "EXT_instance_features",
                                                  "EXT_structural_metadata",
                                                  "CESIUM_primitive_outline",
                                                  "MSFT_texture_dds",
                                                  "MSFT_packing_",
                                                  "KHR_interactivity",
                                                  "KHR_character"};

void walk(Json& at, std::string_view path, Referenced kind, const Visit& visit) {
  if (path.empty()) {
    if (at.is_number()) visit(kind, at);
    return;
  }
  const std::size_t slash = path.find('/');
  const std::string_view name = path.substr(0, slash);
  const std::string_view rest = slash == path.npos ? std::string_view() : path.substr(slash + 1);
  if (name == "*") {
    if (at.is_structured())
      for (Json& entry : at) walk(entry, rest, kind, visit);
  } else if (at.is_object()) {
    if (const auto found = at.find(name); found != at.end()) walk(*found, rest, kind, visit);
  }
}

/// Visits members named "accessor" or "bufferView" anywhere in an extension.
void walk_names(Json& at, const Visit& visit) {
  if (!at.is_structured()) return;
  for (auto entry = at.begin(); entry != at.end(); ++entry) {
    if (at.is_object() && entry->is_number() && entry.key() == "accessor") visit(Referenced::accessor, *entry);
    if (at.is_object() && entry->is_number() && entry.key() == "bufferView") visit(Referenced::view, *entry);
    if (!at.is_object() || (entry.key() != "extensions" && entry.key() != "extras")) walk_names(*entry, visit);
  }
}

void find_extensions(Json& at, const std::string& place,
                     const std::function<void(const std::string&, const std::string&, Json&)>& visit) {
  if (at.is_array())
    for (std::size_t i = 0; i < at.size(); ++i) find_extensions(at[i], pointer(place, i), visit);
  if (!at.is_object()) return;
  for (auto entry = at.begin(); entry != at.end(); ++entry) {
    if (entry.key() == "extras" || !entry->is_structured()) continue;
    const std::string here = pointer(place, pointer_token(entry.key()));
    if (entry.key() == "extensions" && entry->is_object())
      for (auto extension = entry->begin(); extension != entry->end(); ++extension)
        visit(extension.key(), pointer(here, pointer_token(extension.key())), *extension);
    find_extensions(*entry, here, visit);
  }
}

bool has_integer(const Json& at) {
  if (at.is_number_integer()) return true;
  return at.is_structured() && std::any_of(at.begin(), at.end(), has_integer);
}

bool is_harmless(const std::string& name) {
  return extension_support(name) != ExtensionSupport::unknown ||
         std::any_of(std::begin(kHarmlessPrefixes), std::end(kHarmlessPrefixes),
                     [&](std::string_view prefix) { return name.starts_with(prefix); });
}

}  // namespace

void for_each_extension(Json& root, const std::function<void(const std::string&, const std::string&, Json&)>& visit) {
  find_extensions(root, "", visit);
}

void for_each_reference(Json& root, const Visit& visit) {
  for (const KnownPlace& known : kCore) walk(root, known.path, known.kind, visit);
  for_each_extension(root, [&](const std::string& name, const std::string&, Json& extension) {
    for (const ExtensionPlace& known : kExtensions)
      if (known.extension == name) walk(extension, known.place.path, known.place.kind, visit);
    walk_names(extension, visit);
  });
}

std::set<std::string> extensions_with_unknown_numbers(Json& root) {
  std::set<std::string> names;
  for_each_extension(root, [&](const std::string& name, const std::string&, Json& extension) {
    if (!is_harmless(name) && has_integer(extension)) names.insert(name);
  });
  return names;
}

}  // namespace sinew::rewrite
