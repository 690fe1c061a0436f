// SPDX-License-Identifier: MIT
#include "importer/read/variants.h"

#include <algorithm>

#include "importer/file/json_pointer.h"
#include "importer/read/json_member.h"

namespace sinew {
namespace {

using gltf::Json;

constexpr const char* kVariants = "KHR_materials_variants";

/// The array `name` of the extension; null if absent.
/// in   place  of the extension
const Json* list_in(const Json& extensions, const char* name, const std::string& place, IssueLog& log) {
  const Json* extension = member(&extensions, kVariants);
  if (extension == nullptr) return nullptr;
  if (const Json* list = member(extension, name); list != nullptr && list->is_array()) return list;
  log.report(Rule::extension_value, place, "has no array " + in_quotes(name) + "; ignored");
  return nullptr;
}

}  // namespace

std::vector<std::string> read_variants(const gltf::Document& document, IssueLog& log) {
  std::vector<std::string> names;
  const Json* list = list_in(document.extensions, "variants", pointer("extensions", kVariants), log);
  if (list == nullptr) return names;
  for (const Json& variant : *list) {
    const Json* name = member(&variant, "name");
    names.push_back(name != nullptr && name->is_string() ? name->get<std::string>() : "");
  }
  return names;
}

std::vector<VariantMaterial> read_variant_materials(const gltf::Document& document, std::uint32_t mesh,
                                                    std::uint32_t primitive, IssueLog& log) {
  std::vector<VariantMaterial> out;
  const std::string place = pointer("meshes", mesh, "primitives", primitive, "extensions", kVariants);
  const Json* list = list_in(document.meshes[mesh].primitives[primitive].extensions, "mappings", place, log);
  if (list == nullptr) return out;
  IssueLog discarded_log;  // read_variants reports the issues of the names
  const Json* variants = list_in(document.extensions, "variants", "", discarded_log);
  const std::size_t variant_count = variants == nullptr ? 0 : variants->size();
  for (std::size_t m = 0; m < list->size(); ++m) {
    const Json& mapping = (*list)[m];
    const Json* mapped = member(&mapping, "variants");
    const std::uint32_t material = index_below(member(&mapping, "material"), document.materials.size());
    bool good = material != kNone && mapped != nullptr && mapped->is_array();
    if (good)
      for (const Json& variant : *mapped) {
        const std::uint32_t index = index_below(&variant, variant_count);
        if (index != kNone) out.push_back({index, material});
        good = good && index != kNone;
      }
    if (!good)
      log.report(Rule::extension_value, pointer(place, "mappings", m), "names no variant or no material; ignored");
  }
  const auto earlier = [](const VariantMaterial& a, const VariantMaterial& b) { return a.variant < b.variant; };
  const auto same = [](const VariantMaterial& a, const VariantMaterial& b) { return a.variant == b.variant; };
  std::stable_sort(out.begin(), out.end(), earlier);
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
  return out;
}

}  // namespace sinew
