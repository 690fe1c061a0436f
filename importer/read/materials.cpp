// SPDX-License-Identifier: MIT
#include "importer/read/materials.h"

#include <algorithm>
#include <map>
#include <string>

#include "importer/file/json_pointer.h"
#include "importer/import_gltf.h"
#include "importer/read/extension_fields.h"
#include "importer/read/material_layers.h"
#include "importer/read/textures.h"

namespace sinew {
namespace {

class MaterialReader {
 public:
  MaterialReader(const gltf::Document& document, std::size_t index, IssueLog& log)
      : document_(document), source_(document.materials[index]), place_(pointer("materials", index)), log_(log) {}

  Material read() {
    out_.name = source_.name;
    read_metallic_roughness();
    read_surface();
    read_alpha();
    read_emission();
    read_material_layers(source_.extensions, place_, document_.textures.size(), out_, log_);
    read_specular_glossiness();
    out_.unlit = static_cast<bool>(ExtensionFields(source_.extensions, place_, "KHR_materials_unlit", log_));
    return std::move(out_);
  }

 private:
  void read_metallic_roughness() {
    const std::string place = pointer(place_, "pbrMetallicRoughness");
    for (int c = 0; c < 4; ++c)
      out_.base_color[c] = clamped(surface_.baseColorFactor[static_cast<std::size_t>(c)], place, "baseColorFactor");
    out_.metallic = clamped(surface_.metallicFactor, place, "metallicFactor");
    out_.roughness = clamped(surface_.roughnessFactor, place, "roughnessFactor");
    out_.base_color_texture = texture(TextureSlot::base_color, pointer(place, "baseColorTexture"));
    out_.metallic_roughness_texture =
        texture(TextureSlot::metallic_roughness, pointer(place, "metallicRoughnessTexture"));
  }

  void read_surface() {
    out_.normal_texture = texture(TextureSlot::normal, pointer(place_, "normalTexture"));
    out_.normal_scale = static_cast<float>(source_.normalTexture.scale);
    out_.occlusion_texture = texture(TextureSlot::occlusion, pointer(place_, "occlusionTexture"));
    out_.occlusion_strength =
        clamped(source_.occlusionTexture.strength, pointer(place_, "occlusionTexture"), "strength");
    out_.double_sided = source_.doubleSided;
  }

  void read_alpha() {
    const std::string& mode = source_.alphaMode;
    out_.alpha_mode = mode == "MASK" ? AlphaMode::mask : mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
    if (out_.alpha_mode == AlphaMode::opaque && mode != "OPAQUE")
      log_.report(Rule::material_values, pointer(place_, "alphaMode"),
                  in_quotes(mode) + " is no alpha mode; OPAQUE is used");
    out_.alpha_cutoff = static_cast<float>(source_.alphaCutoff);
    if (source_.alphaCutoff < 0.0) {
      log_.report(Rule::material_values, pointer(place_, "alphaCutoff"),
                  std::to_string(source_.alphaCutoff) + "; 0 is used");
      out_.alpha_cutoff = 0.0f;
    }
  }

  void read_emission() {
    const ExtensionFields extension(source_.extensions, place_, "KHR_materials_emissive_strength", log_);
    out_.emissive_strength = static_cast<float>(extension.number("emissiveStrength", 1.0, 0.0));
    for (std::size_t c = 0; c < source_.emissiveFactor.size(); ++c)
      out_.emissive[static_cast<int>(c)] = clamped(source_.emissiveFactor[c], place_, "emissiveFactor");
    out_.emissive_texture = texture(TextureSlot::emissive, pointer(place_, "emissiveTexture"));
  }

  bool has_metallic_roughness() const {
    const tinygltf::PbrMetallicRoughness plain;
    return surface_.baseColorFactor != plain.baseColorFactor || surface_.metallicFactor != plain.metallicFactor ||
           surface_.roughnessFactor != plain.roughnessFactor || surface_.baseColorTexture.index != gltf::kAbsent ||
           surface_.metallicRoughnessTexture.index != gltf::kAbsent;
  }

  /// Diffuse light loses the reflected part once, by Fresnel. The archived text takes the specular colour off as well,
  /// which darkens the diffuse part by up to that colour (4 % for plain dielectrics).
  void read_specular_glossiness() {
    const ExtensionFields extension(source_.extensions, place_, "KHR_materials_pbrSpecularGlossiness", log_);
    if (!extension) return;
    if (has_metallic_roughness()) return;
    // A dielectric whose specular colour is the whole reflectance along the normal: ior 0 means that it has no other.
    out_.metallic = 0.0f;
    extension.numbers("diffuseFactor", &out_.base_color.x, 4, 0.0, 1.0);
    out_.base_color_texture = read_texture_use(extension, "diffuseTexture", document_.textures.size());
    out_.roughness = 1.0f - static_cast<float>(extension.number("glossinessFactor", 1.0, 0.0, 1.0));
    Specular specular{.ior = 0.0f};
    extension.numbers("specularFactor", &specular.color.x, 3, 0.0, 1.0);
    specular.color_texture = read_texture_use(extension, "specularGlossinessTexture", document_.textures.size());
    specular.has_glossiness = specular.color_texture.used();
    out_.specular = specular;
  }

  TextureUse texture(TextureSlot slot, const std::string& place) {
    return read_texture_use(texture_info(source_, slot), place, log_);
  }

  float clamped(double value, const std::string& place, const char* name) {
    const double inside = std::clamp(value, 0.0, 1.0);
    if (inside != value)
      log_.report(Rule::material_values, pointer(place, name),
                  std::to_string(value) + "; " + std::to_string(inside) + " is used");
    return static_cast<float>(inside);
  }

  const gltf::Document& document_;
  const gltf::Material& source_;
  const tinygltf::PbrMetallicRoughness& surface_ = source_.pbrMetallicRoughness;
  std::string place_;
  IssueLog& log_;
  Material out_;
};

/// An unsupported material extension: its first location, and the number of materials that use it.
struct Unread {
  std::string place;
  std::size_t materials = 0;
};

/// Reports each unsupported material extension once.
void report_unread_extensions(const gltf::Document& document, IssueLog& log) {
  std::map<std::string, Unread> found;
  for (std::size_t m = 0; m < document.materials.size(); ++m) {
    const gltf::Json& extensions = document.materials[m].extensions;
    if (!extensions.is_object()) continue;
    for (const auto& [name, value] : extensions.items()) {
      if (extension_support(name) == ExtensionSupport::read) continue;
      Unread& unread = found[name];
      if (unread.materials++ == 0) unread.place = pointer("materials", m, "extensions", pointer_token(name));
    }
  }
  for (const auto& [name, unread] : found)
    log.report(Rule::material_extension, unread.place,
               in_quotes(name) + " is not read; materials that have it: " + std::to_string(unread.materials));
}

}  // namespace

std::vector<Material> read_materials(const gltf::Document& document, IssueLog& log) {
  std::vector<Material> materials;
  materials.reserve(document.materials.size());
  for (std::size_t m = 0; m < document.materials.size(); ++m)
    materials.push_back(MaterialReader(document, m, log).read());
  report_unread_extensions(document, log);
  return materials;
}

}  // namespace sinew
