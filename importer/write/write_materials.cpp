// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "importer/write/encode_png.h"
#include "importer/write/write_scene.h"

namespace sinew::write {
namespace {

using Object = tinygltf::Value::Object;
using Array = tinygltf::Value::Array;

tinygltf::Value pair(const glm::vec2& v) {
  return tinygltf::Value(Array{tinygltf::Value(static_cast<double>(v.x)), tinygltf::Value(static_cast<double>(v.y))});
}

/// Fills in the common members of texture references. If clips animate the texture transform, the extension is written
/// even for an identity transform.
template <class Info>
void reference(const TextureUse& use, bool animated, tinygltf::Model& model, Info& info) {
  if (!use.used()) return;
  info.index = static_cast<int>(use.texture);
  info.texCoord = static_cast<int>(use.texcoord);
  if (!animated && !has_transform(use)) return;
  info.extensions["KHR_texture_transform"] = transform_of(use, model);
}

const char* name_of(AlphaMode mode) {
  switch (mode) {
    case AlphaMode::mask: return "MASK";
    case AlphaMode::blend: return "BLEND";
    case AlphaMode::opaque: break;
  }
  return "OPAQUE";
}

/// The animated properties of one material.
class MovedParts {
 public:
  MovedParts(const PropertyTable& table, std::uint32_t material) : table_(table), material_(material) {}

  bool strength() const { return moves(PropertyKind::emissive_strength, TextureSlot::base_color); }
  bool texture(TextureSlot slot) const {
    return moves(PropertyKind::texture_offset, slot) || moves(PropertyKind::texture_rotation, slot) ||
           moves(PropertyKind::texture_scale, slot);
  }

 private:
  bool moves(PropertyKind kind, TextureSlot slot) const { return table_.find({kind, material_, slot}) != nullptr; }

  const PropertyTable& table_;
  std::uint32_t material_;
};

tinygltf::Material written(const Material& material, const MovedParts& moved, tinygltf::Model& model) {
  tinygltf::Material out;
  out.name = material.name;
  const auto& c = material.base_color;
  out.pbrMetallicRoughness.baseColorFactor = {c.x, c.y, c.z, c.w};
  out.pbrMetallicRoughness.metallicFactor = material.metallic;
  out.pbrMetallicRoughness.roughnessFactor = material.roughness;
  reference(material.base_color_texture, moved.texture(TextureSlot::base_color), model,
            out.pbrMetallicRoughness.baseColorTexture);
  reference(material.metallic_roughness_texture, moved.texture(TextureSlot::metallic_roughness), model,
            out.pbrMetallicRoughness.metallicRoughnessTexture);
  reference(material.normal_texture, moved.texture(TextureSlot::normal), model, out.normalTexture);
  out.normalTexture.scale = material.normal_scale;
  reference(material.occlusion_texture, moved.texture(TextureSlot::occlusion), model, out.occlusionTexture);
  out.occlusionTexture.strength = material.occlusion_strength;
  reference(material.emissive_texture, moved.texture(TextureSlot::emissive), model, out.emissiveTexture);
  // The factor must not exceed 1. Larger values are divided by a power of two, which becomes the strength, so that the
  // product is exact.
  const auto& e = material.emissive;
  const float largest = std::max({e.x, e.y, e.z});
  int exponent = 0;
  std::frexp(std::max(1.0f, largest), &exponent);
  const float excess = largest > 1.0f ? std::ldexp(1.0f, exponent) : 1.0f,
              strength = material.emissive_strength * excess;
  out.emissiveFactor = {e.x / excess, e.y / excess, e.z / excess};
  if (strength != 1.0f || moved.strength()) {
    out.extensions["KHR_materials_emissive_strength"] =
        tinygltf::Value(Object{{"emissiveStrength", tinygltf::Value(static_cast<double>(strength))}});
    declare_extension(model, "KHR_materials_emissive_strength");
  }
  if (material.unlit) {
    out.extensions["KHR_materials_unlit"] = tinygltf::Value(Object{});
    declare_extension(model, "KHR_materials_unlit");
  }
  write_material_layers(material, model, out);
  out.alphaMode = name_of(material.alpha_mode);
  out.alphaCutoff = material.alpha_cutoff;
  out.doubleSided = material.double_sided;
  return out;
}

int minify_filter(const Sampler& sampler) {
  const bool linear = sampler.minify == Filter::linear;
  if (!sampler.use_mipmaps) return linear ? TINYGLTF_TEXTURE_FILTER_LINEAR : TINYGLTF_TEXTURE_FILTER_NEAREST;
  if (sampler.mipmap == Filter::linear)
    return linear ? TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR : TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
  return linear ? TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST : TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST;
}

int wrap_of(Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp_to_edge: return TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    case Wrap::mirrored_repeat: return TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
    case Wrap::repeat: break;
  }
  return TINYGLTF_TEXTURE_WRAP_REPEAT;
}

}  // namespace

bool has_transform(const TextureUse& use) noexcept {
  return use.offset != glm::vec2(0.0f) || use.rotation_rad != 0.0f || use.scale != glm::vec2(1.0f);
}

tinygltf::Value transform_of(const TextureUse& use, tinygltf::Model& model) {
  declare_extension(model, "KHR_texture_transform");
  return tinygltf::Value(Object{{"offset", pair(use.offset)},
                                {"rotation", tinygltf::Value(static_cast<double>(use.rotation_rad))},
                                {"scale", pair(use.scale)}});
}

