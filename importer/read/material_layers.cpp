// SPDX-License-Identifier: MIT
#include "importer/read/material_layers.h"

#include "importer/file/json_pointer.h"
#include "importer/read/extension_fields.h"
#include "importer/read/textures.h"

namespace sinew {
namespace {

float share(const ExtensionFields& extension, const char* name, double fallback) {
  return static_cast<float>(extension.number(name, fallback, 0.0, 1.0));
}

/// Reads the index of refraction: at least 1, or 0 for a surface that reflects all light.
float read_ior(const ExtensionFields& extension) {
  const double ior = extension.number("ior", 1.5, 0.0);
  if (ior == 0.0 || ior >= 1.0) return static_cast<float>(ior);
  extension.log().report(Rule::extension_value, pointer(extension.place(), "ior"),
                         std::to_string(ior) + " is between 0 and 1; the default is used");
  return 1.5f;
}

Specular read_specular(const ExtensionFields& ior, const ExtensionFields& extension, std::size_t textures) {
  Specular out;
  out.ior = read_ior(ior);
  out.factor = share(extension, "specularFactor", 1.0);
  out.texture = read_texture_use(extension, "specularTexture", textures);
  extension.numbers("specularColorFactor", &out.color.x, 3, 0.0);
  out.color_texture = read_texture_use(extension, "specularColorTexture", textures);
  return out;
}

Clearcoat read_clearcoat(const ExtensionFields& extension, std::size_t textures) {
  Clearcoat out;
  out.factor = share(extension, "clearcoatFactor", 0.0);
  out.texture = read_texture_use(extension, "clearcoatTexture", textures);
  out.roughness = share(extension, "clearcoatRoughnessFactor", 0.0);
  out.roughness_texture = read_texture_use(extension, "clearcoatRoughnessTexture", textures);
  out.normal_texture = read_texture_use(extension, "clearcoatNormalTexture", textures);
  out.normal_scale = static_cast<float>(extension.object("clearcoatNormalTexture").number("scale", 1.0));
  return out;
}

Sheen read_sheen(const ExtensionFields& extension, std::size_t textures) {
  Sheen out;
  extension.numbers("sheenColorFactor", &out.color.x, 3, 0.0, 1.0);
  out.color_texture = read_texture_use(extension, "sheenColorTexture", textures);
  out.roughness = share(extension, "sheenRoughnessFactor", 0.0);
  out.roughness_texture = read_texture_use(extension, "sheenRoughnessTexture", textures);
  return out;
}

Iridescence read_iridescence(const ExtensionFields& extension, std::size_t textures) {
  Iridescence out;
  out.factor = share(extension, "iridescenceFactor", 0.0);
  out.texture = read_texture_use(extension, "iridescenceTexture", textures);
  out.ior = static_cast<float>(extension.number("iridescenceIor", 1.3, 1.0));
  out.thinnest_nm = static_cast<float>(extension.number("iridescenceThicknessMinimum", 100.0, 0.0));
  out.thickest_nm = static_cast<float>(extension.number("iridescenceThicknessMaximum", 400.0, 0.0));
  out.thickness_texture = read_texture_use(extension, "iridescenceThicknessTexture", textures);
  return out;
}

Anisotropy read_anisotropy(const ExtensionFields& extension, std::size_t textures) {
  return {share(extension, "anisotropyStrength", 0.0), static_cast<float>(extension.number("anisotropyRotation", 0.0)),
          read_texture_use(extension, "anisotropyTexture", textures)};
}

Volume read_volume(const ExtensionFields& extension, std::size_t textures) {
  Volume out;
  out.thickness_m = static_cast<float>(extension.number("thicknessFactor", 0.0, 0.0));
  out.texture = read_texture_use(extension, "thicknessTexture", textures);
  out.attenuation_distance_m = static_cast<float>(extension.number("attenuationDistance", 0.0, 0.0));
  extension.numbers("attenuationColor", &out.attenuation_color.x, 3, 0.0, 1.0);
  return out;
}

}  // namespace

void read_material_layers(const gltf::Json& extensions, const std::string& place, std::size_t textures,
                          Material& material, IssueLog& log) {
  const auto of = [&](const char* name) { return ExtensionFields(extensions, place, name, log); };
  material.specular = read_specular(of("KHR_materials_ior"), of("KHR_materials_specular"), textures);
  material.clearcoat = read_clearcoat(of("KHR_materials_clearcoat"), textures);
  material.sheen = read_sheen(of("KHR_materials_sheen"), textures);
  material.iridescence = read_iridescence(of("KHR_materials_iridescence"), textures);
  material.anisotropy = read_anisotropy(of("KHR_materials_anisotropy"), textures);
  material.volume = read_volume(of("KHR_materials_volume"), textures);
  const ExtensionFields transmission = of("KHR_materials_transmission");
  material.transmission = {share(transmission, "transmissionFactor", 0.0),
                           read_texture_use(transmission, "transmissionTexture", textures)};
}

}  // namespace sinew
