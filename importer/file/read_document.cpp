// SPDX-License-Identifier: MIT
#include "importer/file/read_document.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace sinew {
namespace {

/// The properties of one object whose types and ranges have been checked. Absent properties take glTF's defaults.
class Fields {
 public:
  explicit Fields(const JsonNode& object) : object_(object) {}

  const JsonNode* find(const char* name) const { return find_member(object_, name); }

  double number(const char* name, double fallback) const {
    const JsonNode* value = find(name);
    return value == nullptr ? fallback : value->GetDouble();
  }

  /// Whole numbers below 2^53; also accepts "3.0".
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

  /// A part of the document that later code reads as JSON.
  gltf::Json part(const char* name) const {
    const JsonNode* value = find(name);
    return value == nullptr ? gltf::Json() : to_json(*value);
  }

  /// A list whose entries are converted by `read(entry)`.
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
  std::vector<std::uint32_t> indices(const char* name) const { return list(name, as_index); }
  std::vector<std::string> texts(const char* name) const {
    return list(name,
                [](const JsonNode& value) { return value.IsString() ? std::string(text_of(value)) : std::string(); });
  }

  /// Fills an array whose length the shape has fixed; false where it is absent.
  template <std::size_t N>
  bool fill(const char* name, std::array<double, N>& out) const {
    const JsonNode* values = find(name);
    if (values == nullptr) return false;
    for (rapidjson::SizeType i = 0; i < N; ++i) out[i] = (*values)[i].GetDouble();
    return true;
  }

  static std::uint32_t as_index(const JsonNode& value) { return static_cast<std::uint32_t>(value.GetDouble()); }

 private:
  const JsonNode& object_;
};

std::map<std::string, std::uint32_t> index_map(const JsonNode& object) {
  std::map<std::string, std::uint32_t> out;
  for (const auto& [name, index] : object.GetObject())
    out.insert_or_assign(std::string(text_of(name)), Fields::as_index(index));
  return out;
}

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
              std::min(in.number("byteStride", 0.0), 4294967295.0)),  // any stride is read here and checked later (T5)
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

gltf::Primitive read_primitive(const JsonNode& json) {
  const Fields in(json);
  return {.attributes = index_map(*in.find("attributes")),
          .indices = in.index("indices"),
          .material = in.index("material"),
          .mode = static_cast<gltf::PrimitiveMode>(in.index("mode", 4)),
          .targets = in.list("targets", [](const JsonNode& target) { return gltf::MorphTarget{index_map(target)}; }),
          .extensions = in.part("extensions")};
}

gltf::Mesh read_mesh(const JsonNode& json) {
  const Fields in(json);
  gltf::Mesh out{
      .name = in.text("name"), .primitives = in.list("primitives", read_primitive), .weights = in.numbers("weights")};
  if (const JsonNode* extras = in.find("extras"); extras != nullptr && extras->IsObject())
    if (const JsonNode* names = Fields(*extras).find("targetNames"); names != nullptr && names->IsArray())
      out.target_names = Fields(*extras).texts("targetNames");
  return out;
}

gltf::Node read_node(const JsonNode& json) {
  const Fields in(json);
  gltf::Node out{.name = in.text("name"),
                 .children = in.indices("children"),
                 .mesh = in.index("mesh"),
                 .skin = in.index("skin"),
                 .camera = in.index("camera"),
                 .weights = in.numbers("weights"),
                 .extensions = in.part("extensions")};
  out.has_matrix = in.fill("matrix", out.matrix);
  const bool translated = in.fill("translation", out.translation), turned = in.fill("rotation", out.rotation);
  out.has_trs = in.fill("scale", out.scale) || translated || turned;  // a matrix beside any of them is reported (T3)
  return out;
}

gltf::Skin read_skin(const JsonNode& json) {
  const Fields in(json);
  return {.name = in.text("name"),
          .joints = in.indices("joints"),
          .inverse_bind_matrices = in.index("inverseBindMatrices"),
          .skeleton = in.index("skeleton")};
}

