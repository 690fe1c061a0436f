// SPDX-License-Identifier: MIT
#include "importer/file/read_document.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "importer/file/read_lists.h"

namespace sinew {
namespace {

/// Typed access to the properties of one checked object. Absent properties have glTF's defaults.
class Fields {
 public:
  explicit Fields(const JsonNode& object) : object_(object) {}

  const JsonNode* find(const char* name) const { return find_member(object_, name); }

  double number(const char* name, double fallback) const {
    const JsonNode* value = find(name);
    return value == nullptr ? fallback : value->GetDouble();
  }

  /// An integer below 2^53; also accepts "3.0".
  std::uint64_t size(const char* name) const { return static_cast<std::uint64_t>(number(name, 0.0)); }

  std::uint32_t index(const char* name, std::uint32_t fallback = kNone) const {
    const JsonNode* value = find(name);
    return value == nullptr ? fallback : as_index(*value);
  }

  bool flag(const char* name) const {
    const JsonNode* value = find(name);
    return value != nullptr && value->GetBool();
  }

  std::string text(const char* name, const char* fallback = "") const {
    const JsonNode* value = find(name);
    return value != nullptr && value->IsString() ? std::string(text_of(*value)) : fallback;
  }

  /// A member as JSON, for later code; null if absent.
  gltf::Json part(const char* name) const {
    const JsonNode* value = find(name);
    return value == nullptr ? gltf::Json() : to_json(*value);
  }

  /// A list of entries converted by `read(entry)`.
  template <class Read>
  auto list(const char* name, Read read) const {
    std::vector<decltype(read(object_))> out;
    if (const JsonNode* values = find(name)) {
      out.reserve(values->Size());
      for (const JsonNode& value : values->GetArray()) out.push_back(read(value));
    }
    return out;
  }

  std::vector<double> numbers(const char* name) const {
    return list(name, [](const JsonNode& value) { return value.GetDouble(); });
  }
  std::vector<std::string> texts(const char* name) const {
    return list(name,
                [](const JsonNode& value) { return value.IsString() ? std::string(text_of(value)) : std::string(); });
  }

  static std::uint32_t as_index(const JsonNode& value) { return static_cast<std::uint32_t>(value.GetDouble()); }

