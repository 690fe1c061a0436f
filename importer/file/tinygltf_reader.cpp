// SPDX-License-Identifier: MIT
#include "importer/file/tinygltf_reader.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#define TINYGLTF_IMPLEMENTATION
#include "importer/file/tinygltf.h"

namespace sinew {
namespace {

using gltf::Json;

/// A copy for the parser, without what it would lose or refuse although glTF allows it; these parts are read from the
/// JSON directly. `skipped` is one more property to leave out:
/// - bufferViews/byteStride: one odd value fails the whole file (T5);
/// - primitives/indices: an accessor without a view fails the whole file, yet Draco files have such;
/// - extensions and extras: copied into a second tree, without use here;
/// - buffers and images never reach it: bytes are ours to load, in a sandbox (T6, T7, T9).
/// Whole numbers written as fractions become integers, which is what it expects.
Json without_traps(const Json& value, std::string_view skipped) {
  if (value.is_object()) {
    Json copy = Json::object();
    for (const auto& [name, entry] : value.items())
      if (name != "extensions" && name != "extras" && name != skipped) copy[name] = without_traps(entry, skipped);
    return copy;
  }
  if (value.is_array()) {
    Json copy = Json::array();
    for (const auto& entry : value) copy.push_back(without_traps(entry, skipped));
    return copy;
  }
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::floor(number) == number && std::abs(number) < 9e15 && !(number == 0.0 && std::signbit(number)))
      return static_cast<std::int64_t>(number);
  }
  return value;
}

/// Animation channels without a node are dropped by the parser (T2): they get node -1, which it reads as "none".
void name_missing_nodes(Json& animation) {
  for (auto& channel : animation["channels"])
    if (!channel["target"].contains("node")) channel["target"]["node"] = -1;
}

std::uint32_t index_or_none(int index) { return index < 0 ? kNone : static_cast<std::uint32_t>(index); }

std::uint32_t index_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? kNone : static_cast<std::uint32_t>(found->get<double>());
}

Json extensions_of(const Json& object) {
  const auto found = object.find("extensions");
  return found == object.end() ? Json() : *found;
}

std::vector<std::uint32_t> indices_of(const std::vector<int>& list) {
  std::vector<std::uint32_t> out(list.size());
  std::transform(list.begin(), list.end(), out.begin(), index_or_none);
  return out;
}

std::map<std::string, std::uint32_t> index_map(const std::map<std::string, int>& map) {
  std::map<std::string, std::uint32_t> out;
  for (const auto& [name, index] : map) out.emplace(name, index_or_none(index));
  return out;
}

template <std::size_t N>
void assign(std::array<double, N>& out, const std::vector<double>& values) {
  if (values.size() == N) std::copy(values.begin(), values.end(), out.begin());
}

gltf::ElementType element_type(int type) {
  switch (type) {
    case TINYGLTF_TYPE_VEC2: return gltf::ElementType::vec2;
    case TINYGLTF_TYPE_VEC3: return gltf::ElementType::vec3;
    case TINYGLTF_TYPE_VEC4: return gltf::ElementType::vec4;
    case TINYGLTF_TYPE_MAT2: return gltf::ElementType::mat2;
    case TINYGLTF_TYPE_MAT3: return gltf::ElementType::mat3;
    case TINYGLTF_TYPE_MAT4: return gltf::ElementType::mat4;
    default: return gltf::ElementType::scalar;
  }
}

gltf::BufferView convert(const tinygltf::BufferView& in, const Json& json) {
  gltf::BufferView out;
  out.buffer = index_or_none(in.buffer);
  out.byte_offset = in.byteOffset;
  out.byte_length = in.byteLength;
  if (const auto stride = json.find("byteStride"); stride != json.end())
    out.byte_stride = static_cast<std::uint32_t>(std::min(stride->get<double>(), 4294967295.0));
  out.extensions = extensions_of(json);
  return out;
}

gltf::Accessor convert(const tinygltf::Accessor& in, const Json& json) {
  gltf::Accessor out;
  out.buffer_view = index_or_none(in.bufferView);
  out.byte_offset = in.byteOffset;
  out.count = in.count;
  out.component_type = static_cast<gltf::ComponentType>(in.componentType);
  out.type = element_type(in.type);
  out.normalized = in.normalized;
  out.min = in.minValues;
  out.max = in.maxValues;
  if (const auto sparse = json.find("sparse"); sparse != json.end()) {
    const auto offset = [](const Json& part) { return static_cast<std::uint64_t>(part.value("byteOffset", 0.0)); };
    const Json &indices = (*sparse)["indices"], &values = (*sparse)["values"];
    out.sparse = {.count = static_cast<std::uint64_t>((*sparse)["count"].get<double>()),
                  .indices_view = index_of(indices, "bufferView"),
                  .values_view = index_of(values, "bufferView"),
                  .indices_offset = offset(indices),  // int in the parser, too small for large files
                  .values_offset = offset(values),
                  .index_type = static_cast<gltf::ComponentType>(in.sparse.indices.componentType)};
  }
  return out;
}

