// SPDX-License-Identifier: MIT
// Input: fields of fixed size that describe one compressed view or primitive, then the stream.
#include <array>
#include <utility>

#include "importer/decode/decode_draco.h"
#include "importer/decode/decode_meshopt.h"
#include "importer/read/accessor.h"
#include "importer/read/check_accessors.h"
#include "tests/fuzz/input_reader.h"

namespace sinew::fuzz {
namespace {

using gltf::Json;

constexpr std::array<const char*, 3> kModes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr std::array<const char*, 5> kFilters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};
constexpr std::array<gltf::ComponentType, 6> kTypes{gltf::ComponentType::f32, gltf::ComponentType::u8,
                                                    gltf::ComponentType::u16, gltf::ComponentType::u32,
                                                    gltf::ComponentType::i8,  gltf::ComponentType::i16};
constexpr std::array<std::pair<const char*, gltf::ElementType>, 4> kSemantics{{{"POSITION", gltf::ElementType::vec3},
                                                                               {"NORMAL", gltf::ElementType::vec3},
                                                                               {"TEXCOORD_0", gltf::ElementType::vec2},
                                                                               {"JOINTS_0", gltf::ElementType::vec4}}};

gltf::Document one_buffer(Bytes stream) {
  gltf::Document document;
  document.buffers.push_back({.byte_length = stream.size(), .extensions = {}, .bytes = stream});
  return document;
}

void meshopt(InputReader in) {
  const std::uint32_t stride = in.u8(), count = in.u16();
  const char *mode = in.one_of(kModes), *filter = in.one_of(kFilters);
  const char* name = in.u8() % 2 == 0 ? "EXT_meshopt_compression" : "KHR_meshopt_compression";
  gltf::Document document = one_buffer(in.rest());
  gltf::BufferView view;
  view.buffer = 0;
  view.byte_length = std::uint64_t{stride} * count;
  view.extensions[name] = {{"buffer", 0},          {"byteLength", in.rest().size()},
                           {"byteStride", stride}, {"count", count},
                           {"mode", mode},         {"filter", filter}};
  document.buffer_views.push_back(std::move(view));
  IssueLog log;
  DecodeBudget budget(in.rest().size());
  decode_meshopt(document, budget, log);
  if (log.ok())
    require(document.buffer_views[0].bytes.size() == document.buffer_views[0].byte_length, "a decoded view is full");
}

void draco(InputReader in) {
  const std::uint64_t vertices = in.u16(), indices = in.u16();
  Json attributes = Json::object();
  gltf::Primitive primitive;
  primitive.mode = in.u8() % 2 == 0 ? TINYGLTF_MODE_TRIANGLES : TINYGLTF_MODE_TRIANGLE_STRIP;
  primitive.indices = 0;
  gltf::Document document;
  document.accessors.push_back({.count = indices, .sparse = {}, .min = {}, .max = {}});
  for (const auto& [semantic, type] : kSemantics) {
    const std::uint32_t id = in.u8();
    if (id == 255) continue;
    attributes[semantic] = id;
    primitive.attributes[semantic] = static_cast<int>(document.accessors.size());
    document.accessors.push_back(
        {.count = vertices, .component_type = in.one_of(kTypes), .type = type, .sparse = {}, .min = {}, .max = {}});
  }
  primitive.extensions["KHR_draco_mesh_compression"] = {{"bufferView", 0}, {"attributes", attributes}};
  document.buffers = one_buffer(in.rest()).buffers;
  document.buffer_views.push_back({.buffer = 0, .byte_length = in.rest().size(), .extensions = {}, .bytes = in.rest()});
  document.meshes.resize(1);
  document.meshes[0].primitives.push_back(std::move(primitive));
  IssueLog log;
  DecodeBudget budget(in.rest().size());
  decode_draco(document, budget, log);
  if (!log.ok()) return;
  check_accessors(document, log);
  require(log.ok(), "decoded accessors fit their views");
  const auto& filled = document.meshes[0].primitives[0].attributes;
  for (const std::uint32_t index : read_unsigned(document, 0))
    for (const auto& [semantic, accessor] : filled)
      require(index < document.accessors[accessor].count, "decoded indices name vertices");
}

}  // namespace

void decode_compressed(Bytes input) {
  InputReader in(input);
  in.u8() % 2 == 0 ? meshopt(in) : draco(in);
}

}  // namespace sinew::fuzz