/// Channels without a node stay: they animate nothing, or name their target by a pointer (T2).
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
  return {
      .name = in.text("name"), .samplers = in.list("samplers", sampler), .channels = in.list("channels", read_channel)};
}

/// A texture reference of a material. `factor` receives the strength that is stored with the texture.
gltf::TextureInfo read_texture_info(const Fields& owner, const char* name, const char* factor_name = nullptr,
                                    double* factor = nullptr) {
  const JsonNode* json = owner.find(name);
  if (json == nullptr) return {};
  const Fields in(*json);
  if (factor != nullptr) *factor = in.number(factor_name, *factor);
  return {in.index("index"), in.index("texCoord", 0), in.part("extensions")};
}

gltf::Material read_material(const JsonNode& json) {
  const Fields in(json);
  gltf::Material out;
  out.name = in.text("name");
  if (const JsonNode* surface_json = in.find("pbrMetallicRoughness")) {
    const Fields surface(*surface_json);
    surface.fill("baseColorFactor", out.base_color);
    out.metallic = surface.number("metallicFactor", out.metallic);
    out.roughness = surface.number("roughnessFactor", out.roughness);
    out.base_color_texture = read_texture_info(surface, "baseColorTexture");
    out.metallic_roughness_texture = read_texture_info(surface, "metallicRoughnessTexture");
  }
  out.normal_texture = read_texture_info(in, "normalTexture", "scale", &out.normal_scale);
  out.occlusion_texture = read_texture_info(in, "occlusionTexture", "strength", &out.occlusion_strength);
  out.emissive_texture = read_texture_info(in, "emissiveTexture");
  in.fill("emissiveFactor", out.emissive);
  out.alpha_mode = in.text("alphaMode", "OPAQUE");
  out.alpha_cutoff = in.number("alphaCutoff", out.alpha_cutoff);
  out.double_sided = in.flag("doubleSided");
  out.extensions = in.part("extensions");
  return out;
}

gltf::Texture read_texture(const JsonNode& json) {
  const Fields in(json);
  return {.name = in.text("name"),
          .source = in.index("source"),
          .sampler = in.index("sampler"),
          .extensions = in.part("extensions")};
}

gltf::Image read_image(const JsonNode& json) {
  const Fields in(json);
  return {.name = in.text("name"),
          .uri = in.text("uri"),
          .mime_type = in.text("mimeType"),
          .buffer_view = in.index("bufferView")};
}

gltf::TextureSampler read_texture_sampler(const JsonNode& json) {
  const Fields in(json);
  const auto gl = [&](const char* name, int fallback) { return static_cast<int>(in.number(name, fallback)); };
  const gltf::TextureSampler usual;
  return {gl("magFilter", usual.mag_filter), gl("minFilter", usual.min_filter), gl("wrapS", usual.wrap_s),
          gl("wrapT", usual.wrap_t)};
}

gltf::Camera read_camera(const JsonNode& json) {
  const Fields in(json);
  gltf::Camera out{.name = in.text("name"), .perspective = in.text("type") == "perspective"};
  if (const JsonNode* lens = in.find(out.perspective ? "perspective" : "orthographic")) {
    const Fields of(*lens);
    out.znear = of.number("znear", 0.0);
    out.zfar = of.number("zfar", 0.0);
    (out.perspective ? out.aspect : out.xmag) = of.number(out.perspective ? "aspectRatio" : "xmag", 0.0);
    (out.perspective ? out.yfov : out.ymag) = of.number(out.perspective ? "yfov" : "ymag", 0.0);
  }
  return out;
}

gltf::Scene read_scene(const JsonNode& json) {
  const Fields in(json);
  return {.name = in.text("name"), .nodes = in.indices("nodes")};
}

}  // namespace

gltf::Document read_document(const JsonNode& json) {
  const Fields root(json), asset(*root.find("asset"));
  return {.generator = asset.text("generator"),
          .copyright = asset.text("copyright"),
          .version = asset.text("version"),
          .min_version = asset.text("minVersion"),
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
