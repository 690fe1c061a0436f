// SPDX-License-Identifier: MIT
#include "importer/file/check_declarations.h"

#include <set>
#include <string>
#include <string_view>

#include "importer/file/data_uri.h"
#include "importer/file/json_place.h"

namespace sinew {
namespace {

using Names = std::set<std::string_view>;

/// A list at the root; null if it does not exist.
const JsonNode* list_of(const JsonNode& json, std::string_view name) {
  const JsonNode* list = find_member(json, name);
  return list != nullptr && list->IsArray() ? list : nullptr;
}

/// Reads a list of extension names; reports duplicates.
Names read_names(const JsonNode& json, std::string_view list_name, IssueLog& log) {
  Names names;
  const JsonNode* list = list_of(json, list_name);
  for (rapidjson::SizeType i = 0; list != nullptr && i < list->Size(); ++i)
    if (!names.insert(text_of((*list)[i])).second)
      log.report(Rule::extension_duplicate, pointer(list_name, i),
                 in_quotes(text_of((*list)[i])) + " is in the list already; ignored");
  return names;
}

/// Finds undeclared extensions and reports the first use of each.
class UseSearch {
 public:
  UseSearch(Names& known, IssueLog& log) : known_(known), log_(log) {}

  void look_at(const JsonNode& value, const JsonPlace& place) {
    if (value.IsArray()) {
      for (rapidjson::SizeType i = 0; i < value.Size(); ++i) look_at(value[i], {&place, {}, i});
    } else if (value.IsObject()) {
      for (const auto& [name, entry] : value.GetObject()) {
        const JsonPlace here{&place, text_of(name)};
        if (here.name == "extras") continue;
        if (here.name == "extensions" && entry.IsObject()) compare(entry, here);
        look_at(entry, here);
      }
    }
  }

 private:
  void compare(const JsonNode& extensions, const JsonPlace& place) {
    for (const auto& [name, value] : extensions.GetObject())
      if (known_.insert(text_of(name)).second)
        log_.report(Rule::extension_undeclared, JsonPlace{&place, text_of(name)}.text(),
                    "is not in extensionsUsed; it is read as if it were");
  }

  Names& known_;
  IssueLog& log_;
};

void check_extensions(const JsonNode& json, IssueLog& log) {
  Names used = read_names(json, "extensionsUsed", log);
  const Names required = read_names(json, "extensionsRequired", log);
  for (const std::string_view name : required)
    if (!used.contains(name))
      log.report(Rule::extension_undeclared, "/extensionsRequired",
                 in_quotes(name) + " is not in extensionsUsed; it is read as if it were");
  used.insert(required.begin(), required.end());
  UseSearch(used, log).look_at(json, {});
}

void check_accessor_offsets(const JsonNode& json, IssueLog& log) {
  const JsonNode* list = list_of(json, "accessors");
  for (rapidjson::SizeType i = 0; list != nullptr && i < list->Size(); ++i)
    if (find_member((*list)[i], "byteOffset") != nullptr && find_member((*list)[i], "bufferView") == nullptr)
      log.report(Rule::accessor_offset, pointer("accessors", i, "byteOffset"), "there is no bufferView; ignored");
}

void check_strides(const JsonNode& json, IssueLog& log) {
  constexpr double kIndices = 34963;  // ELEMENT_ARRAY_BUFFER
  const JsonNode* list = list_of(json, "bufferViews");
  for (rapidjson::SizeType i = 0; list != nullptr && i < list->Size(); ++i) {
    const JsonNode& view = (*list)[i];
    const JsonNode* stride = find_member(view, "byteStride");
    if (stride == nullptr) continue;
    const std::string place = pointer("bufferViews", i, "byteStride");
    const JsonNode* target = find_member(view, "target");
    if (target != nullptr && target->IsNumber() && target->GetDouble() == kIndices)
      log.report(Rule::buffer_view_stride, place, "the target is indices, which take no stride; used as it is");
    else if (stride->GetDouble() > find_member(view, "byteLength")->GetDouble())
      log.report(Rule::buffer_view_stride, place, "is larger than the whole view; used as it is");
  }
}

/// eq   "data:" [media type] [";base64"] "," data   (RFC 2397)
void check_data_uri(const JsonNode& entry, const std::string& place, bool image, IssueLog& log) {
  const JsonNode* value = find_member(entry, "uri");
  if (value == nullptr) return;
  const std::string_view uri = text_of(*value);
  const auto complain = [&](std::string detail) { log.report(Rule::data_uri, place + "/uri", std::move(detail)); };
  if (uri.empty()) return complain("is empty; taken as absent");
  if (!is_data_uri(uri)) return;
  const auto comma = uri.find(',');
  if (comma == uri.npos || comma + 1 == uri.size()) return complain("holds no data");
  const std::string_view media = uri.substr(5, uri.find_first_of(";,") - 5);
  const bool fits =
      image ? media.starts_with("image/") : media == "application/octet-stream" || media == "application/gltf-buffer";
  if (!fits)
    complain("has the media type " + in_quotes(media) + ", which is not that of " + (image ? "an image" : "a buffer") +
             "; read all the same");
}

void check_data_uris(const JsonNode& json, std::string_view name, bool image, IssueLog& log) {
  const JsonNode* list = list_of(json, name);
  for (rapidjson::SizeType i = 0; list != nullptr && i < list->Size(); ++i)
    check_data_uri((*list)[i], pointer(name, i), image, log);
}

}  // namespace

void check_declarations(const JsonNode& json, IssueLog& log) {
  check_extensions(json, log);
  check_accessor_offsets(json, log);
  check_strides(json, log);
  check_data_uris(json, "buffers", false, log);
  check_data_uris(json, "images", true, log);
}

}  // namespace sinew
