// SPDX-License-Identifier: MIT
#include "importer/file/check_unused_objects.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

using gltf::Document;

/// Prefixes of extensions whose member names identify the lists that they refer to.
constexpr std::string_view kTellingPrefixes[] = {"KHR_materials_",
                                                 "EXT_materials_",
                                                 "KHR_texture_",
                                                 "EXT_texture_",
                                                 "KHR_lights_",
                                                 "KHR_node_",
                                                 "KHR_draco_",
                                                 "KHR_mesh_",
                                                 "KHR_meshopt_",
                                                 "EXT_meshopt_",
                                                 "MSFT_texture_",
                                                 "KHR_xmp",
                                                 "KHR_animation_pointer",
                                                 "EXT_mesh_gpu_instancing"};

bool has_telling_names(std::string_view extension) {
  return std::any_of(std::begin(kTellingPrefixes), std::end(kTellingPrefixes),
                     [&](std::string_view prefix) { return extension.starts_with(prefix); });
}

/// Stand-in address for the list of lights, which the document does not have.
const void* list_of_lights(const Document& document) { return &document.extensions; }

/// Marks entries that extensions refer to.
class ExtensionReferences {
 public:
  ExtensionReferences(const Document& d, ReferencedEntries& referenced) : referenced_(referenced) {
    lists_ = {{"accessor", &d.accessors},   {"bufferView", &d.buffer_views},
              {"buffer", &d.buffers},       {"camera", &d.cameras},
              {"image", &d.images},         {"source", &d.images},
              {"light", list_of_lights(d)}, {"material", &d.materials},
              {"mesh", &d.meshes},          {"sampler", &d.samplers},
              {"skin", &d.skins},           {"texture", &d.textures},
              {"index", &d.textures},       {"attributes", &d.accessors}};
  }

  /// Searches the whole document for extensions; skips extras.
  void search(const JsonNode& value) {
    if (value.IsArray())
      for (const JsonNode& entry : value.GetArray()) search(entry);
    if (!value.IsObject()) return;
    for (const auto& [name, entry] : value.GetObject()) {
      if (text_of(name) == "extras") continue;
      if (text_of(name) == "extensions" && entry.IsObject())
        for (const auto& [extension, content] : entry.GetObject())
          mark(content, "", has_telling_names(text_of(extension)));
      search(entry);
    }
  }

 private:
  /// in   name   name of the member, or of the nearest ancestor that identifies a list
  void mark(const JsonNode& value, std::string_view name, bool telling) {
    if (value.IsUint()) return mark_index(value.GetUint(), name, telling);
    if (value.IsArray())
      for (const JsonNode& entry : value.GetArray()) mark(entry, name, telling);
    if (!value.IsObject()) return;
    for (const auto& [member, entry] : value.GetObject()) {
      const std::string_view own = text_of(member);
      if (own != "extras" && own != "extensions") mark(entry, name == "attributes" ? name : own, telling);
    }
  }

  void mark_index(unsigned index, std::string_view name, bool telling) {
    const auto list = lists_.find(name);
    if (list != lists_.end()) referenced_.mark(list->second, std::min(index, kMost));
    if (telling) return;
    for (const auto& [any, every_list] : lists_) referenced_.mark(every_list, std::min(index, kMost));
  }

  static constexpr unsigned kMost = 1u << 20;  // larger numbers cannot be indices: no list is that long

  ReferencedEntries& referenced_;
  std::map<std::string_view, const void*> lists_;
};

/// Reports the roots of node trees that no scene contains.
void report_nodes(const Document& document, IssueLog& log) {
  if (document.scenes.empty()) return;
  std::vector<bool> shown(document.nodes.size(), false), has_parent(document.nodes.size(), false);
  std::vector<std::uint32_t> open;
  for (const tinygltf::Scene& scene : document.scenes) open.insert(open.end(), scene.nodes.begin(), scene.nodes.end());
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    open.pop_back();
    if (shown[node]) continue;
    shown[node] = true;
    open.insert(open.end(), document.nodes[node].children.begin(), document.nodes[node].children.end());
  }
  for (const gltf::Node& node : document.nodes)
    for (const std::uint32_t child : node.children) has_parent[child] = true;
  for (std::size_t n = 0; n < shown.size(); ++n)
    if (!shown[n] && !has_parent[n])
      log.report(Rule::node_outside_scenes, pointer("nodes", n), "no scene shows it, nor what is below it");
}

}  // namespace

void check_unused_objects(const JsonNode& json, const Document& document, ReferencedEntries referenced, IssueLog& log) {
  ExtensionReferences(document, referenced).search(json);
  const auto report = [&](const char* place, const void* list, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      if (!referenced.holds(list, i)) log.report(Rule::unused_object, pointer(place, i), "nothing refers to it");
  };
  const auto report_list = [&](const char* place, const auto& list) { report(place, &list, list.size()); };
  report_list("accessors", document.accessors);
  report_list("bufferViews", document.buffer_views);
  report_list("buffers", document.buffers);
  report_list("cameras", document.cameras);
  report_list("images", document.images);
  report_list("materials", document.materials);
  report_list("meshes", document.meshes);
  report_list("samplers", document.samplers);
  report_list("skins", document.skins);
  report_list("textures", document.textures);
  const gltf::Json::json_pointer lights("/KHR_lights_punctual/lights");
  if (document.extensions.contains(lights) && document.extensions[lights].is_array())
    report("extensions/KHR_lights_punctual/lights", list_of_lights(document), document.extensions[lights].size());
  report_nodes(document, log);
}

}  // namespace sinew
