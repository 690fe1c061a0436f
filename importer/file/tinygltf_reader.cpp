// SPDX-License-Identifier: MIT
#include "importer/file/tinygltf_reader.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#define TINYGLTF_IMPLEMENTATION
#include "importer/file/json_pointer.h"
#include "importer/file/tinygltf.h"

namespace sinew {
namespace {

using gltf::Json;

/// The parser reads one object of a list at a time, straight from the JSON, so that the text is read once. Before that the
/// object loses what the parser would lose, refuse, or copy into a tree of its own although glTF allows it:
/// - extensions and extras: moved out by the functions below, extras dropped after use;
/// - bufferViews/byteStride: one odd value fails the whole file (T5);
/// - buffers and images never reach it: bytes are ours to load, in a sandbox (T6, T7, T9).
Json take(Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return {};
  Json value = std::move(*found);
  object.erase(found);
  return value;
}

/// Whole numbers written as fractions become integers, which is what the parser expects.
void make_whole(Json& value) {
  if (value.is_structured()) {
    for (Json& entry : value) make_whole(entry);
  } else if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::floor(number) == number && std::abs(number) < 9e15 && !(number == 0.0 && std::signbit(number)))
      value = static_cast<std::int64_t>(number);
  }
}

std::uint32_t index_or_none(int index) { return index < 0 ? kNone : static_cast<std::uint32_t>(index); }

std::uint32_t index_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? kNone : static_cast<std::uint32_t>(found->get<double>());
}

std::vector<std::uint32_t> indices_of(const std::vector<int>& list) {
  std::vector<std::uint32_t> out(list.size());
  std::transform(list.begin(), list.end(), out.begin(), index_or_none);
  return out;
}

