// SPDX-License-Identifier: MIT
#include "viewer/upload/upload_materials.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/exponential.hpp>

namespace sinew::viewer {

namespace {

/// eq   KHR_texture_transform: uv' = offset + R * (scale * uv); counter-clockwise as seen in the image, whose v points
///      down
TextureTransformUniforms texture_transform(const TextureUse& use) noexcept {
  if (!use.used()) return {};
  const float c = std::cos(use.rotation_rad), s = std::sin(use.rotation_rad);
  return {{c * use.scale.x, s * use.scale.y, use.offset.x, 0.0f},
          {-s * use.scale.x, c * use.scale.y, use.offset.y, 0.0f}};
}

/// eq   KHR_materials_ior: ((ior - 1) / (ior + 1))^2; times the colour of KHR_materials_specular
glm::vec3 dielectric_f0(const Specular& s) noexcept {
  const float root = (s.ior - 1.0f) / (s.ior + 1.0f);
  return root * root * s.color;
}

/// eq   KHR_materials_volume: color^(path / distance) = exp(-absorption * path)
glm::vec3 absorption_per_m(const Volume& v) noexcept {
  constexpr float kDarkest = 1e-30f;  // black keeps a finite logarithm
  if (v.attenuation_distance_m <= 0.0f) return glm::vec3(0.0f);
  return -glm::log(glm::max(v.attenuation_color, kDarkest)) / v.attenuation_distance_m;
}

/// How the shader uses a layer's texture.
enum class Reading : std::uint8_t { data, color, alpha };  ///< alpha: not affected by sRGB decoding

constexpr std::array<Reading, kLayerTextures> kReadings = {
    Reading::alpha, Reading::color, Reading::data, Reading::data, Reading::data, Reading::color,
    Reading::alpha, Reading::data,  Reading::data, Reading::data, Reading::data, Reading::data};

/// For each layer texture: true if its layer has an effect.
std::array<bool, kLayerTextures> layers_shown(const Material& m) noexcept {
  const bool specular = !m.unlit && m.specular.has_effect(), coat = !m.unlit && m.clearcoat.factor > 0.0f;
  const bool sheen = !m.unlit && m.sheen.color != glm::vec3(0.0f);
  const bool transmission = !m.unlit && m.transmission.factor > 0.0f;
  const bool film = !m.unlit && m.iridescence.factor > 0.0f, anisotropy = !m.unlit && m.anisotropy.strength > 0.0f;
  const bool volume = transmission && m.volume.thickness_m > 0.0f;
  return {specular, specular, coat, coat, coat, sheen, sheen, transmission, film, film, anisotropy, volume};
}

/// The descriptor place of each layer texture, and the content of the places.
struct Places {
  std::array<TexturePlace, kTexturePlaces> held;
  std::array<std::size_t, kLayerTextures> of_layer{};  ///< kTexturePlaces = none
  bool complete = true;
};

Places places_of(const Material& m) noexcept {
  const auto uses = texture_uses(m);
  const auto shown = layers_shown(m);
  Places places;
  for (std::size_t i = 0; i < kMaterialTextures; ++i) places.held[i] = {uses[i]->texture, {.srgb = i == 4}};
  places.held[0].use = base_color_use(m);
  places.of_layer.fill(kTexturePlaces);
  for (std::size_t i = 0; i < kLayerTextures; ++i) {
    const std::uint32_t texture = uses[kMaterialTextures + i]->texture;
    if (!shown[i] || texture == kNone) continue;
    const TexelUse use{.srgb = kReadings[i] == Reading::color};
    const auto find = [&](const auto& fits) {
      return static_cast<std::size_t>(std::find_if(places.held.begin(), places.held.end(), fits) - places.held.begin());
    };
    std::size_t place = find([&](const TexturePlace& p) {
      return p.texture == texture && (p.use == use || (kReadings[i] == Reading::alpha && p.use.cutoff == 0));
    });
    if (place == kTexturePlaces) place = find([](const TexturePlace& p) { return p.texture == kNone; });
    if (place == kTexturePlaces) {
      places.complete = false;
      continue;
    }
    if (places.held[place].texture == kNone) places.held[place] = {texture, use};
    places.of_layer[i] = place;
  }
  return places;
}

}  // namespace

MaterialUniforms material_uniforms(const Material& m) noexcept {
  MaterialUniforms out{m.base_color,          m.emissive * m.emissive_strength,
                       m.alpha_cutoff,        m.metallic,
                       m.roughness,           m.normal_scale,
                       m.occlusion_strength,  dielectric_f0(m.specular),
                       m.specular.factor,     m.clearcoat.factor,
                       m.clearcoat.roughness, m.clearcoat.normal_scale,
                       m.transmission.factor, m.sheen.color,
                       m.sheen.roughness};
  const Iridescence& film = m.iridescence;
  out.iridescence = film.factor;
  out.film_ior = film.ior;
  out.film_thinnest_m = 1e-9f * (film.thickness_texture.used() ? film.thinnest_nm : film.thickest_nm);
  out.film_thickest_m = 1e-9f * film.thickest_nm;
  out.anisotropy_turn = {std::cos(m.anisotropy.rotation_rad), std::sin(m.anisotropy.rotation_rad)};
  out.anisotropy = m.anisotropy.strength;
  out.thickness_m = m.volume.thickness_m;
  out.absorption_per_m = absorption_per_m(m.volume);
  out.inverse_ior = 1.0f / std::max(m.specular.ior, 1.0f);
  const auto uses = texture_uses(m);
  for (std::size_t i = 0; i < uses.size(); ++i) out.transforms[i] = texture_transform(*uses[i]);
  return out;
}

bool shows_behind(const Material& m) noexcept { return m.alpha_mode == AlphaMode::blend || layers_shown(m)[7]; }

MaterialFeatures material_features(const Material& m) noexcept {
  const auto uses = texture_uses(m);
  const Places places = places_of(m);
  MaterialFeatures out{.unlit = m.unlit};
  for (std::size_t i = 0; i < kMaterialTextures; ++i)
    if (uses[i]->used()) out.texcoord_sets[i] = uses[i]->texcoord == 1 ? 2 : 1;
  const auto shown = layers_shown(m);
  out.layers.specular = shown[0];
  out.layers.clearcoat = shown[2];
  out.layers.sheen = shown[5];
  out.layers.transmission = shown[7];
  out.layers.iridescence = shown[8];
  out.layers.anisotropy = shown[10];
  out.layers.volume = shown[11];
  for (std::size_t i = 0; i < kLayerTextures; ++i)
    if (const std::size_t place = places.of_layer[i]; place < kTexturePlaces)
      out.layers.textures[i] =
          static_cast<std::uint8_t>(1 + 2 * place + (uses[kMaterialTextures + i]->texcoord == 1 ? 1 : 0));
  out.layers.glossiness = m.specular.has_glossiness && out.layers.textures[kSpecularColor] != 0;
  return out;
}

std::array<TexturePlace, kTexturePlaces> texture_places(const Material& m) noexcept { return places_of(m).held; }

bool shows_all_textures(const Material& m) noexcept { return places_of(m).complete; }

VkDescriptorSetLayout make_material_layout(const Device& device) {
  std::array<VkDescriptorSetLayoutBinding, 1 + kTexturePlaces> bindings{};
  for (std::uint32_t i = 0; i < bindings.size(); ++i)
    bindings[i] = {i, i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                   VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  must(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout), "vkCreateDescriptorSetLayout");
  return layout;
}

namespace {

/// The value of MaterialFeatures::wraps.
std::uint32_t wraps_of(const Scene& scene, const Material& material) noexcept {
  std::uint32_t wraps = 0;
  const auto places = texture_places(material);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].texture == kNone) continue;
    const Sampler& sampler = scene.textures[places[i].texture].sampler;
    wraps |= (static_cast<std::uint32_t>(sampler.wrap_u) | static_cast<std::uint32_t>(sampler.wrap_v) << 2) << (4 * i);
  }
  return wraps;
}

}  // namespace

