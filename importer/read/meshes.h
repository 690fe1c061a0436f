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

/// One JOINTS_n / WEIGHTS_n pair, four entries a vertex.
struct InfluenceSet {
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

/// A primitive in the file's vertex order: attributes, unrolled indices and material are filled, influences and morph
/// targets are not.
struct PrimitiveData {
  Primitive primitive;
  std::vector<InfluenceSet> influence_sets;
};

/// Reads the vertices of a primitive. Without POSITION it stays empty, but keeps its place in the mesh.
/// err  mesh-attribute-format, mesh-attribute-count, mesh-indices, mesh-index, not-finite
/// warning mesh-no-position, mesh-mode, mesh-joint-sets, mesh-texcoord-gap, mesh-normal-length, mesh-tangent-sign,
///         mesh-tangent-without-normal, mesh-indices-stride, mesh-quantization
PrimitiveData read_primitive(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive,
                             IssueLog& log);

/// Whether all components are finite; `indices` name the elements of the values, empty where they are all in order.
/// err  not-finite
template <class V>
bool check_finite(std::span<const V> values, std::span<const std::uint32_t> indices, std::size_t components,
                  const std::string& place, IssueLog& log);

/// Numbers of a vertex attribute as V (float for all components in a row, or glm::vec2, vec3, vec4), checked to be
/// finite; empty after an error.   err  not-finite
template <class V>
std::vector<V> read_finite(const gltf::Document& document, std::uint32_t accessor, const std::string& place,
                           IssueLog& log);

}  // namespace sinew
