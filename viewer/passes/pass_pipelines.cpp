// SPDX-License-Identifier: MIT
#include "viewer/passes/pass_resources.h"

#include <algorithm>

namespace sinew::viewer {

namespace {

constexpr std::array<VkFormat, kAttributeCount> kAttributeFormats = {
    VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT,    VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
    VK_FORMAT_R32G32_SFLOAT,    VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R32_SFLOAT,          VK_FORMAT_R32_SFLOAT};

VkPrimitiveTopology vulkan(Topology topology) noexcept {
  switch (topology) {
    case Topology::points: return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case Topology::lines: return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    default: return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  }
}

bool encodes_in_hardware(VkFormat format) noexcept {
  return format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB ||
         format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

/// Ids of specialisation constants; each shader declares those that it uses. Ids 0 to 2 have a meaning of their own in
/// each shader.
enum ConstantId : std::size_t {
  id_masked = 0,
  id_blended = 1,
  id_occluded = 2,
  id_ao_step = 3,
  id_parallel = 4,
  id_normals = 5,
  id_tangents = 6,
  id_unlit = 7,
  id_texcoord_sets = 8,
  id_tone_curve = 8,  // same id: full-screen shaders have no texture coordinates
  id_backdrop = 9,
  id_backdrop_columns = 10,  // likewise
  id_backdrop_rows = 11,
  id_light_count = 13,
  id_transparent_background = 14,
  id_ambient = 15,
  id_shadow_map = 16,
  id_shadow_lights = 17,
  id_unlit_image = 18,
  id_auto_exposure = 19,
  id_vertex_visibility = 20,
  id_bent = 23,
  id_specular = 24,
  id_clearcoat = 25,
  id_sheen = 26,
  id_through = 27,
  id_iridescence = 28,
  id_anisotropy = 29,
  id_volume = 30,
  id_glossiness = 31,
  id_wraps = 36,
  id_show_level = 37,
  id_quaternions = 38,
  id_weighted = 39,  // full-screen shaders: the frame has weighted sums
  id_layer_textures = 40
};

bool reads_textures(const MaterialFeatures& material) noexcept {
  constexpr auto is_read = [](std::uint8_t use) { return use != 0; };
  return std::any_of(material.texcoord_sets.begin(), material.texcoord_sets.end(), is_read) ||
         std::any_of(material.layers.textures.begin(), material.layers.textures.end(), is_read);
}

Blending blending_of(Through step) noexcept {
  switch (step) {
    case Through::nothing: return Blending::over;
    case Through::filter:
    case Through::filter_drawn: return Blending::filter;
    case Through::blurred_backdrop:
    case Through::sharp_backdrop: return Blending::uncovered;
    case Through::erase: return Blending::erase;
    default: return Blending::add;
  }
}

/// True for steps that show the blurred opaque picture through a rough surface.
bool is_frosted(Through step) noexcept {
  return step == Through::frosted || step == Through::frosted_blurred || step == Through::frosted_sharp;
}

/// True for steps that draw the surface's own light.
bool adds_light(Through step) noexcept {
  return step == Through::nothing || step == Through::light || is_frosted(step);
}

/// Removes features that the pass's shaders do not use, so that draws share pipelines.
MeshPipelineKey without_unused_features(MeshPipelineKey key) {
  SurfaceFeatures& surface = key.surface;
  auto& sets = surface.material.texcoord_sets;
  key.frame.transparent_background = false;
  key.frame.tone_curve = {};
  key.frame.auto_exposure = false;
  key.frame.smooth_edges = key.frame.smooth_edges && key.pass != Pass::normal_depth && key.pass != Pass::shadow;
  key.frame.backdrop = {};
  const bool shades = key.pass != Pass::normal_depth && !key.depth_only;
  key.frame.weighted = false;
  if (key.pass == Pass::transparent || key.pass == Pass::weighted)
    key.frame.occluded = key.frame.bent = false;  // the ambient visibility image holds only opaque surfaces
  const bool shows_level = key.pass == Pass::normal_depth && !key.depth_only && key.frame.shows_level;
  key.frame.shows_level = shows_level;
  if (key.depth_only || shows_level) surface.normals = NormalSource::none;
  if (surface.material.unlit && shades) surface.normals = NormalSource::none;
  const bool shows_visibility = key.pass == Pass::normal_depth && !key.depth_only;
  if ((!shades && !shows_visibility) || surface.normals == NormalSource::none) key.frame.vertex_visibility = false;
  if (!shades || surface.normals == NormalSource::none) {
    key.frame.occluded = key.frame.bent = key.frame.ambient = false;
    key.frame.light_count = 0;
    key.frame.shadow_lights = 0;
    sets[1] = sets[3] = 0;
    surface.material.layers = {};
  }
  if (key.depth_only || surface.normals == NormalSource::none) sets[2] = 0;
  if (!shades || surface.material.unlit) sets[4] = 0;
  if (!shades) key.frame.unlit_image = false;
  if (!shades) surface.material.unlit = false;
  if (!shades && !key.masked && !shows_level) sets[0] = 0;
  key.frame.gooch = key.frame.gooch && shades && !surface.material.unlit;
  if (key.frame.gooch) {
    key.frame.light_count = 0;
    sets[1] = sets[2] = sets[3] = sets[4] = 0;
    surface.material.layers = {};
  }
  if (key.through == Through::nothing) surface.material.layers.transmission = false;
  if (!is_frosted(key.through)) surface.material.layers.volume = false;
  if (!adds_light(key.through)) {
    key.frame.ambient = false;
    key.frame.light_count = 0;
    key.frame.shadow_lights = 0;
    key.frame.vertex_visibility = false;
    sets[3] = sets[4] = 0;
  }
  const LayerFeatures& layers = surface.material.layers;
  if (sets[2] == 0 && layers.textures[kClearcoatNormal] == 0 && !layers.anisotropy) surface.tangents = false;
  key.frame.quaternion_normals = key.frame.quaternion_normals && surface.normals == NormalSource::vertices;
  surface.double_sided = surface.double_sided && key.frame.quaternion_normals;
  if (!reads_textures(surface.material)) {
    surface.material.rip_maps = false;
    surface.material.wraps = 0;
  }
  return key;
}

}  // namespace

PassPipelines::PassPipelines(const Device& device, const PassLayouts& layouts, VkFormat target_format,
                             const OcclusionShape& occlusion)
    : device_(device), layouts_(layouts), target_format_(target_format), occlusion_(occlusion) {}

PassPipelines::~PassPipelines() {
  for (const auto& [key, pipeline] : mesh_) vkDestroyPipeline(device_.handle(), pipeline, nullptr);
  for (const auto& [key, pipeline] : screen_) vkDestroyPipeline(device_.handle(), pipeline, nullptr);
}

bool PassPipelines::encodes() const noexcept { return !encodes_in_hardware(target_format_); }

VkPipeline PassPipelines::mesh(const MeshPipelineKey& given) {
  const MeshPipelineKey key = without_unused_features(given);
  VkPipeline& pipeline = mesh_[key];
  if (pipeline) return pipeline;
  std::array<VkVertexInputBindingDescription, kAttributeCount> bindings{};
  std::array<VkVertexInputAttributeDescription, kAttributeCount> attributes{};
  for (std::uint32_t a = 0; a < kAttributeCount; ++a) {
    bindings[a] = {a, kAttributeBytes[a], VK_VERTEX_INPUT_RATE_VERTEX};
    attributes[a] = {a, a, kAttributeFormats[a], 0};
  }
  PipelineShape shape;
  shape.vertex = Shader::geometry_vert;
  shape.topology = vulkan(key.topology);
  shape.depth = true;
  shape.samples = key.frame.smooth_edges ? kSmoothSamples : 1;
  shape.meshes = true;
  shape.bindings = bindings;
  shape.attributes = attributes;
  const bool prepass = key.pass == Pass::normal_depth || key.depth_only, weighted = key.pass == Pass::weighted,
             blended = weighted || key.pass == Pass::transparent;
  const bool cut_samples = key.depth_only && key.masked && shape.samples > 1;
  const bool rip = key.surface.material.rip_maps;
  shape.fragment = cut_samples       ? rip ? Shader::cut_samples_rip_frag : Shader::cut_samples_frag
                   : prepass         ? rip ? Shader::normal_depth_rip_frag : Shader::normal_depth_frag
                   : key.frame.gooch ? rip ? Shader::gooch_rip_frag : Shader::gooch_frag
                   : rip             ? Shader::shade_rip_frag
                                     : Shader::shade_frag;
  shape.color_format = key.depth_only ? VK_FORMAT_UNDEFINED : prepass ? kNormalFormat : kColorFormat;
  shape.constants[id_masked] = key.masked;
  shape.constants[id_blended] = blended && !key.covers;
  shape.constants[id_weighted] = weighted;
  shape.constants[id_through] = static_cast<std::uint32_t>(key.through);
  shape.constants[id_occluded] = key.frame.occluded;
  shape.constants[id_bent] = key.frame.bent;
  shape.constants[id_ao_step] = occlusion_.step;
  shape.constants[id_parallel] = key.frame.parallel;
  shape.constants[id_normals] = static_cast<std::uint32_t>(key.surface.normals);
  shape.constants[id_tangents] = key.surface.tangents;
  shape.constants[id_unlit] = key.surface.material.unlit;
  for (std::size_t i = 0; i < kMaterialTextures; ++i)
    shape.constants[id_texcoord_sets + i] = key.surface.material.texcoord_sets[i];
  const LayerFeatures& layers = key.surface.material.layers;
  shape.constants[id_specular] = layers.specular;
  shape.constants[id_clearcoat] = layers.clearcoat;
  shape.constants[id_sheen] = layers.sheen;
  shape.constants[id_iridescence] = layers.iridescence;
  shape.constants[id_anisotropy] = layers.anisotropy;
  shape.constants[id_volume] = layers.volume;
  shape.constants[id_glossiness] = layers.glossiness;
  for (std::size_t i = 0; i < kLayerTextures; ++i) shape.constants[id_layer_textures + i] = layers.textures[i];
  shape.constants[id_wraps] = key.surface.material.wraps;
  shape.constants[id_quaternions] = key.frame.quaternion_normals ? key.surface.double_sided ? 2 : 1 : 0;
  shape.constants[id_show_level] = key.frame.shows_level;
  shape.constants[id_light_count] = key.frame.light_count;
  shape.constants[id_ambient] = key.frame.ambient;
  shape.constants[id_unlit_image] = key.frame.unlit_image;
  shape.constants[id_shadow_map] = key.pass == Pass::shadow;
  shape.constants[id_vertex_visibility] = key.frame.vertex_visibility;
  shape.constants[id_shadow_lights] = key.frame.shadow_lights;
  shape.depth_write = prepass || (!blended && !key.after_prepass);
  shape.depth_compare = !blended && key.after_prepass ? VK_COMPARE_OP_EQUAL : VK_COMPARE_OP_GREATER_OR_EQUAL;
  shape.blend = blended;
  shape.blending = weighted ? Blending::weighted : blending_of(key.through);
  shape.colors = (weighted ? 2 : 1) + (key.frame.unlit_image ? 1 : 0);
  shape.adds_second = key.surface.material.unlit || key.frame.gooch || is_frosted(key.through);
  return pipeline = make_pipeline(device_, layouts_.pipeline(), shape);
}

namespace {

void shape_ground(const ScreenPipelineKey& key, PipelineShape& shape) {
  const bool prepass = key.pass == Pass::normal_depth;
  shape.vertex = Shader::ground_vert;
  shape.fragment = prepass ? Shader::ground_normal_frag : Shader::ground_frag;
  shape.color_format = prepass ? kNormalFormat : kColorFormat;
  shape.samples = !prepass && !key.behind && key.frame.smooth_edges ? kSmoothSamples : 1;
  shape.depth = !key.behind;  // whatever the picture covers is above the ground
  shape.depth_write = prepass;
  shape.depth_compare = VK_COMPARE_OP_GREATER_OR_EQUAL;
  shape.blend = !prepass;
  if (key.behind) shape.blending = Blending::uncovered;
  shape.colors = !prepass && key.frame.unlit_image ? 2 : 1;
  shape.adds_second = true;
  shape.constants[0] = key.grid;
  shape.constants[id_light_count] = key.frame.light_count;
  shape.constants[id_ambient] = key.frame.ambient;
  shape.constants[id_shadow_lights] = key.frame.shadow_lights;
}

void shape_outline(const ScreenPipelineKey& key, PipelineShape& shape) {
  shape.fragment = Shader::outline_frag;
  shape.color_format = kColorFormat;
  shape.samples = key.frame.smooth_edges ? kSmoothSamples : 1;
  shape.depth = true;
  // The triangle has depth 0 (infinity), so LESS passes only where surfaces are.
  shape.depth_compare = VK_COMPARE_OP_LESS;
  shape.blend = shape.adds_second = true;
  shape.colors = 2;
}

}  // namespace

VkPipeline PassPipelines::screen(const ScreenPipelineKey& key) {
  VkPipeline& pipeline = screen_[key];
  if (pipeline) return pipeline;
  PipelineShape shape;
  shape.color_format = target_format_;
  shape.constants[0] = encodes();                             // kEncode
  shape.constants[1] = static_cast<std::uint32_t>(key.show);  // kShow
  shape.constants[id_occluded] = key.frame.occluded;
  shape.constants[id_bent] = key.frame.bent;
  shape.constants[id_ao_step] = occlusion_.step;
  shape.constants[id_parallel] = key.frame.parallel;
  shape.constants[id_tone_curve] = static_cast<std::uint32_t>(key.frame.tone_curve);
  shape.constants[id_backdrop] = static_cast<std::uint32_t>(key.frame.backdrop);
  shape.constants[id_auto_exposure] = key.frame.auto_exposure;
  shape.constants[id_unlit_image] = key.frame.unlit_image;
  shape.constants[id_weighted] = key.frame.weighted;
  shape.constants[id_vertex_visibility] = key.frame.vertex_visibility;
  shape.constants[id_transparent_background] = key.frame.transparent_background;
  constexpr std::array<VkVertexInputBindingDescription, 1> line_bindings = {{{0, 32, VK_VERTEX_INPUT_RATE_INSTANCE}}};
  constexpr std::array<VkVertexInputAttributeDescription, 3> line_attributes = {
      {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
       {1, 0, VK_FORMAT_R8G8B8A8_UNORM, 12},
       {2, 0, VK_FORMAT_R32G32B32_SFLOAT, 16}}};
  switch (key.pass) {
    case Pass::ssao:
      shape.fragment = key.occlusion == OcclusionMethod::ssao ? Shader::ssao_frag : Shader::gtao_frag;
      shape.color_format = kAoFormat;
      shape.constants[0] = key.occlusion == OcclusionMethod::ssao ? occlusion_.samples : occlusion_.slices;
      shape.constants[1] = occlusion_.steps;
      break;
    case Pass::blur_horizontal:
    case Pass::blur_vertical:
      shape.fragment = Shader::ssao_blur_frag;
      shape.color_format = kAoFormat;
      shape.constants[0] = key.pass == Pass::blur_vertical;
      shape.constants[1] = occlusion_.blur_reach;
      shape.constants[2] = occlusion_.keep_edges;
      break;
    case Pass::outline: shape_outline(key, shape); break;
    case Pass::normal_depth:
    case Pass::ground: shape_ground(key, shape); break;
    case Pass::exposure:
      shape.fragment = key.sums ? Shader::light_sums_frag : Shader::exposure_frag;
      shape.color_format = kExposureFormat;
      break;
    case Pass::backdrop:
      shape.vertex = Shader::backdrop_vert;
      shape.fragment = Shader::backdrop_frag;
      shape.constants[1] = blurs_at_corners(key.frame);  // kAtCorners
      shape.constants[id_backdrop_columns] = kBackdropColumns;
      shape.constants[id_backdrop_rows] = kBackdropRows;
      break;
    case Pass::show: shape.fragment = Shader::show_frag; break;
    case Pass::overlay:
      shape.vertex = Shader::line_vert;
      shape.fragment = Shader::line_frag;
      shape.bindings = line_bindings;
      shape.attributes = line_attributes;
      shape.blend = true;
      shape.blending = Blending::straight;
      break;
    default: shape.fragment = Shader::tonemap_frag; break;
  }
  return pipeline = make_pipeline(device_, layouts_.pipeline(), shape);
}

}  // namespace sinew::viewer
