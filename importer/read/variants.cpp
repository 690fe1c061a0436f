// SPDX-License-Identifier: MIT
#include "importer/read/variants.h"

#include <algorithm>

#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

using gltf::Json;

constexpr const char* kExtension = "KHR_materials_variants";

/// The array `name` of the extension; null where there is none.
const Json* list_in(const Json& extensions, const char* name, const std::string& place, IssueLog& log) {
  if (!extensions.is_object()) return nullptr;
  const auto extension = extensions.find(kExtension);
  if (extension == extensions.end()) return nullptr;
  if (extension->is_object())
    if (const auto list = extension->find(name); list != extension->end() && list->is_array()) return &*list;
  log.report(Rule::extension_value, pointer(place, "extensions", kExtension),
             "has no array " + in_quotes(name) + "; ignored");
  return nullptr;
}

std::uint32_t index_below(const Json& value, std::size_t limit) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() < limit ? value.get<std::uint32_t>() : kNone;
}

}  // namespace

std::vector<std::string> read_variants(const gltf::Document& document, IssueLog& log) {
  std::vector<std::string> names;
  const Json* list = list_in(document.extensions, "variants", "", log);
  if (list == nullptr) return names;
  for (const Json& variant : *list) {
    const bool named = variant.is_object() && variant.contains("name") && variant["name"].is_string();
    names.push_back(named ? variant["name"].get<std::string>() : "");
  }
  return names;
}

std::vector<VariantMaterial> read_variant_materials(const gltf::Document& document, std::uint32_t mesh,
                                                    std::uint32_t primitive, IssueLog& log) {
  std::vector<VariantMaterial> out;
  const std::string place = pointer("meshes", mesh, "primitives", primitive);
  const Json* list = list_in(document.meshes[mesh].primitives[primitive].extensions, "mappings", place, log);
  if (list == nullptr) return out;
  IssueLog unheard;  // read_variants says what is odd about the names
  const Json* variants = list_in(document.extensions, "variants", "", unheard);
  const std::size_t variant_count = variants == nullptr ? 0 : variants->size();
  for (std::size_t m = 0; m < list->size(); ++m) {
    const Json& mapping = (*list)[m];
    const bool whole = mapping.is_object() && mapping.contains("material") && mapping.contains("variants") &&
                       mapping["variants"].is_array();
    const std::uint32_t material = whole ? index_below(mapping["material"], document.materials.size()) : kNone;
    bool good = material != kNone;
    if (good)
      for (const Json& variant : mapping["variants"]) {
        const std::uint32_t index = index_below(variant, variant_count);
        if (index != kNone) out.push_back({index, material});
        good = good && index != kNone;
      }
    if (!good)
      log.report(Rule::extension_value, pointer(place, "extensions", kExtension, "mappings", m),
                 "names no variant or no material; ignored");
  }
  const auto earlier = [](const VariantMaterial& a, const VariantMaterial& b) { return a.variant < b.variant; };
  const auto same = [](const VariantMaterial& a, const VariantMaterial& b) { return a.variant == b.variant; };
  std::stable_sort(out.begin(), out.end(), earlier);
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
  return out;
}

}  // namespace sinew
