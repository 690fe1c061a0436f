// SPDX-License-Identifier: MIT
#include "importer/read/textures.h"

#include <optional>
#include <string>

#include "importer/file/json_pointer.h"
#include "importer/read/extension_fields.h"

namespace sinew {
namespace {

// Filter modes: glTF uses OpenGL's numbers.
constexpr int kNearest = 9728, kLinear = 9729;
constexpr int kNearestMipmapNearest = 9984, kLinearMipmapNearest = 9985, kNearestMipmapLinear = 9986,
              kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;
constexpr int kAbsent = -1;

std::optional<Wrap> wrap_of(int number) {
  switch (number) {
    case kRepeat: return Wrap::repeat;
    case kClampToEdge: return Wrap::clamp_to_edge;
    case kMirroredRepeat: return Wrap::mirrored_repeat;
    default: return std::nullopt;
  }
}

bool set_magnify(Sampler& sampler, int number) {
  sampler.magnify = number == kNearest ? Filter::nearest : Filter::linear;
  return number == kNearest || number == kLinear || number == kAbsent;
}

bool set_minify(Sampler& sampler, int number) {
  const auto set = [&](Filter minify, Filter mipmap, bool use_mipmaps) {
    sampler.minify = minify;
    sampler.mipmap = mipmap;
    sampler.use_mipmaps = use_mipmaps;
    return true;
  };
  switch (number) {
    case kNearest: return set(Filter::nearest, Filter::nearest, false);
    case kLinear: return set(Filter::linear, Filter::nearest, false);
    case kNearestMipmapNearest: return set(Filter::nearest, Filter::nearest, true);
    case kLinearMipmapNearest: return set(Filter::linear, Filter::nearest, true);
    case kNearestMipmapLinear: return set(Filter::nearest, Filter::linear, true);
    case kLinearMipmapLinear: return set(Filter::linear, Filter::linear, true);
    default: return number == kAbsent;
  }
}

Sampler read_sampler(const gltf::Document& document, std::uint32_t index, IssueLog& log) {
  Sampler sampler;
  if (index == kNone) return sampler;
  const tinygltf::Sampler& source = document.samplers[index];
  const auto complain = [&](const char* field, int number) {
    log.report(Rule::sampler_values, pointer("samplers", index, field),
               std::to_string(number) + "; the default is used");
  };
  if (!set_magnify(sampler, source.magFilter)) complain("magFilter", source.magFilter);
  if (!set_minify(sampler, source.minFilter)) complain("minFilter", source.minFilter);
  const auto wrap_u = wrap_of(source.wrapS), wrap_v = wrap_of(source.wrapT);
  if (!wrap_u) complain("wrapS", source.wrapS);
  if (!wrap_v) complain("wrapT", source.wrapT);
  sampler.wrap_u = wrap_u.value_or(Wrap::repeat);
  sampler.wrap_v = wrap_v.value_or(Wrap::repeat);
  return sampler;
}

/// The image of a texture. An image of an extension that the importer can decode is preferred over `source`, and
/// `source` over one that it cannot decode.
std::uint32_t image_of(const gltf::Document& document, std::uint32_t index, IssueLog& log) {
  constexpr struct {
    const char* name;
    bool decoded;
  } kExtensions[] = {{"EXT_texture_webp", true},
                     {"EXT_texture_avif", true},
                     {"KHR_texture_basisu", true},
                     {"MSFT_texture_dds", false}};
  const gltf::Texture& source = document.textures[index];
  std::uint32_t last_resort = kNone;
  for (const auto& [name, decoded] : kExtensions) {
    const ExtensionFields extension(source.extensions, pointer("textures", index), name, log);
    const std::uint32_t image = extension.index("source", document.images.size());
    if (image == kNone) continue;
    if (decoded) return image;
    if (last_resort == kNone) last_resort = image;
  }
  return source.source != gltf::kAbsent ? static_cast<std::uint32_t>(source.source) : last_resort;
}

}  // namespace

std::vector<Texture> read_textures(const gltf::Document& document, IssueLog& log) {
  std::vector<Texture> textures;
  textures.reserve(document.textures.size());
  for (std::uint32_t t = 0; t < document.textures.size(); ++t)
    textures.push_back({image_of(document, t, log), read_sampler(document, document.textures[t].sampler, log)});
  return textures;
}

TextureUse read_texture_use(gltf::TextureInfo info, const std::string& place, IssueLog& log) {
  TextureUse use;
  use.texture = info.index;
  use.texcoord = info.texcoord;
  const gltf::Json none;
  const ExtensionFields transform(info.extensions != nullptr ? *info.extensions : none, place, "KHR_texture_transform",
                                  log);
  transform.numbers("offset", &use.offset.x, 2);
  use.rotation_rad = static_cast<float>(transform.number("rotation", 0.0));
  transform.numbers("scale", &use.scale.x, 2);
  if (const std::uint32_t own = transform.index("texCoord", kNone); own != kNone) use.texcoord = own;
  return use;
}

TextureUse read_texture_use(const ExtensionFields& extension, const char* name, std::size_t texture_count) {
  const ExtensionFields field = extension.object(name);
  gltf::TextureInfo info;
  info.index = field.index("index", texture_count);
  if (const std::uint32_t set = field.index("texCoord", kNone); set != kNone) info.texcoord = set;
  const gltf::Json extensions = field.extensions();
  info.extensions = &extensions;
  return read_texture_use(info, field.place(), field.log());
}

}  // namespace sinew
