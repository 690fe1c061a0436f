// SPDX-License-Identifier: MIT
#include "importer/rewrite/add_attributes.h"

#include <cstring>
#include <utility>

#include "runtime/base/contract.h"

namespace sinew::rewrite {
namespace {

constexpr int kVertexBuffer = 34962;

/// Adds a view and an accessor of floats; returns the accessor's index.
std::size_t add_floats(std::span<const float> values, Draft& draft) {
  std::vector<std::byte> bytes(values.size_bytes());
  std::memcpy(bytes.data(), values.data(), bytes.size());
  const std::uint32_t view = draft.add_view(std::move(bytes));
  draft.json["bufferViews"][view]["target"] = kVertexBuffer;
  Json& accessors = draft.json["accessors"];
  accessors.push_back({{"bufferView", view}, {"componentType", kFloat}, {"count", values.size()}, {"type", "SCALAR"}});
  return accessors.size() - 1;
}

/// Removes one attribute, if present.
void leave_out(const std::string& name, Json& attributes, Draft& draft) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return;
  draft.spare_accessors.insert(index_of(*found));
  attributes.erase(found);
}

}  // namespace

void leave_out_attributes(std::span<const std::string> names, Draft& draft) {
  for (Json& mesh : list_of(draft, "meshes"))
    for (Json& primitive : mesh["primitives"])
      for (const std::string& name : names) leave_out(name, primitive["attributes"], draft);
}

void add_attributes(std::span<const AddedAttribute> added, Draft& draft) {
  for (const AddedAttribute& attribute : added) {
    const std::size_t accessor = add_floats(attribute.values, draft);
    Json& attributes = draft.json["meshes"][attribute.mesh]["primitives"][attribute.primitive]["attributes"];
    CONTRACT(draft.json["accessors"][index_of(attributes.at("POSITION"))]["count"] == attribute.values.size());
    leave_out(attribute.name, attributes, draft);
    attributes[attribute.name] = accessor;
  }
}

}  // namespace sinew::rewrite
