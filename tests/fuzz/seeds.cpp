// SPDX-License-Identifier: MIT
#include "tests/fuzz/seeds.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>

#include <nlohmann/json.hpp>

#include "importer/export_glb.h"
#include "importer/file/data_uri.h"
#include "importer/file/glb_container.h"
#include "importer/file/meshopt_extension.h"
#include "importer/geometry_cache/encode_geometry_cache.h"
#include "importer/graph/graph_text.h"
#include "importer/import_gltf.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/clip/clip_file.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/graph/graph_bytes.h"
#include "runtime/lod/clip_bounds.h"
#include "runtime/model/mesh.h"
#include "samples/showcase/showcase.h"
#include "tests/asset_file/full_scene.h"
#include "tests/fuzz/graph_seed.h"
#include "tests/importer/encoded_images.h"
#include "tests/importer/glb_seeds.h"
#include "tests/importer/ktx2_samples.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/fixed_random.h"

namespace sinew::fuzz {
namespace {

using test::Json;
using Blob = std::vector<std::byte>;

constexpr std::size_t kLargest = 30'000;
constexpr std::size_t kLargestDocument = 6'000;  ///< of a whole file; small files are parsed and changed faster

Blob blob(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

void append(Blob& out, const Blob& more) { out.insert(out.end(), more.begin(), more.end()); }

/// A document and the bytes of its buffers.
struct OpenFile {
  Json json;
  std::vector<Blob> buffers;

  /// The bytes of one stream of a buffer; empty if it leaves the buffer.
  Blob slice(const Json& view) const {
    const auto index = view.value("buffer", std::size_t{0}), from = view.value("byteOffset", std::size_t{0}),
               size = view.value("byteLength", std::size_t{0});
    if (index >= buffers.size() || from > buffers[index].size() || size > buffers[index].size() - from) return {};
    const auto first = buffers[index].begin() + static_cast<std::ptrdiff_t>(from);
    return {first, first + static_cast<std::ptrdiff_t>(size)};
  }
};

Blob read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return blob({std::istreambuf_iterator<char>(stream), {}});
}

OpenFile open_file(const Blob& bytes, const std::filesystem::path& folder) {
  OpenFile out;
  IssueLog log;
  Container parts{bytes, std::nullopt};
  if (looks_like_glb(bytes))
    if (const auto glb = open_glb(bytes, log)) parts = *glb;
  const auto* text = reinterpret_cast<const char*>(parts.json.data());
  out.json = Json::parse(text, text + parts.json.size());
  for (const Json& buffer : out.json.value("buffers", Json::array())) {
    const std::string uri = buffer.value("uri", "");
    if (is_data_uri(uri)) {
      out.buffers.push_back(decode_data_uri(uri).value_or(DataUri{}).bytes);
    } else if (uri.empty()) {
      out.buffers.push_back(parts.bin ? Blob(parts.bin->begin(), parts.bin->end()) : Blob());
    } else {
      out.buffers.push_back(read_file(folder / uri));
    }
  }
  return out;
}

std::string data_uri(const Blob& bytes) { return "data:application/octet-stream;base64," + test::base64(bytes); }

Blob as_text(OpenFile file) {
  for (std::size_t i = 0; i < file.buffers.size(); ++i)
    if (!file.buffers[i].empty()) file.json["buffers"][i]["uri"] = data_uri(file.buffers[i]);
  return blob(file.json.dump());
}

/// The file as .glb: buffer 0 in the BIN chunk, others as data URIs.
Blob as_glb(OpenFile file) {
  for (std::size_t i = 1; i < file.buffers.size(); ++i)
    if (!file.buffers[i].empty()) file.json["buffers"][i]["uri"] = data_uri(file.buffers[i]);
  if (!file.buffers.empty()) file.json["buffers"][0].erase("uri");
  return test::make_glb(file.json.dump(), file.buffers.empty() ? Blob() : file.buffers[0]);
}

Blob fields(std::initializer_list<std::size_t> bytes) {
  Blob out;
  for (const std::size_t byte : bytes) out.push_back(static_cast<std::byte>(byte));
  return out;
}

/// Adds the streams in the input format of compressed_target.cpp.
void add_meshopt_streams(const OpenFile& file, std::vector<Seed>& out) {
  for (const Json& view : file.json.value("bufferViews", Json::array())) {
    const Json extensions = view.value("extensions", Json());
    const MeshoptExtension extension = meshopt_extension(extensions);
    if (!extension) continue;
    const Json& stream = *extension.value;
    const auto count = stream.value("count", std::size_t{0});
    const std::string mode = stream.value("mode", ""), filter = stream.value("filter", "NONE");
    const std::size_t mode_byte = mode == "TRIANGLES" ? 1 : mode == "INDICES" ? 2 : 0;
    const std::size_t filter_byte = filter == "OCTAHEDRAL"    ? 1
                                    : filter == "QUATERNION"  ? 2
                                    : filter == "EXPONENTIAL" ? 3
                                    : filter == "COLOR"       ? 4
                                                              : 0;
    Blob seed = fields(
        {0, stream.value("byteStride", std::size_t{0}), count & 255, count >> 8 & 255, mode_byte, filter_byte, 0});
    append(seed, file.slice(stream));
    if (seed.size() < kLargest) out.push_back({"compressed", std::move(seed)});
  }
}

void add_draco_streams(const OpenFile& file, std::vector<Seed>& out) {
  const Json accessors = file.json.value("accessors", Json::array()),
             views = file.json.value("bufferViews", Json::array());
  for (const Json& mesh : file.json.value("meshes", Json::array()))
    for (const Json& primitive : mesh.value("primitives", Json::array())) {
      const Json extension = primitive.value(Json::json_pointer("/extensions/KHR_draco_mesh_compression"), Json());
      if (!extension.is_object()) continue;
      const auto count_of = [&](const Json& index) {
        return accessors.at(index.get<std::size_t>()).at("count").get<std::size_t>();
      };
      const std::size_t vertices = count_of(primitive["attributes"]["POSITION"]),
                        indices = count_of(primitive["indices"]);
      Blob seed = fields({1, vertices & 255, vertices >> 8 & 255, indices & 255, indices >> 8 & 255, 0});
      for (const char* semantic : {"POSITION", "NORMAL", "TEXCOORD_0", "JOINTS_0"}) {
        const std::size_t id = extension["attributes"].value(semantic, std::size_t{255});
        append(seed, fields({id}));
        if (id != 255) append(seed, fields({std::string_view(semantic) == "JOINTS_0" ? 2u : 0u}));
      }
      append(seed, file.slice(views.at(extension["bufferView"].get<std::size_t>())));
      if (seed.size() < kLargest) out.push_back({"compressed", std::move(seed)});
    }
}

void add_document(const Blob& bytes, const std::filesystem::path& folder, std::vector<Seed>& out) {
  const OpenFile file = open_file(bytes, folder);
  if (Blob text = as_text(file); text.size() < kLargestDocument) out.push_back({"json", std::move(text)});
  if (Blob glb = as_glb(file); glb.size() < kLargestDocument) out.push_back({"glb", std::move(glb)});
  add_meshopt_streams(file, out);
  add_draco_streams(file, out);
}

/// Adds three elements of four bytes in version 1 of the attribute codec, which the library in use cannot write.
void add_attribute_stream(std::vector<Seed>& out) {
  Blob seed = fields({0, 4, 3, 0, 0, 4, 1, 0xa1, 0x55, 0, 6, 0, 8, 8, 0, 6, 0, 8, 8, 0, 6, 0, 8, 8, 0, 6, 0, 8, 8});
  seed.resize(seed.size() + 19);
  append(seed, fields({1, 2, 3, 4, 0}));
  out.push_back({"compressed", std::move(seed)});
}

/// An input in the format of accessors_target.cpp: one view of 600 bytes and seven accessors on it. Each accessor is
/// used in every way that its type allows.
Blob accessor_seed() {
  Blob seed = fields({0, 0, 0, 87, 2, 0, 6});
  append(seed, fields({0, 0, 11, 0, 8, 0, 0, 0}));                      // 0: 12 positions
  append(seed, fields({2, 1, 11, 0, 0, 0, 28, 2}));                     // 1: 12 indices
  append(seed, fields({1, 2, 11, 0, 0, 0, 28, 2}));                     // 2: 12 x 4 joints
  append(seed, fields({0, 1, 1, 0, 8, 0, 8, 1}));                       // 3: 2 times
  append(seed, fields({0, 2, 1, 0, 4, 0, 16, 1, 0, 0, 80, 1, 0, 16}));  // 4: 2 rotations, one of them sparse
  append(seed, fields({0, 4, 1, 0, 0, 0, 0, 1}));                       // 5: 2 matrices
  append(seed, fields({1, 2, 11, 0, 2, 0, 200, 0}));                    // 6: 12 x 4 normalised weights
  append(seed, fields({7, 7, 0, 0, 0, 2, 6, 0, 0, 1, 4, 1, 7, 0, 0, 5, 1, 2, 1, 3, 4, 0}));
  for (std::size_t i = 0; i < 150; ++i)
    append(seed, i < 135 && i % 3 != 0 ? fields({0, 0, 128, 63}) : fields({0, 0, 0, 0}));
  return seed;
}

constexpr const char* kMotion =
    "HIERARCHY\nROOT a b\n{\n OFFSET 0 1 0\n CHANNELS 4 Xposition Zrotation Xrotation Yrotation\n JOINT c\n {\n"
    " OFFSET 1 0 0\n CHANNELS 3 Yrotation Xposition Yrotation\n End Site\n {\n OFFSET 0 1 0\n }\n }\n}\n"
    "ROOT d\n{\n OFFSET 0 0 0\n}\nMOTION\nFrames: 2\nFrame Time: .0333\n1 2 3 4 5 6 7\n-1 2e1 +3 4. 5 6 7\n";

constexpr const char* kPoses =
    R"({"extent": 2.5, "clips": [{"clip": null, "samples": [{"time": 0.0, "nonUnit": 0.5, "nodes": [{"node": 0, )"
    R"("world": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, -2e-3, 3, 1]}], "weights": [{"node": 0, "weights": [0.25, 1]}], )"
    R"("skinned": [{"node": 0, "mesh": 0, "primitive": 0, "vertices": [0, 7], "positions": [[0, 1, 2], null], )"
    R"("normals": [[0, 0, 1], [1, 0, 0]], "tangents": [[1, 0, 0, -1], null], "dqs": [[0, 1, 2], [3, 4, 5]]}]}]}, )"
    R"({"clip": 0, "name": "a", "samples": []}]})";

/// Adds compiled clips of the showcase, without their head.
void add_clips(const Scene& scene, std::vector<Seed>& out) {
  const VirtualVertices vertices = virtual_vertices(scene);
  for (const Animation& animation : scene.animations)
    for (const double budget_m : {0.0, 1e-3}) {
      const Clip clip = compile_clip_within(scene, animation, vertices, budget_m).clip;
      const Clip* const one = &clip;
      const Blob block = save_clips({&one, 1});
      if (block.size() < kLargest) out.push_back({"clips", Blob(block.begin() + kClipFileHead, block.end())});
    }
}

/// Adds asset files of a scene: an uncompressed one with animations, and a packed one without. Both have boxes of the
/// clips.
void add_assets(const Scene& scene, std::vector<Seed>& out) {
  ClipBoxes boxes;
  for (std::uint32_t clip = 0; clip < scene.clips.size(); ++clip) boxes.push_back(clip_boxes(scene, clip));
  for (const AssetFileOptions& options :
       {AssetFileOptions{.truth = true, .clip_boxes = boxes}, AssetFileOptions{.clip_boxes = boxes, .zstd_level = 1}})
    if (Blob file = write_asset_file(scene, options); file.size() < kLargest)
      out.push_back({"assets", std::move(file)});
}

/// Points that move independently (blocks without a matrix), or that rotate and stretch together (blocks with a
/// matrix).
GeometryTake any_take(std::uint32_t points, bool is_stiff, std::uint32_t frames) {
  test::FixedRandom random(3);
  GeometryTake take;
  TakeMesh& mesh = take.meshes.emplace_back();
  mesh.vertex_count = points;
  mesh.triangles = {0, 1, 2};
  if (points > 3) mesh.triangles.insert(mesh.triangles.end(), {2, 1, 3});
  mesh.streams.emplace_back().budget = 0.01;
  std::vector<glm::vec3> rest;
  while (rest.size() < points) rest.push_back(random.vec3(-1.0, 1.0));
  for (std::uint32_t f = 0; f < frames; ++f)
    for (auto& frame = mesh.streams[0].frames.emplace_back(); frame.size() < points;) {
      const glm::vec3 p = rest[frame.size()];
      const float t = 0.1f * static_cast<float>(f);
      frame.push_back(is_stiff ? glm::vec3(p.x - t * p.y, p.y + t * p.x + t * t, p.z) : random.vec3(-1.0, 1.0));
    }
  return take;
}

/// Adds small geometry caches: with one mesh, and with two meshes, one of which has normals.
void add_geometry(std::vector<Seed>& out) {
  for (const bool is_stiff : {false, true}) {
    GeometryTake take = any_take(70, is_stiff, 5);
    out.push_back({"geometry", *encode_geometry_cache(take, {.segment_frames = 4})});
    take.meshes.push_back(any_take(3, is_stiff, 5).meshes[0]);
    take.meshes[0].streams.push_back({GeometryKind::normals, take.meshes[0].streams[0].frames, 0.1});
    out.push_back({"geometry", *encode_geometry_cache(take, {.segment_frames = 4, .keep_triangles = false})});
  }
}

}  // namespace

std::vector<Seed> own_seeds() {
  std::vector<Seed> out;
  for (const Blob& glb : test::glb_seeds()) add_document(glb, {}, out);
  for (const auto& scene : showcase::showcase())
    if (const auto glb = export_glb(scene.scene)) {
      add_document(*glb, {}, out);
      add_clips(scene.scene, out);
    }
  add_assets(test::full_scene(1), out);
  add_geometry(out);
  add_attribute_stream(out);
  out.push_back({"accessors", accessor_seed()});
  const std::vector<std::uint8_t> pixels(4 * 5 * 4, 90);
  out.push_back({"images", test::encode_png(5, 4, 4, pixels)});
  out.push_back({"images", test::encode_jpeg(5, 4, 3, pixels)});
  out.push_back({"images", test::encode_webp(5, 4, pixels)});
  out.push_back({"images", test::encode_avif(5, 4, pixels)});
  for (const auto* sample : {&test::etc1s_sample(), &test::etc1s_alpha_sample(), &test::uastc_zstd_sample()})
    out.push_back({"images", sample->file});
  out.push_back({"poses", blob(kPoses)});
  out.push_back({"motion", blob(kMotion)});
  out.push_back({"graphs", blob(kGraphSeed)});
  out.push_back({"graphs", blob(kReferenceSeed)});
  if (const auto document = read_graph(kGraphSeed))
    if (const auto graph = compile_graph(*document)) out.push_back({"graph_bytes", write_graph_bytes(graph->tables())});
  return out;
}

std::vector<Seed> seeds_of_file(const std::filesystem::path& file) {
  std::vector<Seed> out;
  const Blob bytes = read_file(file);
  const std::string extension = file.extension().string();
  if (extension == ".png" || extension == ".jpg" || extension == ".webp" || extension == ".avif" ||
      extension == ".ktx2") {
    if (bytes.size() < kLargest) out.push_back({"images", bytes});
  } else if (extension == ".json") {
    if (bytes.size() < kLargest) out.push_back({"poses", bytes});
  } else {
    if (const auto imported = import_gltf(file, {.decode_images = false})) add_assets(imported->scene, out);
    try {
      add_document(bytes, file.parent_path(), out);
    } catch (const std::exception&) {  // cannot be taken apart: use the whole file as a seed
      if (bytes.size() < kLargestDocument) out.push_back({looks_like_glb(bytes) ? "glb" : "json", bytes});
    }
  }
  return out;
}

}  // namespace sinew::fuzz
