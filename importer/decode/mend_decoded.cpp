// SPDX-License-Identifier: MIT
#include "importer/decode/mend_decoded.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include "importer/read/accessor.h"

namespace sinew {
namespace {

/// The floats of one decoded attribute, changed in place in the document's storage.
class DecodedFloats {
 public:
  DecodedFloats(gltf::Document& document, std::uint32_t accessor) {
    const gltf::Accessor& source = document.accessors[accessor];
    if (source.buffer_view == kNone || source.component_type != gltf::ComponentType::f32) return;
    components_ = element_layout(source).components();
    const gltf::Bytes bytes = document.buffer_views[source.buffer_view].bytes;
    for (auto& block : document.storage)
      if (block.data() == bytes.data()) bytes_ = std::span(block).first(bytes.size());
  }

  std::size_t size() const noexcept { return bytes_.size() / sizeof(float); }
  std::size_t components() const noexcept { return components_; }

  float at(std::size_t i) const {
    float value = 0.0f;
    std::memcpy(&value, bytes_.data() + i * sizeof(float), sizeof(float));
    return value;
  }
  void set(std::size_t i, float value) { std::memcpy(bytes_.data() + i * sizeof(float), &value, sizeof(float)); }

 private:
  std::span<std::byte> bytes_;
  std::size_t components_ = 1;
};

/// out   number of values outside [0, 1]
std::size_t clamp(DecodedFloats& values) {
  std::size_t odd = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float value = values.at(i), inside = std::clamp(value, 0.0f, 1.0f);
    if (value == inside || std::isnan(value)) continue;
    values.set(i, inside);
    ++odd;
  }
  return odd;
}

/// out   number of vertices whose weights did not sum to 1
std::size_t normalise(std::vector<DecodedFloats>& sets) {
  constexpr double kRounding = 0x1p-24;  // rounding error of one weight
  std::size_t odd = 0, vertices = sets.empty() ? 0 : sets.front().size() / 4;
  for (const DecodedFloats& set : sets) vertices = std::min(vertices, set.size() / 4);
  for (std::size_t v = 0; v < vertices; ++v) {
    double sum = 0.0;
    for (const DecodedFloats& set : sets)
      for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) sum += static_cast<double>(set.at(k));
    if (!(sum > 0.0) || std::abs(sum - 1.0) <= kRounding * 4.0 * static_cast<double>(sets.size())) continue;
    for (DecodedFloats& set : sets)
      for (std::size_t k = 4 * v; k < 4 * v + 4; ++k)
        set.set(k, static_cast<float>(static_cast<double>(set.at(k)) / sum));
    ++odd;
  }
  return odd;
}

void make_signs(DecodedFloats& tangents) {
  for (std::size_t i = 3; i < tangents.size() && tangents.components() == 4; i += 4)
    tangents.set(i, tangents.at(i) < 0.0f ? -1.0f : 1.0f);
}

}  // namespace

void mend_decoded(gltf::Document& document, const gltf::Primitive& primitive, const gltf::Json& decoded,
                  const std::string& place, IssueLog& log) {
  std::vector<DecodedFloats> weights;
  std::size_t outside = 0;
  for (const auto& [semantic, id] : decoded.items()) {
    const auto found = primitive.attributes.find(semantic);
    if (found == primitive.attributes.end()) continue;
    DecodedFloats values(document, found->second);
    if (semantic.starts_with("COLOR_") || semantic.starts_with("WEIGHTS_")) outside += clamp(values);
    if (semantic.starts_with("WEIGHTS_") && values.components() == 4) weights.push_back(values);
    if (semantic == "TANGENT") make_signs(values);
  }
  const std::size_t sums = normalise(weights);
  if (outside + sums > 0)
    log.report(Rule::draco_range, place,
               std::to_string(outside) + " colours and weights outside [0, 1] are clamped; the weights of " +
                   std::to_string(sums) + " vertices are divided by their sum");
}

void forget_bounds(gltf::Document& document, const gltf::Primitive& primitive) {
  const auto forget = [&](std::uint32_t accessor) {
    if (accessor == kNone || document.accessors[accessor].buffer_view != kNone) return;
    document.accessors[accessor].min.clear();
    document.accessors[accessor].max.clear();
  };
  forget(primitive.indices);
  for (const auto& [semantic, accessor] : primitive.attributes) forget(accessor);
}

}  // namespace sinew
