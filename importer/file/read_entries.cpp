// SPDX-License-Identifier: MIT
#include "importer/file/read_entries.h"

#include <map>
#include <string>

#include "importer/file/json_fields.h"

namespace sinew {
namespace {

/// Attribute names and the accessors that hold them.
std::map<std::string, int> read_attributes(const JsonNode& json) {
  std::map<std::string, int> out;
  for (const auto& [name, accessor] : json.GetObject())
    out.insert_or_assign(std::string(text_of(name)), static_cast<int>(accessor.GetDouble()));
  return out;
}

gltf::Primitive read_primitive(const JsonNode& json) {
  const JsonFields in(json);
  gltf::Primitive out;
  out.attributes = read_attributes(*in.find("attributes"));
  out.material = in.signed_index("material");
  out.indices = in.signed_index("indices");
  out.mode = in.signed_index("mode", out.mode);
  out.targets = in.list("targets", read_attributes);
  out.extensions = in.part("extensions");
  return out;
}

std::vector<std::string> target_names(const JsonFields& mesh) {
  const JsonNode* extras = mesh.find("extras");
  if (extras == nullptr || !extras->IsObject()) return {};
  const JsonFields in(*extras);
  const JsonNode* names = in.find("targetNames");
  return names != nullptr && names->IsArray() ? in.texts("targetNames") : std::vector<std::string>();
}

/// Reads what the three types of texture references have in common; `extensions` receives theirs.
template <class Texture>
JsonFields read_texture_info(const JsonNode& json, Texture& out, gltf::Json& extensions) {
  const JsonFields in(json);
  out.index = in.signed_index("index");
  out.texCoord = in.signed_index("texCoord", 0);
  extensions = in.part("extensions");
  return in;
}

void read_surface(const JsonNode& json, gltf::Material& out) {
  const JsonFields in(json);
  auto& surface = out.pbrMetallicRoughness;
  if (in.find("baseColorFactor") != nullptr) surface.baseColorFactor = in.numbers("baseColorFactor");
  surface.metallicFactor = in.number("metallicFactor", surface.metallicFactor);
  surface.roughnessFactor = in.number("roughnessFactor", surface.roughnessFactor);
  if (const JsonNode* info = in.find("baseColorTexture"))
    read_texture_info(*info, surface.baseColorTexture, out.extensions_of(TextureSlot::base_color));
  if (const JsonNode* info = in.find("metallicRoughnessTexture"))
    read_texture_info(*info, surface.metallicRoughnessTexture, out.extensions_of(TextureSlot::metallic_roughness));
}

}  // namespace

tinygltf::Asset read_asset(const JsonNode& json) {
  const JsonFields in(json);
  tinygltf::Asset out;
  out.version = in.text("version");
  out.minVersion = in.text("minVersion");
  out.generator = in.text("generator");
  out.copyright = in.text("copyright");
  return out;
}

gltf::Mesh read_mesh(const JsonNode& json) {
  const JsonFields in(json);
  gltf::Mesh out;
  out.name = in.text("name");
  out.weights = in.numbers("weights");
  out.primitives = in.list("primitives", read_primitive);
  out.target_names = target_names(in);
  return out;
}

gltf::Node read_node(const JsonNode& json) {
  const JsonFields in(json);
  gltf::Node out;
  out.name = in.text("name");
  out.camera = in.signed_index("camera");
  out.mesh = in.signed_index("mesh");
  out.skin = in.signed_index("skin");
  out.children = in.signed_indices("children");
  out.weights = in.numbers("weights");
  out.matrix = in.numbers("matrix");
  out.has_trs = in.find("translation") != nullptr || in.find("rotation") != nullptr || in.find("scale") != nullptr;
  if (out.matrix.empty()) {
    out.translation = in.numbers("translation");
    out.rotation = in.numbers("rotation");
    out.scale = in.numbers("scale");
  }
  out.extensions = in.part("extensions");
  return out;
}

tinygltf::Skin read_skin(const JsonNode& json) {
  const JsonFields in(json);
  tinygltf::Skin out;
  out.name = in.text("name");
  out.inverseBindMatrices = in.signed_index("inverseBindMatrices");
  out.skeleton = in.signed_index("skeleton");
  out.joints = in.signed_indices("joints");
  return out;
}

gltf::Material read_material(const JsonNode& json) {
  const JsonFields in(json);
  gltf::Material out;
  out.name = in.text("name");
  out.emissiveFactor = in.find("emissiveFactor") != nullptr ? in.numbers("emissiveFactor") : std::vector<double>(3);
  out.alphaMode = in.text("alphaMode", "OPAQUE");
  out.alphaCutoff = in.number("alphaCutoff", out.alphaCutoff);
  out.doubleSided = in.flag("doubleSided");
  if (const JsonNode* surface = in.find("pbrMetallicRoughness")) read_surface(*surface, out);
  if (const JsonNode* info = in.find("normalTexture"))
    out.normalTexture.scale =
        read_texture_info(*info, out.normalTexture, out.extensions_of(TextureSlot::normal)).number("scale", 1.0);
  if (const JsonNode* info = in.find("occlusionTexture"))
    out.occlusionTexture.strength =
        read_texture_info(*info, out.occlusionTexture, out.extensions_of(TextureSlot::occlusion))
            .number("strength", 1.0);
  if (const JsonNode* info = in.find("emissiveTexture"))
    read_texture_info(*info, out.emissiveTexture, out.extensions_of(TextureSlot::emissive));
  out.extensions = in.part("extensions");
  return out;
}

gltf::Texture read_texture(const JsonNode& json) {
  const JsonFields in(json);
  gltf::Texture out;
  out.name = in.text("name");
  out.source = in.signed_index("source");
  out.sampler = in.signed_index("sampler");
  out.extensions = in.part("extensions");
  return out;
}

tinygltf::Sampler read_texture_sampler(const JsonNode& json) {
  const JsonFields in(json);
  tinygltf::Sampler out;
  out.minFilter = in.signed_index("minFilter");
  out.magFilter = in.signed_index("magFilter");
  out.wrapS = in.signed_index("wrapS", out.wrapS);
  out.wrapT = in.signed_index("wrapT", out.wrapT);
  return out;
}

/// A camera without a lens object has zeros, which also means "no values".
tinygltf::Camera read_camera(const JsonNode& json) {
  const JsonFields in(json);
  tinygltf::Camera out;
  out.name = in.text("name");
  out.type = in.text("type");
  const JsonNode* lens_json = in.find(out.type);
  if (lens_json == nullptr) return out;
  const JsonFields lens(*lens_json);
  if (out.type == "perspective") {
    out.perspective.aspectRatio = lens.number("aspectRatio", 0.0);
    out.perspective.yfov = lens.number("yfov", 0.0);
    out.perspective.zfar = lens.number("zfar", 0.0);
    out.perspective.znear = lens.number("znear", 0.0);
  } else {
    out.orthographic.xmag = lens.number("xmag", 0.0);
    out.orthographic.ymag = lens.number("ymag", 0.0);
    out.orthographic.zfar = lens.number("zfar", 0.0);
    out.orthographic.znear = lens.number("znear", 0.0);
  }
  return out;
}

tinygltf::Scene read_scene(const JsonNode& json) {
  const JsonFields in(json);
  tinygltf::Scene out;
  out.name = in.text("name");
  out.nodes = in.signed_indices("nodes");
  return out;
}

}  // namespace sinew
