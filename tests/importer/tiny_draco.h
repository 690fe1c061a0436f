// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {

/// The values of one attribute of a triangle: as many floats a vertex as the attribute has components.
using TriangleValues = std::map<std::string, std::vector<float>>;

/// A triangle as a Draco stream that is not quantised. `ids` gets the number of each attribute.
std::vector<std::byte> draco_triangle(const TriangleValues& values, std::map<std::string, int>& ids);

/// A document with one primitive: the triangle under KHR_draco_mesh_compression. JOINTS_0 is of bytes.
TinyGltf draco_document(const TriangleValues& values);

}  // namespace sinew::test
