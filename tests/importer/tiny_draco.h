// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {

/// Vertex values by the name of their attribute: for each vertex as many floats as the attribute has components.
using TriangleValues = std::map<std::string, std::vector<float>>;

/// Encodes triangles as a Draco stream without quantization; the encoder chooses the vertex order.
/// in   corners  [3 * triangles] vertices of `values`; all vertices are used and distinct
/// out  ids      Draco id of each attribute
std::vector<std::byte> draco_stream(const TriangleValues& values, const std::vector<std::uint32_t>& corners,
                                    std::map<std::string, int>& ids);

/// Same, for one triangle.
std::vector<std::byte> draco_triangle(const TriangleValues& values, std::map<std::string, int>& ids);

/// A document of one primitive with KHR_draco_mesh_compression. JOINTS_0 is stored as bytes.
TinyGltf draco_document(const TriangleValues& values, const std::vector<std::uint32_t>& corners = {0, 1, 2});

}  // namespace sinew::test
