// SPDX-License-Identifier: MIT
#include <string>

#include "importer/write/write_scene.h"

namespace sinew::write {
namespace {

using Object = tinygltf::Value::Object;
using Array = tinygltf::Value::Array;

tinygltf::Value number(float value) { return tinygltf::Value(static_cast<double>(value)); }

tinygltf::Value color(const glm::vec3& c) { return tinygltf::Value(Array{number(c.x), number(c.y), number(c.z)}); }

/// Adds the texture reference `name`, if the texture is used.
/// in   scale  of a normal texture; 1 is omitted
void add_texture(Object& extension, const char* name, const TextureUse& use, tinygltf::Model& model,
                 float scale = 1.0f) {
  if (!use.used()) return;
  Object info{{"index", tinygltf::Value(static_cast<int>(use.texture))},
              {"texCoord", tinygltf::Value(static_cast<int>(use.texcoord))}};
  if (scale != 1.0f) info["scale"] = number(scale);
  if (has_transform(use))
    info["extensions"] = tinygltf::Value(Object{{"KHR_texture_transform", transform_of(use, model)}});
  extension[name] = tinygltf::Value(std::move(info));
}

/// Declares and adds an extension, unless it is empty.
void add(const char* name, Object&& extension, tinygltf::Model& model, tinygltf::Material& out) {
  if (extension.empty()) return;
  out.extensions[name] = tinygltf::Value(std::move(extension));
  declare_extension(model, name);
}

Object written(const Specular& s, tinygltf::Model& model) {
  Object out;
  if (s.factor != 1.0f) out["specularFactor"] = number(s.factor);
  if (s.color != glm::vec3(1.0f)) out["specularColorFactor"] = color(s.color);
  add_texture(out, "specularTexture", s.texture, model);
  add_texture(out, "specularColorTexture", s.color_texture, model);
  return out;
}

Object written(const Clearcoat& c, tinygltf::Model& model) {
  Object out;
  if (c.factor != 0.0f) out["clearcoatFactor"] = number(c.factor);
  if (c.roughness != 0.0f) out["clearcoatRoughnessFactor"] = number(c.roughness);
  add_texture(out, "clearcoatTexture", c.texture, model);
  add_texture(out, "clearcoatRoughnessTexture", c.roughness_texture, model);
  add_texture(out, "clearcoatNormalTexture", c.normal_texture, model, c.normal_scale);
  return out;
}

Object written(const Sheen& s, tinygltf::Model& model) {
  Object out;
  if (s.color != glm::vec3(0.0f)) out["sheenColorFactor"] = color(s.color);
  if (s.roughness != 0.0f) out["sheenRoughnessFactor"] = number(s.roughness);
  add_texture(out, "sheenColorTexture", s.color_texture, model);
  add_texture(out, "sheenRoughnessTexture", s.roughness_texture, model);
  return out;
}

Object written(const Transmission& t, tinygltf::Model& model) {
  Object out;
  if (t.factor != 0.0f) out["transmissionFactor"] = number(t.factor);
  add_texture(out, "transmissionTexture", t.texture, model);
  return out;
}

Object written(const Iridescence& i, tinygltf::Model& model) {
  Object out;
  if (i.factor != 0.0f) out["iridescenceFactor"] = number(i.factor);
  if (i.ior != 1.3f) out["iridescenceIor"] = number(i.ior);
  if (i.thinnest_nm != 100.0f) out["iridescenceThicknessMinimum"] = number(i.thinnest_nm);
  if (i.thickest_nm != 400.0f) out["iridescenceThicknessMaximum"] = number(i.thickest_nm);
  add_texture(out, "iridescenceTexture", i.texture, model);
  add_texture(out, "iridescenceThicknessTexture", i.thickness_texture, model);
  return out;
}

Object written(const Anisotropy& a, tinygltf::Model& model) {
  Object out;
  if (a.strength != 0.0f) out["anisotropyStrength"] = number(a.strength);
  if (a.rotation_rad != 0.0f) out["anisotropyRotation"] = number(a.rotation_rad);
  add_texture(out, "anisotropyTexture", a.texture, model);
  return out;
}

Object written(const Volume& v, tinygltf::Model& model) {
  Object out;
  if (v.thickness_m != 0.0f) out["thicknessFactor"] = number(v.thickness_m);
  if (v.attenuation_distance_m != 0.0f) out["attenuationDistance"] = number(v.attenuation_distance_m);
  if (v.attenuation_color != glm::vec3(1.0f)) out["attenuationColor"] = color(v.attenuation_color);
  add_texture(out, "thicknessTexture", v.texture, model);
  return out;
}

/// Writes the surface as specular-glossiness, in place of metallic-roughness. No other extension has glossiness in the
/// alpha of a specular colour.
void write_specular_glossiness(const Material& m, tinygltf::Model& model, tinygltf::Material& out) {
  Object extension{{"diffuseFactor", tinygltf::Value(Array{number(m.base_color.x), number(m.base_color.y),
                                                           number(m.base_color.z), number(m.base_color.w)})},
                   {"specularFactor", color(m.specular.color)},
                   {"glossinessFactor", number(1.0f - m.roughness)}};
  add_texture(extension, "diffuseTexture", m.base_color_texture, model);
  add_texture(extension, "specularGlossinessTexture", m.specular.color_texture, model);
  out.pbrMetallicRoughness = {};
  add("KHR_materials_pbrSpecularGlossiness", std::move(extension), model, out);
}

}  // namespace

void write_material_layers(const Material& material, tinygltf::Model& model, tinygltf::Material& out) {
  if (material.specular.has_glossiness) {
    write_specular_glossiness(material, model, out);
  } else {
    if (material.specular.ior != 1.5f)
      add("KHR_materials_ior", Object{{"ior", number(material.specular.ior)}}, model, out);
    add("KHR_materials_specular", written(material.specular, model), model, out);
  }
  add("KHR_materials_clearcoat", written(material.clearcoat, model), model, out);
  add("KHR_materials_sheen", written(material.sheen, model), model, out);
  add("KHR_materials_transmission", written(material.transmission, model), model, out);
  add("KHR_materials_iridescence", written(material.iridescence, model), model, out);
  add("KHR_materials_anisotropy", written(material.anisotropy, model), model, out);
  add("KHR_materials_volume", written(material.volume, model), model, out);
}

}  // namespace sinew::write
