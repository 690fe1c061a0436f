// SPDX-License-Identifier: MIT
#include "importer/rewrite/take_decoded.h"

#include <algorithm>

#include "importer/file/meshopt_extension.h"
#include "importer/read/accessor.h"

namespace sinew::rewrite {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";
constexpr int kVertices = 34962, kIndices = 34963;  // values of bufferView.target

const char* const kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};

/// Updates the JSON of the accessors that a Draco stream fills.
void take_primitive(const gltf::Document& document, const gltf::Primitive& primitive, Json& json, Draft& draft) {
  const Json* extension = extension_of(json, kDraco);
  if (extension == nullptr) return;
  draft.spare_views.insert(index_of(extension->at("bufferView")));
  /// Writes accessor `index` of the import to the JSON, and points `named` to it. `named` is the accessor's index in
  /// the file. They differ where several Draco streams share an accessor: all but the first got a copy of it
  /// (decode_draco.cpp).
  const auto take = [&](Json& named, std::uint32_t index, int target) {
    const gltf::Accessor& accessor = document.accessors[index];
    Json& accessors = draft.json["accessors"];
    if (index >= accessors.size() || accessors[index].is_null()) accessors[index] = Json(accessors[index_of(named)]);
    named = index;
    Json& out = accessors[index];
    out["bufferView"] = accessor.buffer_view;
    out["componentType"] = static_cast<int>(accessor.component_type);
    out["type"] = kTypes[static_cast<std::size_t>(accessor.type)];
    out["count"] = accessor.count;
    out.erase("byteOffset");
    draft.json["bufferViews"][accessor.buffer_view]["target"] = target;
  };
  for (const auto& [semantic, id] : extension->at("attributes").items())
    if (const auto found = primitive.attributes.find(semantic); found != primitive.attributes.end())
      take(json["attributes"][semantic], found->second, kVertices);
  if (primitive.indices != gltf::kAbsent) take(json["indices"], primitive.indices, kIndices);
  if (json.contains("mode")) json["mode"] = primitive.mode;
  erase_extension(json, kDraco);
}

/// Replaces views by decoded bytes; returns true for each such view.
std::vector<bool> take_views(Draft& draft) {
  Json& views = list_of(draft, "bufferViews");
  std::vector<bool> decoded(views.size(), false);
  for (std::size_t i = 0; i < views.size(); ++i)
    while (const auto meshopt = meshopt_extension(views[i].value("extensions", Json()))) {
      erase_extension(views[i], meshopt.name);
      decoded[i] = true;
    }
  return decoded;
}

}  // namespace

void set_bounds(Json& accessor, const std::vector<double>& stored, std::size_t components) {
  Json lower = Json::array(), upper = Json::array();
  for (std::size_t c = 0; c < components && c < stored.size(); ++c) {
    double least = stored[c], most = stored[c];
    for (std::size_t i = c; i < stored.size(); i += components) {
      least = std::min(least, stored[i]);
      most = std::max(most, stored[i]);
    }
    const bool whole = accessor["componentType"] != 5126;
    lower.push_back(whole ? Json(static_cast<std::int64_t>(least)) : Json(least));
    upper.push_back(whole ? Json(static_cast<std::int64_t>(most)) : Json(most));
  }
  accessor["min"] = std::move(lower);
  accessor["max"] = std::move(upper);
}

void take_decoded(const gltf::Document& document, Draft& draft) {
  const std::size_t views_in_file = list_of(draft, "bufferViews").size();
  Json& meshes = list_of(draft, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < document.meshes[m].primitives.size(); ++p)
      take_primitive(document, document.meshes[m].primitives[p], meshes[m]["primitives"][p], draft);
  std::vector<bool> decoded = take_views(draft);
  decoded.resize(views_in_file, false);
  Json& accessors = list_of(draft, "accessors");
  for (std::uint32_t i = 0; i < accessors.size(); ++i) {
    const std::uint32_t view = document.accessors[i].buffer_view;
    const bool from_draco = view != kNone && document.buffer_views[view].buffer == kNone;
    if (view == kNone || !(decoded[view] || from_draco) || !has_bounds(accessors[i])) continue;
    set_bounds(accessors[i], read_stored(document, i), element_layout(document.accessors[i]).components());
  }
  for (const char* name : {kDraco, "EXT_meshopt_compression", "KHR_meshopt_compression"}) undeclare(draft, name);
}

}  // namespace sinew::rewrite
