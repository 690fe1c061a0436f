// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <utility>

#include "importer/graph/graph_beats.h"
#include "importer/graph/graph_files.h"
#include "importer/graph/json_path.h"
#include "runtime/graph/graph_masks.h"
#include "runtime/model/numbered_name.h"

namespace sinew {
namespace {

std::string quoted(const std::string& name) { return '"' + name + '"'; }

std::string clips_of(const Scene& scene) {
  if (scene.animations.empty()) return "it has none";
  constexpr std::size_t kShown = 12;
  std::string list = "it has";
  for (std::size_t i = 0; i < scene.animations.size() && i < kShown; ++i)
    list += (i > 0 ? ", " : " ") + quoted(scene.animations[i].name);
  return scene.animations.size() > kShown ? list + ", ..." : list;
}

std::optional<std::uint32_t> find_numbered_clip(const Scene& scene, const std::string& name) {
  if (const auto clip = find_clip(scene, name)) return clip;
  const auto numbered = parse_numbered_name(name);
  if (!numbered) return std::nullopt;
  std::uint32_t number = numbered->number;
  for (std::uint32_t i = 0; i < scene.animations.size(); ++i)
    if (scene.animations[i].name == numbered->name && --number == 0) return i;
  return std::nullopt;
}

/// The places of a document that name a clip: the first node that plays it, or its entry in a variation.
std::string place_of_clip(const GraphDocument& document, const std::string& variation, const std::string& clip) {
  const JsonPath root;
  if (const auto found = document.variations.find(variation);
      found != document.variations.end() && found->second.contains(clip)) {
    const JsonPath all(&root, "variations"), one(&all, variation);
    return JsonPath(&one, clip).text();
  }
  const JsonPath nodes(&root, "nodes");
  for (const auto& [name, node] : document.nodes)
    if (node.kind == GraphDocument::NodeKind::clip && node.clip == clip) {
      const JsonPath here(&nodes, name);
      return JsonPath(&here, "clip").text();
    }
  return nodes.text();
}

GraphTextFault joint_fault(const std::string& mask, std::size_t entry, const std::string& joint) {
  const JsonPath root, masks(&root, "masks"), here(&masks, mask);
  return {JsonPath(&here, std::to_string(entry)).text(), "the model has no joint " + quoted(joint)};
}

/// Checks the names of the document that compile_graph does not: joints, and clips of variations.
std::optional<GraphTextFault> find_name_fault(const GraphDocument& document, const Scene& scene) {
  const JsonPath root, beats(&root, "beats"), variations(&root, "variations");
  for (const auto& [name, beat] : document.beats)
    if (!beat.foot.empty() && !scene.skeleton.find(beat.foot)) {
      const JsonPath here(&beats, name);
      return GraphTextFault{JsonPath(&here, "foot").text(), "the model has no joint " + quoted(beat.foot)};
    }
  for (const auto& [mask, entries] : document.masks)
    for (std::size_t e = 0; e < entries.size(); ++e)
      if (entries[e].mask.empty() && !scene.skeleton.find(entries[e].joint))
        return joint_fault(mask, e, entries[e].joint);
  for (const auto& [name, clips] : document.variations)
    for (const auto& [old, clip] : clips) {
      const JsonPath variation(&variations, name), here(&variation, old);
      const bool plays =
          std::any_of(document.nodes.begin(), document.nodes.end(), [&, &clip_name = old](const auto& n) {
            return n.second.kind == GraphDocument::NodeKind::clip && n.second.clip == clip_name;
          });
      if (!plays) return GraphTextFault{here.text(), "the graph plays no clip " + quoted(old)};
      if (!find_numbered_clip(scene, clip))
        return GraphTextFault{here.text(), "the model has no clip " + quoted(clip) + "; " + clips_of(scene)};
    }
  return std::nullopt;
}

const BoneAnimation* bone_of(const Animation& animation, std::uint32_t joint) {
  for (const BoneAnimation& bone : animation.bones)
    if (joint != kNone && bone.joint == joint) return &bone;
  return nullptr;
}

/// Fills the clip set and the root tracks.
std::optional<GraphTextFault> bind_clips(GraphOfModel& loaded, const Scene& scene, const GraphBinding& binding) {
  const GraphDocument& document = loaded.source.document();
  const GraphDocument::Names* variation = nullptr;
  if (!binding.variation.empty()) {
    const auto found = document.variations.find(binding.variation);
    if (found == document.variations.end())
      return GraphTextFault{"/variations", "there is no variation " + quoted(binding.variation)};
    variation = &found->second;
  }
  const GraphTables& tables = loaded.graph.tables();
  const std::size_t count = tables.clip_names.size();
  loaded.roots.resize(count);
  std::vector<std::vector<SyncBeat>> beats(count);
  std::vector<GraphClip> clips;
  for (std::size_t c = 0; c < count; ++c) {
    const std::string name(tables.name_at(tables.clip_names[c]));
    const bool varies = variation != nullptr && variation->contains(name);
    const std::string& played = varies ? variation->at(name) : name;
    const auto clip = find_numbered_clip(scene, played);
    if (!clip)
      return GraphTextFault{place_of_clip(document, binding.variation, name),
                            "the model has no clip " + quoted(played) + "; " + clips_of(scene)};
    const Animation& animation = scene.animations[*clip];
    beats[c] = find_beats(document, animation, scene.skeleton);
    clips.push_back({.clip = *clip,
                     .duration_s = animation.duration_s,
                     .event_times_s = animation.annotations.event_times_s,
                     .beats = beats[c]});
    const BoneAnimation* const bone = bone_of(animation, binding.root_joint);
    if (bone == nullptr) continue;
    loaded.roots[c] =
        RootTrack::make(*bone, scene.skeleton.rest[binding.root_joint], binding.root_parts, binding.root_tolerance);
    clips.back().root = &loaded.roots[c];
  }
  auto set = GraphClipSet::make(loaded.graph, clips, mirrored_beats(document));
  if (!set) return GraphTextFault{"", "its clips make no set: " + std::string(describe(set.error()))};
  loaded.clips = std::move(*set);
  return std::nullopt;
}

}  // namespace

std::optional<GraphTextFault> find_mask_fault(const std::map<std::string, std::vector<std::string>>& masks,
                                              const Skeleton& skeleton) {
  for (const auto& [name, joints] : masks)
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (!skeleton.find(joints[j])) return joint_fault(name, j, joints[j]);
  return std::nullopt;
}

tl::expected<GraphOfModel, std::string> load_graph(const std::string& file, const Scene& scene,
                                                   const GraphBinding& binding) {
  auto source = read_graph_files(file);
  if (!source) return tl::unexpected(source.error());
  auto graph = compile_graph(source->document());
  if (!graph) return tl::unexpected(source->text_of(graph.error()));
  GraphOfModel loaded{std::move(*source), std::move(*graph), {}, {}, {}};
  if (const auto fault = find_name_fault(loaded.source.document(), scene))
    return tl::unexpected(loaded.source.text_of(*fault));
  if (const auto fault = bind_clips(loaded, scene, binding)) return tl::unexpected(loaded.source.text_of(*fault));
  auto masks = make_graph_masks(loaded.graph.tables(), scene.skeleton);
  if (!masks) return tl::unexpected(loaded.source.text_of({"/masks", std::string(describe(masks.error()))}));
  loaded.masks = std::move(*masks);
  return loaded;
}

}  // namespace sinew
