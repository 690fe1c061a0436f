// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {

/// The values of one attribute: as many floats a vertex as the attribute has components.
using TriangleValues = std::map<std::string, std::vector<float>>;

/// Encodes triangles as a Draco stream without quantization; the encoder chooses the vertex order.
/// in   corners  [3 * triangles] vertices of `values`; all vertices are used and distinct
/// out  ids      Draco id of each attribute
std::vector<std::byte> draco_stream(const TriangleValues& values, const std::vector<std::uint32_t>& corners,
                                    std::map<std::string, int>& ids);

/// One triangle.
std::vector<std::byte> draco_triangle(const TriangleValues& values, std::map<std::string, int>& ids);

/// A document with one primitive: the triangles under KHR_draco_mesh_compression. JOINTS_0 is of bytes.
TinyGltf draco_document(const TriangleValues& values, const std::vector<std::uint32_t>& corners = {0, 1, 2});

}  // namespace sinew::test
