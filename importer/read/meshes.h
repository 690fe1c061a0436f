// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// One JOINTS_n / WEIGHTS_n pair, with four entries for each vertex.
struct InfluenceSet {
  std::uint32_t number;  ///< the n of JOINTS_n
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

/// A primitive in file vertex order. Attributes, unrolled indices and material are filled in; influences and morph
/// targets are not.
struct PrimitiveData {
  Primitive primitive;
  std::vector<InfluenceSet> influence_sets;
};

/// Reads the vertices and indices of a primitive. A primitive without POSITION stays empty, but keeps its index in the
/// mesh.
/// err      mesh-attribute-format, mesh-attribute-count, mesh-indices, mesh-index, not-finite
/// warning  mesh-no-position, mesh-mode, mesh-joint-sets, mesh-texcoord-gap, mesh-normal-length, mesh-tangent-sign,
///          mesh-tangent-without-normal, mesh-attribute-name, mesh-indices-stride, mesh-quantization
PrimitiveData read_primitive(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive,
                             IssueLog& log);

/// True if all components are finite. `indices` are the element numbers for reports; empty = 0, 1, 2 ...
/// err  not-finite
template <class V>
bool check_finite(std::span<const V> values, std::span<const std::uint32_t> indices, std::size_t components,
                  const std::string& place, IssueLog& log);

/// Reads a vertex attribute as V (glm::vec2, vec3, vec4, or float for all components in a row) and checks that it is
/// finite; empty after an error.   err   not-finite
template <class V>
std::vector<V> read_finite(const gltf::Document& document, std::uint32_t accessor, const std::string& place,
                           IssueLog& log);

}  // namespace sinew
