// SPDX-License-Identifier: MIT
#include "importer/tool/assets/asset_info.h"

#include <vector>

#include <fmt/core.h>

#include "importer/tool/assets/asset_bytes.h"
#include "importer/tool/assets/asset_parts.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/info/clip_annotations.h"
#include "importer/tool/info/memory_kinds.h"
#include "importer/tool/left_out_joints.h"
#include "importer/tool/messages.h"
#include "importer/tool/text_table.h"
#include "runtime/clip/clip_file.h"
#include "runtime/graph/graph_bytes.h"

namespace sinew::tool {
namespace {

using Info = tl::expected<AssetInfo, std::string>;

Json json_of(const Clip& clip) {
  Json out{{"name", clip.name()},
           {"duration_s", clip.duration_s()},
           {"joints", clip.joint_count()},
           {"weights", clip.weight_count()},
           {"properties", clip.property_count()},
           {"bytes", clip.byte_size()},
           {"certificate", nullptr}};
  if (const auto& c = clip.certificate())
    out["certificate"] = {{"asked_m", c->asked_m},
                          {"measured_m", c->measured_m},
                          {"weights_m", c->weights_m},
                          {"is_met", keeps_promise(*c)},
                          {"worst_joint", c->worst_joint == kNone ? Json() : Json(c->worst_joint)},
                          {"worst_time_s", c->worst_time_s},
                          {"times_checked", c->times_checked},
                          {"source_keys", c->source_keys},
                          {"kept_keys", c->kept_keys},
                          {"source_bytes", c->source_bytes},
                          {"bytes", c->bytes},
                          {"bytes_per_joint_second", c->bytes_per_joint_second(clip.duration_s())}};
  add_annotations(clip.annotations(), out);
  return out;
}

Json json_of(const std::vector<Clip>& clips) {
  Json out = Json::array();
  for (const Clip& clip : clips) out.push_back(json_of(clip));
  return out;
}

std::string annotation_lines_of(const std::vector<Clip>& clips) {
  std::string out;
  for (const Clip& clip : clips) out += annotation_lines(json_of(clip));
  return out;
}

Info info_of_clips(const std::string& file, const std::vector<std::byte>& bytes) {
  const auto clips = load_clips(bytes);
  if (!clips)
    return tl::unexpected(
        fmt::format("byte {}: {}: {}", clips.error().offset, clips.error().rule, clips.error().detail));
  return AssetInfo{
      {{"file", file}, {"version", kClipFileVersion}, {"bytes", bytes.size()}, {"compiled_clips", json_of(*clips)}},
      fmt::format("compiled clips, version {}: {} in {} bytes", kClipFileVersion, clips->size(), bytes.size()),
      certificate_table(*clips, {}) + annotation_lines_of(*clips)};
}

Json json_of(const AssetBlock& block) {
  return {{"kind", block.is_known ? Json(name_of(block.kind)) : Json(static_cast<std::uint32_t>(block.kind))},
          {"version", block.version},
          {"offset", block.offset},
          {"stored_bytes", block.stored_bytes},
          {"bytes", block.bytes},
          {"packed", block.is_packed}};
}

std::string table_of(std::span<const AssetBlock> blocks) {
  TextTable table({"block", "version", "offset", "bytes in the file", "unpacked"});
  for (const AssetBlock& block : blocks)
    table.add({block.is_known ? std::string(name_of(block.kind))
                              : fmt::format("unknown {}", static_cast<std::uint32_t>(block.kind)),
               std::to_string(block.version), std::to_string(block.offset), std::to_string(block.stored_bytes),
               block.is_packed ? std::to_string(block.bytes) : ""});
  return table.text();
}

Json json_of_model(const Scene& scene) {
  std::size_t primitives = 0, vertices = 0, targets = 0;
  for (const Mesh& mesh : scene.meshes) {
    primitives += mesh.primitives.size();
    targets += mesh.target_count();
    for (const Primitive& primitive : mesh.primitives) vertices += primitive.vertex_count();
  }
  return {{"joints", scene.skeleton.joint_count()},
          {"meshes", scene.meshes.size()},
          {"primitives", primitives},
          {"vertices", vertices},
          {"morph_targets", targets},
          {"skins", scene.skins.size()},
          {"instances", scene.instances.size()},
          {"materials", scene.materials.size()},
          {"images", scene.images.size()},
          {"animations", scene.animations.size()}};
}

Json json_of(const std::vector<CompiledSkeletonLod>& lods) {
  Json out = Json::array();
  for (const CompiledSkeletonLod& lod : lods)
    out.push_back({{"tolerance_m", lod.tolerance_m}, {"measured_m", lod.measured_m}, {"left_out", lod.left_out}});
  return out;
}

/// The needs of a stored graph, or its fault if it cannot be read.
Json json_of(const StoredGraph& stored) {
  Json out = {{"name", stored.name}, {"bytes", stored.bytes.size()}};
  auto tables = read_graph_bytes(stored.bytes);
  if (!tables) {
    out["fault"] = std::string(describe(tables.error()));
    return out;
  }
  const auto graph = GraphDefinition::make(*std::move(tables));
  if (!graph) {
    out["fault"] = graph.error().rule;
    return out;
  }
  out["nodes"] = graph->tables().nodes.size();
  out["clips"] = graph->tables().clip_names.size();
  out["state_bytes"] = graph->state_bytes();
  out["most_operations"] = graph->room().ops;
  out["most_poses"] = graph->room().slots;
  return out;
}

Json json_of(const std::vector<StoredGraph>& graphs) {
  Json out = Json::array();
  for (const StoredGraph& graph : graphs) out.push_back(json_of(graph));
  return out;
}

std::string lines_of(const std::vector<StoredGraph>& graphs) {
  std::string out;
  for (const StoredGraph& graph : graphs) {
    const Json json = json_of(graph);
    out += json.contains("fault")
               ? fmt::format("  graph {}: {}\n", in_quotes(graph.name), json["fault"].get<std::string>())
               : fmt::format("  graph {}: {}, {}, programs of at most {}, {} bytes of state a character\n",
                             in_quotes(graph.name), counted(json["nodes"].get<std::size_t>(), "node"),
                             counted(json["clips"].get<std::size_t>(), "clip"),
                             counted(json["most_operations"].get<std::size_t>(), "operation"),
                             json["state_bytes"].get<std::size_t>());
  }
  return out;
}

/// "joints 3, meshes 2, ..."
std::string line_of(const Json& counts) {
  std::string out;
  for (const auto& [what, count] : counts.items())
    out += fmt::format("{}{} {}", out.empty() ? "  " : ", ", what, count.get<std::size_t>());
  return out + "\n";
}

Info info_of_assets(const std::string& name, const std::vector<std::byte>& bytes) {
  const auto parts = asset_parts(bytes);
  if (!parts) return tl::unexpected(describe(parts.error()));
  const auto of_table = parts->file.blocks();
  const std::string skeleton = of_table.empty() ? "none" : fmt::format("{:016x}", of_table.front().skeleton_signature);
  Json blocks = Json::array();
  for (const AssetBlock& block : of_table) blocks.push_back(json_of(block));
  AssetInfo out{
      {{"file", name},
       {"asset_file", {{"version", kAssetFileVersion}, {"skeleton_signature", skeleton}, {"blocks", blocks}}},
       {"bytes", bytes.size()}},
      fmt::format("asset file, version {}: {}, {}, {} bytes, skeleton {}", kAssetFileVersion,
                  counted(of_table.size(), "block"), counted(parts->clips.size(), "clip"), bytes.size(), skeleton),
      table_of(of_table)};
  if (parts->scene) {
    out.json["model"] = json_of_model(*parts->scene);
    out.tables += line_of(out.json["model"]);
  }
  if (!parts->lods.empty()) {
    out.json["skeleton_lods"] = json_of(parts->lods);
    out.tables += lod_lines(parts->lods, parts->scene->skeleton.joint_count());
  }
  if (!parts->graphs.empty()) {
    out.json["graphs"] = json_of(parts->graphs);
    out.tables += lines_of(parts->graphs);
  }
  MemoryCount memory;
  if (parts->scene) memory.add(*parts->scene);
  for (const Clip& clip : parts->clips) memory.add(clip);
  out.json["memory"] = memory_json(memory.bytes());
  out.tables += "  " + memory_text(out.json["memory"]);
  out.json["compiled_clips"] = json_of(parts->clips);
  out.tables +=
      certificate_table(parts->clips, parts->scene ? parts->scene->skeleton.names : std::vector<std::string>()) +
      annotation_lines_of(parts->clips);
  return out;
}

}  // namespace

std::optional<Info> asset_info(const std::string& file) {
  const auto bytes = asset_bytes(file);
  if (!bytes) return std::nullopt;
  return looks_like_asset_file(*bytes) ? info_of_assets(file, *bytes) : info_of_clips(file, *bytes);
}

}  // namespace sinew::tool
