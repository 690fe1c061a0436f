// SPDX-License-Identifier: MIT
#include "importer/file/read_document.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "importer/file/json_fields.h"
#include "importer/file/read_entries.h"

namespace sinew {
namespace {

gltf::ElementType element_type(std::string_view name) {
  constexpr std::string_view kNames[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  return static_cast<gltf::ElementType>(std::find(std::begin(kNames), std::end(kNames), name) - std::begin(kNames));
}

gltf::ComponentType component_type(const JsonFields& in) {
  return static_cast<gltf::ComponentType>(in.index("componentType"));
}

gltf::Buffer read_buffer(const JsonNode& json) {
  const JsonFields in(json);
  return {.uri = in.text("uri"), .byte_length = in.size("byteLength"), .extensions = in.part("extensions")};
}

gltf::BufferView read_view(const JsonNode& json) {
  const JsonFields in(json);
  return {.buffer = in.index("buffer"),
          .byte_offset = in.size("byteOffset"),
          .byte_length = in.size("byteLength"),
          .byte_stride = static_cast<std::uint32_t>(
              std::min(in.number("byteStride", 0.0), 4294967295.0)),  // the range of strides is checked later
          .extensions = in.part("extensions")};
}

gltf::SparseAccessor read_sparse(const JsonNode& json) {
  const JsonFields in(json), indices(*in.find("indices")), values(*in.find("values"));
  return {.count = in.size("count"),
          .indices_view = indices.index("bufferView"),
          .values_view = values.index("bufferView"),
          .indices_offset = indices.size("byteOffset"),
          .values_offset = values.size("byteOffset"),
          .index_type = component_type(indices)};
}

gltf::Accessor read_accessor(const JsonNode& json) {
  const JsonFields in(json);
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

/// Reads a channel. Channels without a node are kept: their target may be a pointer.
gltf::AnimationChannel read_channel(const JsonNode& json) {
  const JsonFields in(json), target(*in.find("target"));
  gltf::AnimationChannel out{.sampler = in.index("sampler"), .node = target.index("node"), .path = target.text("path")};
  if (const JsonNode* extensions = target.find("extensions"))
    if (const JsonNode* extension = JsonFields(*extensions).find("KHR_animation_pointer");
        extension != nullptr && extension->IsObject())
      out.pointer = JsonFields(*extension).text("pointer");
  return out;
}

gltf::Animation read_animation(const JsonNode& json) {
  const auto sampler = [](const JsonNode& entry) {
    const JsonFields in(entry);
    return gltf::AnimationSampler{in.index("input"), in.index("output"), in.text("interpolation", "LINEAR")};
  };
  const JsonFields in(json);
  const JsonNode* extras = in.find("extras");
  const bool has_annotations = extras != nullptr && extras->IsObject() &&
                               (find_member(*extras, "events") != nullptr || find_member(*extras, "curves") != nullptr);
  return {.name = in.text("name"),
          .samplers = in.list("samplers", sampler),
          .channels = in.list("channels", read_channel),
          .extras = has_annotations ? to_json(*extras) : gltf::Json()};
}

gltf::Image read_image(const JsonNode& json) {
  const JsonFields in(json);
  return {.name = in.text("name"),
          .uri = in.text("uri"),
          .mime_type = in.text("mimeType"),
          .buffer_view = in.index("bufferView")};
}

}  // namespace

gltf::Document read_document(const JsonNode& json) {
  const JsonFields root(json);
  return {.asset = read_asset(*root.find("asset")),
          .extensions_used = root.texts("extensionsUsed"),
          .extensions_required = root.texts("extensionsRequired"),
          .buffers = root.list("buffers", read_buffer),
          .buffer_views = root.list("bufferViews", read_view),
          .accessors = root.list("accessors", read_accessor),
          .meshes = root.list("meshes", read_mesh),
          .nodes = root.list("nodes", read_node),
          .skins = root.list("skins", read_skin),
          .animations = root.list("animations", read_animation),
          .materials = root.list("materials", read_material),
          .textures = root.list("textures", read_texture),
          .images = root.list("images", read_image),
          .samplers = root.list("samplers", read_texture_sampler),
          .cameras = root.list("cameras", read_camera),
          .scenes = root.list("scenes", read_scene),
          .scene = root.index("scene"),
          .extensions = root.part("extensions")};
}

}  // namespace sinew
