// SPDX-License-Identifier: MIT
#include "tests/importer/glb_seeds.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#pragma GCC diagnostic pop
#include <meshoptimizer.h>

#include <cstdint>
#include <cstring>

#include "tests/importer/encoded_images.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

/// Collects binary data and its description: each put() makes one buffer view, aligned to 4.
class Bin {
 public:
  template <class T>
  std::size_t put(const std::vector<T>& values) {
    const std::size_t offset = bytes.size(), size = values.size() * sizeof(T);
    bytes.resize(offset + (size + 3) / 4 * 4);
    std::memcpy(bytes.data() + offset, values.data(), size);
    views.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
    return views.size() - 1;
  }

  template <class T>
  std::size_t accessor(const std::vector<T>& values, int component, const char* type, std::size_t count) {
    accessors.push_back({{"bufferView", put(values)}, {"componentType", component}, {"type", type}, {"count", count}});
    return accessors.size() - 1;
  }

  std::vector<std::byte> file(Json json) {
    json["asset"] = {{"version", "2.0"}};
    json["buffers"] = {{{"byteLength", bytes.size()}}};
    json["bufferViews"] = views;
    if (!accessors.empty()) json["accessors"] = accessors;
    return make_glb(json.dump(), bytes);
  }

  std::vector<std::byte> bytes;
  Json views = Json::array(), accessors = Json::array();
};

constexpr int kU8 = 5121, kU16 = 5123, kFloat = 5126;

std::vector<std::byte> skinned() {
  Bin bin;
  const auto positions = bin.accessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, kFloat, "VEC3", 4);
  const auto texcoords = bin.accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, kFloat, "VEC2", 4);
  const auto joints = bin.accessor<std::uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, kU8, "VEC4", 4);
  const auto weights = bin.accessor<float>({1, 0, 0, 0, .5f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, kFloat, "VEC4", 4);
  const auto indices = bin.accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, kU16, "SCALAR", 6);
  const auto binds = bin.accessor<float>(
      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}, kFloat, "MAT4",
      2);
  const auto times = bin.accessor<float>({0, 0.5f, 1}, kFloat, "SCALAR", 3);
  bin.accessors[times]["min"] = {0};
  bin.accessors[times]["max"] = {1};
  const auto turns = bin.accessor<float>({0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1}, kFloat, "VEC4", 3);
  const auto cubic = bin.accessor<float>(std::vector<float>(27, 0.25f), kFloat, "VEC3", 9);
  const auto image = bin.put(encode_png(2, 2, 3, std::vector<std::uint8_t>(12, 200)));
  const Json channel = {{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}};
  return bin.file(
      {{"scene", 0},
       {"scenes", {{{"nodes", {0, 1}}}}},
       {"nodes",
        {{{"mesh", 0}, {"skin", 0}},
         {{"children", {2}}, {"camera", 0}},
         {{"translation", {0, 1, 0}}, {"name", "tip"}}}},
       {"cameras", {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}}},
       {"skins", {{{"joints", {1, 2}}, {"inverseBindMatrices", binds}}}},
       {"images", {{{"bufferView", image}, {"mimeType", "image/png"}}}},
       {"textures", {{{"source", 0}, {"sampler", 0}}}},
       {"samplers", {{{"minFilter", 9987}, {"wrapS", 33071}}}},
       {"materials",
        {{{"normalTexture", {{"index", 0}}}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}}},
       {"meshes",
        {{{"primitives",
           {{{"attributes",
              {{"POSITION", positions}, {"TEXCOORD_0", texcoords}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
             {"indices", indices},
             {"material", 0}}}}}}},
       {"animations",
        {{{"samplers",
           {{{"input", times}, {"output", turns}},
            {{"input", times}, {"output", cubic}, {"interpolation", "CUBICSPLINE"}}}},
          {"channels", {channel, {{"sampler", 1}, {"target", {{"node", 2}, {"path", "translation"}}}}}}}}}});
}