void write_materials(const Scene& scene, tinygltf::Model& model) {
  for (std::uint32_t m = 0; m < scene.materials.size(); ++m)
    model.materials.push_back(written(scene.materials[m], MovedParts(scene.properties, m), model));
}

void write_variants(const Scene& scene, tinygltf::Model& model) {
  if (scene.variants.empty()) return;
  constexpr const char* kExtension = "KHR_materials_variants";
  const auto number = [](std::uint32_t index) { return tinygltf::Value(static_cast<int>(index)); };
  declare_extension(model, kExtension);
  Array names;
  for (const auto& name : scene.variants) names.emplace_back(Object{{"name", tinygltf::Value(name)}});
  model.extensions[kExtension] = tinygltf::Value(Object{{"variants", tinygltf::Value(std::move(names))}});
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    for (std::size_t p = 0; p < scene.meshes[m].primitives.size(); ++p) {
      Array mappings;
      for (const VariantMaterial& other : scene.meshes[m].primitives[p].variant_materials)
        mappings.emplace_back(
            Object{{"material", number(other.material)}, {"variants", tinygltf::Value(Array{number(other.variant)})}});
      if (!mappings.empty())
        model.meshes[m].primitives[p].extensions[kExtension] =
            tinygltf::Value(Object{{"mappings", tinygltf::Value(std::move(mappings))}});
    }
}

namespace {

/// The extension for images of this type; null for core glTF types.
const char* extension_of(const std::string& mime_type) {
  if (mime_type == "image/webp") return "EXT_texture_webp";
  if (mime_type == "image/avif") return "EXT_texture_avif";
  return mime_type == "image/ktx2" ? "KHR_texture_basisu" : nullptr;
}

/// True if the encoded bytes can be written: core glTF or an extension supports the type.
bool is_kept(const Image& image) {
  const std::string& kind = image.mime_type;
  return !image.encoded.empty() && (kind == "image/png" || kind == "image/jpeg" || extension_of(kind) != nullptr);
}

/// Sets the image. A WebP, AVIF or KTX2 image is referenced only by its extension, without a fallback, so the extension
/// is required.
void set_source(const Scene& scene, std::uint32_t image, tinygltf::Model& model, tinygltf::Texture& texture) {
  const char* extension = extension_of(scene.images[image].mime_type);
  if (!is_kept(scene.images[image]) || extension == nullptr) {
    texture.source = static_cast<int>(image);
    return;
  }
  texture.extensions[extension] = tinygltf::Value(Object{{"source", tinygltf::Value(static_cast<int>(image))}});
  declare_extension(model, extension);
  auto& required = model.extensionsRequired;
  if (std::find(required.begin(), required.end(), extension) == required.end()) required.emplace_back(extension);
}

}  // namespace

void write_images(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer) {
  for (const auto& image : scene.images) {
    tinygltf::Image out;
    out.name = image.name;
    const bool keep = is_kept(image);
    out.mimeType = keep ? image.mime_type : "image/png";
    const Image placeholder{
        .name = "", .width = 1, .height = 1, .rgba = {255, 0, 255, 255}};  // a missing image becomes one magenta pixel
    out.bufferView =
        buffer.add_view(keep ? image.encoded : encode_png(image.rgba.empty() ? placeholder : image), ViewUse::other);
    model.images.push_back(std::move(out));
  }
  for (const auto& texture : scene.textures) {
    tinygltf::Sampler sampler;
    sampler.magFilter =
        texture.sampler.magnify == Filter::linear ? TINYGLTF_TEXTURE_FILTER_LINEAR : TINYGLTF_TEXTURE_FILTER_NEAREST;
    sampler.minFilter = minify_filter(texture.sampler);
    sampler.wrapS = wrap_of(texture.sampler.wrap_u);
    sampler.wrapT = wrap_of(texture.sampler.wrap_v);
    tinygltf::Texture out;
    out.sampler = static_cast<int>(model.samplers.size());
    if (texture.image != kNone) set_source(scene, texture.image, model, out);
    model.samplers.push_back(std::move(sampler));
    model.textures.push_back(std::move(out));
  }
}

void write_cameras_and_lights(const Scene& scene, tinygltf::Model& model) {
  for (const auto& camera : scene.cameras) {
    tinygltf::Camera out;
    out.name = camera.name;
    out.type = camera.perspective ? "perspective" : "orthographic";
    out.perspective = {};
    out.perspective.yfov = camera.fov_y_rad;
    out.perspective.aspectRatio = camera.aspect;
    out.perspective.znear = camera.near_m;
    out.perspective.zfar = camera.far_m;
    out.orthographic.xmag = camera.half_width;
    out.orthographic.ymag = camera.half_height;
    out.orthographic.znear = camera.near_m;
    out.orthographic.zfar = camera.far_m > 0.0f ? camera.far_m : camera.near_m + kFarPlane_m;
    model.cameras.push_back(std::move(out));
  }
  for (const auto& light : scene.lights) {
    const char* const types[] = {"directional", "point", "spot"};
    tinygltf::Light out;
    out.name = light.name;
    out.type = types[static_cast<int>(light.kind)];
    out.color = {light.color.x, light.color.y, light.color.z};
    out.intensity = light.intensity;
    out.range = light.range_m;
    out.spot.innerConeAngle = light.inner_cone_rad;
    out.spot.outerConeAngle = light.outer_cone_rad;
    model.lights.push_back(std::move(out));
  }
}

}  // namespace sinew::write
