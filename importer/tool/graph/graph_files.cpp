// SPDX-License-Identifier: MIT
#include "importer/tool/graph/graph_files.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/core.h>

#include "importer/graph/json_path.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/messages.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

constexpr std::uintmax_t kMostBytes = 16u << 20;

std::string fault_text(const std::string& file, const GraphTextFault& fault) {
  return fault.json_pointer.empty() ? fmt::format("{}: {}", file, fault.sentence)
                                    : fmt::format("{}: {}: {}", file, fault.json_pointer, fault.sentence);
}

GraphTextFault clip_fault(const GraphDocument& document, const std::string& clip, const Scene& scene) {
  const JsonPath root, nodes(&root, "nodes");
  for (const auto& [name, node] : document.nodes)
    if (node.kind == GraphNodeKind::clip && node.clip == clip) {
      const JsonPath here(&nodes, name);
      return {JsonPath(&here, "clip").text(), "the model has no clip " + in_quotes(clip) + "; " + list_of_clips(scene)};
    }
  return {};
}

}  // namespace

tl::expected<GraphOfModel, std::string> load_graph(const std::string& file, const Scene& scene) {
  const auto refused = [&](const GraphTextFault& fault) { return tl::unexpected(fault_text(file, fault)); };
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return refused({"", "is no file"});
  if (std::filesystem::file_size(file, error) > kMostBytes) return refused({"", "is larger than 16 MB"});
  std::ifstream stream{std::filesystem::path(file), std::ios::binary};
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  auto document = read_graph(text);
  if (!document) return refused(document.error());
  auto graph = compile_graph(*document);
  if (!graph) return refused(graph.error());

  GraphOfModel loaded{std::move(*document), std::move(*graph), {}};
  const GraphTables& tables = loaded.graph.tables();
  for (const std::uint32_t offset : tables.clip_names) {
    const std::string name(tables.name_at(offset));
    const auto chosen = choose_clips(scene, name);
    if (!chosen || chosen->size() != 1 || chosen->front() == kNone)
      return refused(clip_fault(loaded.document, name, scene));
    loaded.clips.push_back({chosen->front(), scene.animations[chosen->front()].duration_s});
  }
  const JsonPath root, masks(&root, "masks");
  for (const auto& [name, joints] : loaded.document.masks) {
    const JsonPath mask(&masks, name);
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (!scene.skeleton.find(joints[j]))
        return refused({JsonPath(&mask, std::to_string(j)).text(), "the model has no joint " + in_quotes(joints[j])});
  }
  return loaded;
}

}  // namespace sinew::tool