std::map<std::string, std::uint32_t> index_map(const std::map<std::string, int>& map) {
  std::map<std::string, std::uint32_t> out;
  for (const auto& [name, index] : map) out.emplace_hint(out.end(), name, index_or_none(index));
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

/// What the parser says of one object; `error` is not empty where it refuses.
struct Parser {
  std::string error;
  tinygltf::Model model;  // for parser functions that ask for one and leave it alone

  template <class In, class... More>
  In parse(bool (*function)(In*, std::string*, const Json&, bool, More...), Json& json, std::type_identity_t<More>... more) {
    In in;
    make_whole(json);
    if (!function(&in, &error, json, false, more...) && error.empty()) error = "refused";
    return in;
  }

  void read(Json& json, gltf::BufferView& out) {
    out.extensions = take(json, "extensions");
    if (const Json stride = take(json, "byteStride"); stride.is_number())
      out.byte_stride = static_cast<std::uint32_t>(std::min(stride.get<double>(), 4294967295.0));
    const auto in = parse(tinygltf::ParseBufferView, json);
    out.buffer = index_or_none(in.buffer);
    out.byte_offset = in.byteOffset;
    out.byte_length = in.byteLength;
  }

  void read(Json& json, gltf::Accessor& out) {
    auto in = parse(tinygltf::ParseAccessor, json);
    out.buffer_view = index_or_none(in.bufferView);
    out.byte_offset = in.byteOffset;
    out.count = in.count;
    out.component_type = static_cast<gltf::ComponentType>(in.componentType);
    out.type = element_type(in.type);
    out.normalized = in.normalized;
    out.min = std::move(in.minValues);
    out.max = std::move(in.maxValues);
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
  }

  void read(Json& json, gltf::Mesh& out) {
    for (Json& primitive : json["primitives"]) out.primitives.push_back({.extensions = take(primitive, "extensions")});
    if (const Json extras = take(json, "extras"); extras.is_object())
      if (const auto names = extras.find("targetNames"); names != extras.end() && names->is_array())
        for (const auto& name : *names) out.target_names.push_back(name.is_string() ? name.get<std::string>() : "");
    make_whole(json);
    tinygltf::Mesh in;
    if (!tinygltf::ParseMesh(&in, &model, &error, json, false) || in.primitives.size() != out.primitives.size()) error += "refused";
    out.name = std::move(in.name);
    out.weights = std::move(in.weights);
    for (std::size_t p = 0; p < in.primitives.size() && error.empty(); ++p) {
      const auto& from = in.primitives[p];
      gltf::Primitive& to = out.primitives[p];
      to.attributes = index_map(from.attributes);
      to.indices = index_or_none(from.indices);
      to.material = index_or_none(from.material);
      to.mode = static_cast<gltf::PrimitiveMode>(from.mode);
      for (const auto& target : from.targets) to.targets.push_back({index_map(target)});
    }
  }

  void read(Json& json, gltf::Node& out) {
    out.extensions = take(json, "extensions");
    take(json, "extras");
    out.has_trs = json.contains("translation") || json.contains("rotation") || json.contains("scale");  // T3
    auto in = parse(tinygltf::ParseNode, json);
    out.name = std::move(in.name);
    out.children = indices_of(in.children);
    out.mesh = index_or_none(in.mesh);
    out.skin = index_or_none(in.skin);
    out.camera = index_or_none(in.camera);
    out.has_matrix = !in.matrix.empty();
    assign(out.matrix, in.matrix);
    assign(out.translation, in.translation);
    assign(out.rotation, in.rotation);
    assign(out.scale, in.scale);
    out.weights = std::move(in.weights);
  }

  void read(Json& json, gltf::Skin& out) {
    auto in = parse(tinygltf::ParseSkin, json);
    error.clear();  // inverseBindMatrices may be absent (G31)
    out = {std::move(in.name), indices_of(in.joints), index_or_none(in.inverseBindMatrices), index_or_none(in.skeleton)};
  }

  /// Channels without a node are dropped by the parser (T2): they get node -1, which it reads as "none".
  void read(Json& json, gltf::Animation& out) {
    for (Json& channel : json["channels"]) {
      Json& target = channel["target"];
      const Json extensions = take(target, "extensions");
      if (!target.contains("node")) target["node"] = -1;
      auto& to = out.channels.emplace_back();
      if (const auto found = extensions.find("KHR_animation_pointer"); found != extensions.end() && found->is_object())
        if (const auto text = found->find("pointer"); text != found->end() && text->is_string()) to.pointer = text->get<std::string>();
    }
    auto in = parse(tinygltf::ParseAnimation, json);
    if (in.channels.size() != out.channels.size()) error += "refused";
    out.name = std::move(in.name);
    for (auto& sampler : in.samplers)
      out.samplers.push_back({index_or_none(sampler.input), index_or_none(sampler.output), std::move(sampler.interpolation)});
    for (std::size_t c = 0; c < in.channels.size() && error.empty(); ++c) {
      out.channels[c].sampler = index_or_none(in.channels[c].sampler);
      out.channels[c].node = index_or_none(in.channels[c].target_node);
      out.channels[c].path = std::move(in.channels[c].target_path);
    }
  }

  static Json take_texture_extensions(Json& object, const char* name) {
    const auto found = object.find(name);
    return found == object.end() ? Json() : take(*found, "extensions");
  }

  template <class Info>
  static void fill(gltf::TextureInfo& out, const Info& in) {
    out.index = index_or_none(in.index);
    out.texcoord = static_cast<std::uint32_t>(in.texCoord);
  }

  void read(Json& json, gltf::Material& out) {
    out.extensions = take(json, "extensions");
    if (const auto surface = json.find("pbrMetallicRoughness"); surface != json.end()) {
      out.base_color_texture.extensions = take_texture_extensions(*surface, "baseColorTexture");
      out.metallic_roughness_texture.extensions = take_texture_extensions(*surface, "metallicRoughnessTexture");
    }
    out.normal_texture.extensions = take_texture_extensions(json, "normalTexture");
    out.occlusion_texture.extensions = take_texture_extensions(json, "occlusionTexture");
    out.emissive_texture.extensions = take_texture_extensions(json, "emissiveTexture");
    const auto in = parse(tinygltf::ParseMaterial, json);
    const auto& pbr = in.pbrMetallicRoughness;
    out.name = in.name;
    assign(out.base_color, pbr.baseColorFactor);
    out.metallic = pbr.metallicFactor;
    out.roughness = pbr.roughnessFactor;
    out.normal_scale = in.normalTexture.scale;
    out.occlusion_strength = in.occlusionTexture.strength;
    out.alpha_cutoff = in.alphaCutoff;
    assign(out.emissive, in.emissiveFactor);
    fill(out.base_color_texture, pbr.baseColorTexture);
    fill(out.metallic_roughness_texture, pbr.metallicRoughnessTexture);
    fill(out.normal_texture, in.normalTexture);
    fill(out.occlusion_texture, in.occlusionTexture);
    fill(out.emissive_texture, in.emissiveTexture);
    out.alpha_mode = in.alphaMode;
    out.double_sided = in.doubleSided;
  }

  void read(Json& json, gltf::Texture& out) {
    out.extensions = take(json, "extensions");
    const auto in = parse(tinygltf::ParseTexture, json, std::string());
    out.name = in.name;
    out.source = index_or_none(in.source);
    out.sampler = index_or_none(in.sampler);
  }

  void read(Json& json, gltf::TextureSampler& out) {
    const auto in = parse(tinygltf::ParseSampler, json);
    out = {in.magFilter, in.minFilter, in.wrapS, in.wrapT};
  }

  void read(Json& json, gltf::Camera& out) {
    const auto in = parse(tinygltf::ParseCamera, json);
    const bool perspective = in.type == "perspective";
    out = {.name = in.name,
           .perspective = perspective,
           .aspect = in.perspective.aspectRatio,
           .yfov = in.perspective.yfov,
           .znear = perspective ? in.perspective.znear : in.orthographic.znear,
           .zfar = perspective ? in.perspective.zfar : in.orthographic.zfar,
           .xmag = in.orthographic.xmag,
           .ymag = in.orthographic.ymag};
  }

  void read(Json& json, gltf::Scene& out) {
    make_whole(json);
    std::vector<int> nodes;
    tinygltf::ParseIntegerArrayProperty(&nodes, &error, json, "nodes", false);
    tinygltf::ParseStringProperty(&out.name, &error, json, "name", false);
    out.nodes = indices_of(nodes);
  }
};

template <class Out>
bool read_list(Json& root, const char* name, std::vector<Out>& out, IssueLog& log) {
  const auto list = root.find(name);
  if (list == root.end()) return true;
  Parser parser;
  out.resize(list->size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    parser.read((*list)[i], out[i]);
    if (parser.error.empty()) continue;
    log.report(Rule::json_syntax, pointer(name, i), "the parser refuses it: " + parser.error);
    return false;
  }
  return true;
}

void read_asset(Json& root, gltf::Document& out) {
  const Json& asset = root["asset"];
  out.version = asset.value("version", "");
  out.min_version = asset.value("minVersion", "");
  out.generator = asset.value("generator", "");
  out.copyright = asset.value("copyright", "");
  out.extensions_used = root.value("extensionsUsed", std::vector<std::string>());
  out.extensions_required = root.value("extensionsRequired", std::vector<std::string>());
  out.scene = index_of(root, "scene");
  out.extensions = take(root, "extensions");
}

void read_byte_sources(Json& root, gltf::Document& out) {
  if (const auto list = root.find("buffers"); list != root.end())
    for (Json& json : *list) {
      auto& buffer = out.buffers.emplace_back();
      if (Json uri = take(json, "uri"); uri.is_string()) buffer.uri = std::move(uri.get_ref<std::string&>());
      buffer.byte_length = static_cast<std::uint64_t>(json["byteLength"].get<double>());
      buffer.extensions = take(json, "extensions");
    }
  if (const auto list = root.find("images"); list != root.end())
    for (Json& json : *list) {
      auto& image = out.images.emplace_back();
      if (Json uri = take(json, "uri"); uri.is_string()) image.uri = std::move(uri.get_ref<std::string&>());
      image.name = json.value("name", "");
      image.mime_type = json.value("mimeType", "");
      image.buffer_view = index_of(json, "bufferView");
    }
}

}  // namespace

std::optional<gltf::Document> read_document(Json json, IssueLog& log) {
  gltf::Document out;
  read_asset(json, out);
  read_byte_sources(json, out);
  const bool read = read_list(json, "bufferViews", out.buffer_views, log) && read_list(json, "accessors", out.accessors, log) &&
                    read_list(json, "meshes", out.meshes, log) && read_list(json, "nodes", out.nodes, log) &&
                    read_list(json, "skins", out.skins, log) && read_list(json, "animations", out.animations, log) &&
                    read_list(json, "materials", out.materials, log) && read_list(json, "textures", out.textures, log) &&
                    read_list(json, "samplers", out.samplers, log) && read_list(json, "cameras", out.cameras, log) &&
                    read_list(json, "scenes", out.scenes, log);
  if (!read) return std::nullopt;
  return out;
}

}  // namespace sinew