gltf::Mesh convert(const tinygltf::Mesh& in, const Json& json) {
  gltf::Mesh out;
  out.name = in.name;
  out.weights = in.weights;
  for (std::size_t p = 0; p < in.primitives.size(); ++p) {
    const auto& from = in.primitives[p];
    const Json& primitive = json["primitives"][p];
    gltf::Primitive to;
    to.attributes = index_map(from.attributes);
    to.indices = index_of(primitive, "indices");
    to.material = index_or_none(from.material);
    to.mode = static_cast<gltf::PrimitiveMode>(from.mode);
    for (const auto& target : from.targets) to.targets.push_back({index_map(target)});
    to.extensions = extensions_of(primitive);
    out.primitives.push_back(std::move(to));
  }
  if (const auto extras = json.find("extras"); extras != json.end() && extras->is_object())
    if (const auto names = extras->find("targetNames"); names != extras->end() && names->is_array())
      for (const auto& name : *names) out.target_names.push_back(name.is_string() ? name.get<std::string>() : "");
  return out;
}

gltf::Node convert(const tinygltf::Node& in, const Json& json) {
  gltf::Node out;
  out.name = in.name;
  out.children = indices_of(in.children);
  out.mesh = index_or_none(in.mesh);
  out.skin = index_or_none(in.skin);
  out.camera = index_or_none(in.camera);
  out.has_matrix = !in.matrix.empty();
  out.has_trs = json.contains("translation") || json.contains("rotation") || json.contains("scale");  // T3
  assign(out.matrix, in.matrix);
  assign(out.translation, in.translation);
  assign(out.rotation, in.rotation);
  assign(out.scale, in.scale);
  out.weights = in.weights;
  out.extensions = extensions_of(json);
  return out;
}

gltf::Skin convert(const tinygltf::Skin& in, const Json&) {
  return {in.name, indices_of(in.joints), index_or_none(in.inverseBindMatrices), index_or_none(in.skeleton)};
}

gltf::Animation convert(const tinygltf::Animation& in, const Json& json) {
  gltf::Animation out;
  out.name = in.name;
  for (const auto& sampler : in.samplers)
    out.samplers.push_back({index_or_none(sampler.input), index_or_none(sampler.output), sampler.interpolation});
  for (std::size_t c = 0; c < in.channels.size(); ++c) {
    const auto& from = in.channels[c];
    gltf::AnimationChannel to{index_or_none(from.sampler), index_or_none(from.target_node), from.target_path, {}};
    const Json extensions = extensions_of(json["channels"][c]["target"]);
    if (const auto found = extensions.find("KHR_animation_pointer"); found != extensions.end() && found->is_object())
      if (const auto text = found->find("pointer"); text != found->end() && text->is_string())
        to.pointer = text->get<std::string>();
    out.channels.push_back(std::move(to));
  }
  return out;
}

template <class Info>
gltf::TextureInfo texture_info(const Info& in, const Json& object, const char* name) {
  const auto found = object.find(name);
  return {index_or_none(in.index), static_cast<std::uint32_t>(in.texCoord),
          found == object.end() ? Json() : extensions_of(*found)};
}

gltf::Material convert(const tinygltf::Material& in, const Json& json) {
  static const Json kNothing = Json::object();
  const auto pbr_json = json.find("pbrMetallicRoughness");
  const Json& pbr_object = pbr_json == json.end() ? kNothing : *pbr_json;
  const auto& pbr = in.pbrMetallicRoughness;
  gltf::Material out;
  out.name = in.name;
  assign(out.base_color, pbr.baseColorFactor);
  out.metallic = pbr.metallicFactor;
  out.roughness = pbr.roughnessFactor;
  out.normal_scale = in.normalTexture.scale;
  out.occlusion_strength = in.occlusionTexture.strength;
  out.alpha_cutoff = in.alphaCutoff;
  assign(out.emissive, in.emissiveFactor);
  out.base_color_texture = texture_info(pbr.baseColorTexture, pbr_object, "baseColorTexture");
  out.metallic_roughness_texture = texture_info(pbr.metallicRoughnessTexture, pbr_object, "metallicRoughnessTexture");
  out.normal_texture = texture_info(in.normalTexture, json, "normalTexture");
  out.occlusion_texture = texture_info(in.occlusionTexture, json, "occlusionTexture");
  out.emissive_texture = texture_info(in.emissiveTexture, json, "emissiveTexture");
  out.alpha_mode = in.alphaMode;
  out.double_sided = in.doubleSided;
  out.extensions = extensions_of(json);
  return out;
}

gltf::Texture convert(const tinygltf::Texture& in, const Json& json) {
  return {in.name, index_or_none(in.source), index_or_none(in.sampler), extensions_of(json)};
}

