// SPDX-License-Identifier: MIT
#include "tests/importer/tiny_draco.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#pragma GCC diagnostic pop

#include <cstdint>
#include <cstring>

namespace sinew::test {
namespace {

bool is_joints(const std::string& semantic) { return semantic.starts_with("JOINTS_"); }

std::size_t vertex_count(const TriangleValues& values) { return values.at("POSITION").size() / 3; }

/// Sets the values of an attribute at all corners, converted to the attribute's type.
template <class T>
void set_values(draco::TriangleSoupMeshBuilder& builder, int attribute, const std::vector<float>& values,
                std::size_t vertices, const std::vector<std::uint32_t>& corners) {
  const std::vector<T> v(values.begin(), values.end());
  const std::size_t n = v.size() / vertices;
  for (std::uint32_t face = 0; face < corners.size() / 3; ++face) {
    const auto at = [&](std::uint32_t corner) { return v.data() + n * corners[3 * face + corner]; };
    builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(face), at(0), at(1), at(2));
  }
}

}  // namespace

std::vector<std::byte> draco_stream(const TriangleValues& values, const std::vector<std::uint32_t>& corners,
                                    std::map<std::string, int>& ids) {
  const std::size_t vertices = vertex_count(values);
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(corners.size() / 3));
  for (const auto& [semantic, list] : values) {
    const auto type = semantic == "POSITION" ? draco::GeometryAttribute::POSITION : draco::GeometryAttribute::GENERIC;
    const auto components = static_cast<std::int8_t>(list.size() / vertices);
    ids[semantic] = builder.AddAttribute(type, components, is_joints(semantic) ? draco::DT_UINT8 : draco::DT_FLOAT32);
  }
  for (const auto& [semantic, list] : values) {
    if (is_joints(semantic))
      set_values<std::uint8_t>(builder, ids[semantic], list, vertices, corners);
    else
      set_values<float>(builder, ids[semantic], list, vertices, corners);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(*mesh, &buffer).ok()) return {};
  std::vector<std::byte> out(buffer.size());
  std::memcpy(out.data(), buffer.data(), buffer.size());
  return out;
}

std::vector<std::byte> draco_triangle(const TriangleValues& values, std::map<std::string, int>& ids) {
  return draco_stream(values, {0, 1, 2}, ids);
}

TinyGltf draco_document(const TriangleValues& values, const std::vector<std::uint32_t>& corners) {
  static const char* const kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  std::map<std::string, int> ids;
  const std::vector<std::byte> stream = draco_stream(values, corners, ids);
  const std::size_t vertices = vertex_count(values);
  TinyGltf gltf;
  const std::size_t view = gltf.add_view(stream);
  Json attributes;
  for (const auto& [semantic, list] : values) {
    gltf.root["accessors"].push_back({{"componentType", is_joints(semantic) ? 5121 : 5126},
                                      {"count", vertices},
                                      {"type", kTypes[list.size() / vertices]}});
    attributes[semantic] = gltf.root["accessors"].size() - 1;
  }
  gltf.root["accessors"].push_back({{"componentType", 5123}, {"count", corners.size()}, {"type", "SCALAR"}});
  const Json extension{{"bufferView", view}, {"attributes", ids}};
  const Json primitive{{"attributes", attributes},
                       {"indices", gltf.root["accessors"].size() - 1},
                       {"extensions", {{"KHR_draco_mesh_compression", extension}}}};
  gltf.root["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
  gltf.root["nodes"] = Json::array({{{"mesh", 0}}});
  gltf.root["extensionsUsed"] = gltf.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return gltf;
}

}  // namespace sinew::test