MaterialSet::MaterialSet(Device& device, const Scene& scene, Staging& staging, std::uint32_t slot_count,
                         const TextureFilter& filter)
    : device_(device),
      scene_(scene),
      textures_(device, filter),
      count_(static_cast<std::uint32_t>(scene.materials.size() + 1)) {
  for (const PropertyTable::Entry& entry : scene.properties.entries)
    if (entry.target.kind >= PropertyKind::base_color) animated_.push_back(entry.target.index);
  std::sort(animated_.begin(), animated_.end());
  animated_.erase(std::unique(animated_.begin(), animated_.end()), animated_.end());
  if (!animated_.empty()) slots_ = slot_count;
  layout_ = make_material_layout(device);
  allocate_sets();
  const VkDeviceSize alignment = device.limits().minUniformBufferOffsetAlignment;
  stride_ = (sizeof(MaterialUniforms) + alignment - 1) / alignment * alignment;
  uniforms_ = Buffer(device, stride_ * sets_.size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, MemoryUse::upload);
  for (std::size_t set = 0; set < sets_.size(); ++set) {
    const std::size_t material = set % count_;
    write_set(set, material < scene.materials.size() ? scene.materials[material] : Material{}, staging);
  }
  for (std::size_t i = 0; i < count_; ++i) {
    const Material material = i < scene.materials.size() ? usable(scene.materials[i]) : Material{};
    MaterialFeatures features = material_features(material);
    features.rip_maps = filter.kind == FilterKind::rip_map;
    if (features.rip_maps) features.wraps = wraps_of(scene, material);
    features_.push_back(features);
  }
}