 private:
  const JsonNode& object_;
};

gltf::ElementType element_type(std::string_view name) {
  constexpr std::string_view kNames[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  return static_cast<gltf::ElementType>(std::find(std::begin(kNames), std::end(kNames), name) - std::begin(kNames));
}

gltf::ComponentType component_type(const Fields& in) {
  return static_cast<gltf::ComponentType>(in.index("componentType"));
}

gltf::Buffer read_buffer(const JsonNode& json) {
  const Fields in(json);
  return {.uri = in.text("uri"), .byte_length = in.size("byteLength"), .extensions = in.part("extensions")};
}

gltf::BufferView read_view(const JsonNode& json) {
  const Fields in(json);
  return {.buffer = in.index("buffer"),
          .byte_offset = in.size("byteOffset"),
          .byte_length = in.size("byteLength"),
          .byte_stride = static_cast<std::uint32_t>(
              std::min(in.number("byteStride", 0.0), 4294967295.0)),  // the range of strides is checked later
          .extensions = in.part("extensions")};
}

gltf::SparseAccessor read_sparse(const JsonNode& json) {
  const Fields in(json), indices(*in.find("indices")), values(*in.find("values"));
  return {.count = in.size("count"),
          .indices_view = indices.index("bufferView"),
          .values_view = values.index("bufferView"),
          .indices_offset = indices.size("byteOffset"),
          .values_offset = values.size("byteOffset"),
          .index_type = component_type(indices)};
}

gltf::Accessor read_accessor(const JsonNode& json) {
  const Fields in(json);
  const JsonNode* sparse = in.find("sparse");
  return {.buffer_view = in.index("bufferView"),
          .byte_offset = in.size("byteOffset"),
          .count = in.size("count"),
          .component_type = component_type(in),
          .type = element_type(text_of(*in.find("type"))),
          .normalized = in.flag("normalized"),
          .sparse = sparse == nullptr ? gltf::SparseAccessor{} : read_sparse(*sparse),
          .min = in.numbers("min"),
          .max = in.numbers("max")};
}

/// Adds attributes whose names contain a zero byte, where tinygltf would truncate the name.
void add_names_with_zeros(const JsonNode& json, std::map<std::string, int>& attributes) {
  for (const auto& [name, index] : json.GetObject())
    if (text_of(name).find('\0') != std::string_view::npos)
      attributes.insert_or_assign(std::string(text_of(name)), static_cast<int>(index.GetDouble()));
}

gltf::Primitive read_primitive(tinygltf::Primitive&& read, const JsonNode& json) {
  const Fields in(json);
  gltf::Primitive out(std::move(read), in.part("extensions"));
  out.indices = static_cast<int>(in.index("indices"));
  add_names_with_zeros(*in.find("attributes"), out.attributes);
  for (rapidjson::SizeType t = 0; t < out.targets.size(); ++t)
    add_names_with_zeros((*in.find("targets"))[t], out.targets[t]);
  return out;
}

gltf::Mesh read_mesh(tinygltf::Mesh&& read, const JsonNode& json) {
  const Fields in(json);
  gltf::Mesh out{std::move(read)};
  auto& primitives = static_cast<tinygltf::Mesh&>(out).primitives;
  const JsonNode& list = *in.find("primitives");
  expect_all("primitives", list.Size(), primitives.size());
  out.primitives.reserve(primitives.size());
  for (rapidjson::SizeType p = 0; p < list.Size(); ++p)
    out.primitives.push_back(read_primitive(std::move(primitives[p]), list[p]));
  primitives = {};
  if (const JsonNode* extras = in.find("extras"); extras != nullptr && extras->IsObject())
    if (const JsonNode* names = Fields(*extras).find("targetNames"); names != nullptr && names->IsArray())
      out.target_names = Fields(*extras).texts("targetNames");
  return out;
}

gltf::Node read_node(tinygltf::Node&& read, const JsonNode& json) {
  const Fields in(json);
  const bool has_trs =
      in.find("translation") != nullptr || in.find("rotation") != nullptr || in.find("scale") != nullptr;
  return {std::move(read), has_trs, in.part("extensions")};
}

/// Reads a channel. Channels without a node are kept: their target may be a pointer.
gltf::AnimationChannel read_channel(const JsonNode& json) {
  const Fields in(json), target(*in.find("target"));
  gltf::AnimationChannel out{.sampler = in.index("sampler"), .node = target.index("node"), .path = target.text("path")};
  if (const JsonNode* extensions = target.find("extensions"))
    if (const JsonNode* extension = Fields(*extensions).find("KHR_animation_pointer");
        extension != nullptr && extension->IsObject())
      out.pointer = Fields(*extension).text("pointer");
  return out;
}

gltf::Animation read_animation(const JsonNode& json) {
  const auto sampler = [](const JsonNode& entry) {
    const Fields in(entry);
    return gltf::AnimationSampler{in.index("input"), in.index("output"), in.text("interpolation", "LINEAR")};
  };
  const Fields in(json);
  const JsonNode* extras = in.find("extras");
  const bool has_annotations = extras != nullptr && extras->IsObject() &&
                               (find_member(*extras, "events") != nullptr || find_member(*extras, "curves") != nullptr);
  return {.name = in.text("name"),
          .samplers = in.list("samplers", sampler),
          .channels = in.list("channels", read_channel),
          .extras = has_annotations ? to_json(*extras) : gltf::Json()};
}

gltf::Material read_material(tinygltf::Material&& read, const JsonNode& json) {
  const Fields in(json);
  gltf::Material out{std::move(read), in.part("extensions"), {}};
  const auto take_extensions = [&](const JsonNode* owner, const char* texture, TextureSlot slot) {
    if (const JsonNode* info = owner == nullptr ? nullptr : find_member(*owner, texture))
      out.extensions_of(slot) = Fields(*info).part("extensions");
  };
  const JsonNode* surface = in.find("pbrMetallicRoughness");
  take_extensions(surface, "baseColorTexture", TextureSlot::base_color);
  take_extensions(surface, "metallicRoughnessTexture", TextureSlot::metallic_roughness);
  take_extensions(&json, "normalTexture", TextureSlot::normal);
  take_extensions(&json, "occlusionTexture", TextureSlot::occlusion);
  take_extensions(&json, "emissiveTexture", TextureSlot::emissive);
  return out;
}

gltf::Texture read_texture(tinygltf::Texture&& read, const JsonNode& json) {
  return {std::move(read), Fields(json).part("extensions")};
}

gltf::Image read_image(const JsonNode& json) {
  const Fields in(json);
  return {.name = in.text("name"),
          .uri = in.text("uri"),
          .mime_type = in.text("mimeType"),
          .buffer_view = in.index("bufferView")};
}

}  // namespace

gltf::Document read_document(const JsonNode& json) {
  using tinygltf::Model;
  const Fields root(json);
  Model head = read_head(json);
  return {.asset = std::move(head.asset),
          .extensions_used = std::move(head.extensionsUsed),
          .extensions_required = std::move(head.extensionsRequired),
          .buffers = root.list("buffers", read_buffer),
          .buffer_views = root.list("bufferViews", read_view),
          .accessors = root.list("accessors", read_accessor),
          .meshes = read_list(json, "meshes", &Model::meshes, read_mesh),
          .nodes = read_list(json, "nodes", &Model::nodes, read_node),
          .skins = read_list(json, "skins", &Model::skins),
          .animations = root.list("animations", read_animation),
          .materials = read_list(json, "materials", &Model::materials, read_material),
          .textures = read_list(json, "textures", &Model::textures, read_texture),
          .images = root.list("images", read_image),
          .samplers = read_list(json, "samplers", &Model::samplers),
          .cameras = read_list(json, "cameras", &Model::cameras),
          .scenes = read_list(json, "scenes", &Model::scenes),
          .scene = static_cast<std::uint32_t>(head.defaultScene),
          .extensions = root.part("extensions")};
}

}  // namespace sinew