gltf::TextureSampler convert(const tinygltf::Sampler& in, const Json&) {
  return {in.magFilter, in.minFilter, in.wrapS, in.wrapT};
}

gltf::Camera convert(const tinygltf::Camera& in, const Json&) {
  const bool perspective = in.type == "perspective";
  return {.name = in.name,
          .perspective = perspective,
          .aspect = in.perspective.aspectRatio,
          .yfov = in.perspective.yfov,
          .znear = perspective ? in.perspective.znear : in.orthographic.znear,
          .zfar = perspective ? in.perspective.zfar : in.orthographic.zfar,
          .xmag = in.orthographic.xmag,
          .ymag = in.orthographic.ymag};
}

gltf::Scene convert(const tinygltf::Scene& in, const Json&) { return {in.name, indices_of(in.nodes)}; }

/// The parser's objects are many times larger than their JSON, so a list goes through it in batches.
constexpr std::size_t kBatch = 256;

template <class Out, class In>
bool read_list(const Json& root, const char* name, std::vector<Out>& out, std::vector<In> tinygltf::Model::*member,
               std::string_view skipped, IssueLog& log) {
  const auto list = root.find(name);
  if (list == root.end()) return true;
  out.reserve(list->size());
  for (std::size_t first = 0; first < list->size(); first += kBatch) {
    const std::size_t last = std::min(first + kBatch, list->size());
    Json part{{"asset", {{"version", "2.0"}}}, {name, Json::array()}};
    for (std::size_t i = first; i < last; ++i) part[name].push_back(without_traps((*list)[i], skipped));
    if (std::string_view(name) == "animations")
      for (auto& animation : part[name]) name_missing_nodes(animation);
    const std::string text = part.dump();
    tinygltf::Model model;
    tinygltf::TinyGLTF parser;
    std::string error, warning;
    const bool read = parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                 static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE);
    if (!read || (model.*member).size() != last - first) {
      log.report(Rule::json_syntax, std::string("/") + name, "the parser refuses it: " + error);
      return false;
    }
    for (std::size_t i = first; i < last; ++i) out.push_back(convert((model.*member)[i - first], (*list)[i]));
  }
  return true;
}

void read_asset(const Json& root, gltf::Document& out) {
  const Json& asset = root["asset"];
  out.version = asset.value("version", "");
  out.min_version = asset.value("minVersion", "");
  out.generator = asset.value("generator", "");
  out.copyright = asset.value("copyright", "");
  out.extensions_used = root.value("extensionsUsed", std::vector<std::string>());
  out.extensions_required = root.value("extensionsRequired", std::vector<std::string>());
  out.scene = index_of(root, "scene");
  out.extensions = extensions_of(root);
}

void read_byte_sources(const Json& root, gltf::Document& out) {
  static const Json kEmpty = Json::array();
  const auto list = [&](const char* name) -> const Json& {
    const auto found = root.find(name);
    return found == root.end() ? kEmpty : *found;
  };
  for (const auto& json : list("buffers")) {
    gltf::Buffer buffer;
    buffer.uri = json.value("uri", "");
    buffer.byte_length = static_cast<std::uint64_t>(json["byteLength"].get<double>());
    buffer.extensions = extensions_of(json);
    out.buffers.push_back(std::move(buffer));
  }
  for (const auto& json : list("images"))
    out.images.push_back({.name = json.value("name", ""),
                          .uri = json.value("uri", ""),
                          .mime_type = json.value("mimeType", ""),
                          .buffer_view = index_of(json, "bufferView"),
                          .encoded = {},
                          .missing_reason = {}});
}

}  // namespace

std::optional<gltf::Document> read_document(const Json& json, IssueLog& log) {
  using Model = tinygltf::Model;
  gltf::Document out;
  read_asset(json, out);
  read_byte_sources(json, out);
  const bool read = read_list(json, "bufferViews", out.buffer_views, &Model::bufferViews, "byteStride", log) &&
                    read_list(json, "accessors", out.accessors, &Model::accessors, "", log) &&
                    read_list(json, "meshes", out.meshes, &Model::meshes, "indices", log) &&
                    read_list(json, "nodes", out.nodes, &Model::nodes, "", log) &&
                    read_list(json, "skins", out.skins, &Model::skins, "", log) &&
                    read_list(json, "animations", out.animations, &Model::animations, "", log) &&
                    read_list(json, "materials", out.materials, &Model::materials, "", log) &&
                    read_list(json, "textures", out.textures, &Model::textures, "", log) &&
                    read_list(json, "samplers", out.samplers, &Model::samplers, "", log) &&
                    read_list(json, "cameras", out.cameras, &Model::cameras, "", log) &&
                    read_list(json, "scenes", out.scenes, &Model::scenes, "", log);
  if (!read) return std::nullopt;
  return out;
}

}  // namespace sinew