std::vector<std::byte> morphed() {
  Bin bin;
  const auto positions = bin.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, kFloat, "VEC3", 3);
  bin.accessors.push_back({{"componentType", kFloat},
                           {"type", "VEC3"},
                           {"count", 3},
                           {"sparse",
                            {{"count", 1},
                             {"indices", {{"bufferView", bin.put<std::uint16_t>({2})}, {"componentType", kU16}}},
                             {"values", {{"bufferView", bin.put<float>({0, 0, 1})}}}}}});
  const std::size_t target = bin.accessors.size() - 1;
  const auto times = bin.accessor<float>({0, 1}, kFloat, "SCALAR", 2);
  const auto keys = bin.accessor<float>({0, 1, 1, 0}, kFloat, "SCALAR", 4);
  return bin.file(
      {{"nodes", {{{"mesh", 0}, {"weights", {0.5, 0.25}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}}},
       {"extensionsUsed", {"KHR_lights_punctual"}},
       {"extensions",
        {{"KHR_lights_punctual", {{"lights", {{{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}}}}}}},
       {"meshes",
        {{{"primitives",
           {{{"attributes", {{"POSITION", positions}}},
             {"mode", 5},
             {"targets", {{{"POSITION", target}}, {{"POSITION", target}}}}}}}}}},
       {"animations",
        {{{"samplers", {{{"input", times}, {"output", keys}, {"interpolation", "STEP"}}}},
          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}}}});
}

std::vector<std::byte> meshopt() {
  const std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  std::vector<unsigned char> stream(meshopt_encodeVertexBufferBound(4, 12));
  meshopt_encodeVertexVersion(0);
  stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), points.data(), 4, 12));
  Bin bin;
  bin.put(stream);
  const Json description = {
      {"buffer", 0}, {"byteLength", stream.size()}, {"byteStride", 12}, {"count", 4}, {"mode", "ATTRIBUTES"}};
  bin.views[0] = {{"buffer", 1}, {"byteLength", 48}, {"extensions", {{"EXT_meshopt_compression", description}}}};
  bin.accessors.push_back({{"bufferView", 0}, {"componentType", kFloat}, {"type", "VEC3"}, {"count", 4}});
  Json json = {{"extensionsRequired", {"EXT_meshopt_compression"}},
               {"extensionsUsed", {"EXT_meshopt_compression"}},
               {"nodes", {{{"mesh", 0}}}},
               {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"mode", 5}}}}}}}};
  json["asset"] = {{"version", "2.0"}};
  json["buffers"] = {{{"byteLength", bin.bytes.size()}},
                     {{"byteLength", 48}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  json["bufferViews"] = bin.views;
  json["accessors"] = bin.accessors;
  return make_glb(json.dump(), bin.bytes);
}

std::vector<std::byte> draco_compressed() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  builder.SetAttributeValuesForFace(position, draco::FaceIndex(0), p[0], p[1], p[2]);
  builder.SetAttributeValuesForFace(position, draco::FaceIndex(1), p[0], p[2], p[3]);
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(*mesh, &buffer).ok()) return {};
  Bin bin;
  bin.put(std::vector<char>(buffer.data(), buffer.data() + buffer.size()));
  bin.accessors = {{{"componentType", kU16}, {"type", "SCALAR"}, {"count", 6}},
                   {{"componentType", kFloat}, {"type", "VEC3"}, {"count", 4}}};
  const Json description = {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  return bin.file({{"extensionsRequired", {"KHR_draco_mesh_compression"}},
                   {"extensionsUsed", {"KHR_draco_mesh_compression"}},
                   {"nodes", {{{"mesh", 0}}}},
                   {"meshes",
                    {{{"primitives",
                       {{{"attributes", {{"POSITION", 1}}},
                         {"indices", 0},
                         {"extensions", {{"KHR_draco_mesh_compression", description}}}}}}}}}});
}

void append_u32(std::vector<std::byte>& out, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>(value >> shift & 255));
}

}  // namespace

std::vector<std::byte> make_glb(std::string json, std::vector<std::byte> bin) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  bin.resize((bin.size() + 3) / 4 * 4);
  std::vector<std::byte> out;
  for (const std::size_t word : {std::size_t{0x46546C67}, std::size_t{2}, 12 + 8 + json.size() + 8 + bin.size(),
                                 json.size(), std::size_t{0x4E4F534A}})
    append_u32(out, word);
  for (const char c : json) out.push_back(static_cast<std::byte>(c));
  append_u32(out, bin.size());
  append_u32(out, 0x004E4942);
  out.insert(out.end(), bin.begin(), bin.end());
  return out;
}

std::vector<std::vector<std::byte>> glb_seeds() { return {skinned(), morphed(), meshopt(), draco_compressed()}; }

}  // namespace sinew::test