void MaterialSet::allocate_sets() {
  const std::uint32_t count = count_ * slots_;
  const std::array<VkDescriptorPoolSize, 2> sizes = {
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, count},
       {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, static_cast<std::uint32_t>(kTexturePlaces) * count}}};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = count;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  must(vkCreateDescriptorPool(device_.handle(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");

  const std::vector<VkDescriptorSetLayout> layouts(count, layout_);
  sets_.resize(count);
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = count;
  allocate.pSetLayouts = layouts.data();
  must(vkAllocateDescriptorSets(device_.handle(), &allocate, sets_.data()), "vkAllocateDescriptorSets");
}

MaterialSet::~MaterialSet() {
  vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), layout_, nullptr);
}

void MaterialSet::update(std::uint32_t slot, std::span<const Material> materials) {
  for (const std::uint32_t m : animated_) write_uniforms(slot % slots_ * count_ + m, usable(materials[m]));
}

/// The material without unreadable textures, so that only the factors count. Base colour and emission keep theirs and
/// show the placeholder.
Material MaterialSet::usable(const Material& given) const {
  Material material = given;
  for (TextureUse* use : texture_uses(material)) {
    const bool replaced = use == &material.base_color_texture || use == &material.emissive_texture;
    if (!replaced && !readable(scene_, *use)) *use = {};
  }
  return material;
}

void MaterialSet::write_uniforms(std::size_t set, const Material& material) {
  const MaterialUniforms uniforms = material_uniforms(material);
  std::memcpy(uniforms_.mapped() + stride_ * set, &uniforms, sizeof(uniforms));
}

void MaterialSet::write_set(std::size_t set, const Material& given, Staging& staging) {
  const Material material = usable(given);
  write_uniforms(set, material);
  const VkDescriptorBufferInfo buffer{uniforms_.handle(), stride_ * set, sizeof(MaterialUniforms)};
  std::array<VkDescriptorImageInfo, kTexturePlaces> images{};
  const auto places = texture_places(material);
  for (std::size_t i = 0; i < places.size(); ++i)
    images[i] = textures_.bind(scene_, places[i].texture, places[i].use, staging);
  std::array<VkWriteDescriptorSet, 1 + kTexturePlaces> writes{};
  for (std::uint32_t i = 0; i < writes.size(); ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = sets_[set];
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    writes[i].pBufferInfo = i == 0 ? &buffer : nullptr;
    writes[i].pImageInfo = i == 0 ? nullptr : &images[i - 1];
  }
  vkUpdateDescriptorSets(device_.handle(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

}  // namespace sinew::viewer
