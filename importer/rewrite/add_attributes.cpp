// SPDX-License-Identifier: MIT
#include "importer/rewrite/add_attributes.h"

#include <cstring>
#include <utility>

#include "runtime/base/contract.h"

namespace sinew::rewrite {
namespace {

constexpr int kVertexBuffer = 34962, kFloat = 5126;

std::uint32_t index_of(const Json& number) { return static_cast<std::uint32_t>(number.get<double>()); }

/// A view and an accessor of floats; returns the accessor's index.
std::size_t add_floats(std::span<const float> values, Draft& draft) {
  std::vector<std::byte> bytes(values.size_bytes());
  std::memcpy(bytes.data(), values.data(), bytes.size());
  const std::uint32_t view = draft.add_view(std::move(bytes));
  draft.json["bufferViews"][view]["target"] = kVertexBuffer;
  Json& accessors = draft.json["accessors"];
  accessors.push_back({{"bufferView", view}, {"componentType", kFloat}, {"count", values.size()}, {"type", "SCALAR"}});
  return accessors.size() - 1;
}

}  // namespace

void add_attributes(std::span<const AddedAttribute> added, Draft& draft) {
  for (const AddedAttribute& attribute : added) {
    const std::size_t accessor = add_floats(attribute.values, draft);
    Json& attributes = draft.json["meshes"][attribute.mesh]["primitives"][attribute.primitive]["attributes"];
    CONTRACT(draft.json["accessors"][index_of(attributes.at("POSITION"))]["count"] == attribute.values.size());
    if (const auto old = attributes.find(attribute.name); old != attributes.end()) {
      const std::uint32_t spare = index_of(*old);
      draft.spare_accessors.insert(spare);
      if (const Json& replaced = draft.json["accessors"][spare]; replaced.contains("bufferView"))
        draft.spare_views.insert(index_of(replaced["bufferView"]));
    }
    attributes[attribute.name] = accessor;
  }
}

}  // namespace sinew::rewrite
