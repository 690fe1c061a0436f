// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include "importer/graph/graph_text.h"

namespace sinew {
namespace {

/// A gait: the word that marks its clips, and the assumed speed of a character. kGaits is ordered by speed.
struct Gait {
  const char* word;
  float metres_a_second;
};
constexpr std::array kGaits = {Gait{"idle", 0.0f}, Gait{"stand", 0.0f},  Gait{"survey", 0.0f},
                               Gait{"walk", 1.5f}, Gait{"jog", 3.0f},    Gait{"trot", 3.0f},
                               Gait{"run", 4.5f},  Gait{"sprint", 6.5f}, Gait{"gallop", 8.0f}};

std::string lower(const std::string& name) {
  std::string out = name;
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

/// Finds the shortest clip name that contains `word`, so "Walking" wins over "Walking_Backwards". Null if none does.
const std::string* clip_called(const std::vector<std::string>& clips, const char* word) {
  const std::string* best = nullptr;
  for (const std::string& clip : clips)
    if (lower(clip).find(word) != std::string::npos && (best == nullptr || clip.size() < best->size())) best = &clip;
  return best;
}

GraphDocument::Node clip_node(const std::string& clip, bool loop) {
  GraphDocument::Node node;
  node.clip = clip;
  node.loop = loop;
  return node;
}

}  // namespace

GraphTextResult<GraphDocument> new_graph(const std::vector<std::string>& clips) {
  GraphDocument graph;
  graph.root = "body";
  GraphDocument::Node gaits;
  gaits.kind = GraphDocument::NodeKind::blend_space;
  gaits.x = "speed";
  for (const Gait& gait : kGaits) {
    const std::string* clip = clip_called(clips, gait.word);
    if (clip == nullptr || (!gaits.points.empty() && gaits.points.back().x >= gait.metres_a_second)) continue;
    if (!graph.nodes.emplace(gait.word, clip_node(*clip, true)).second) continue;
    gaits.points.push_back({gait.metres_a_second, 0.0f, gait.word});
  }
  if (gaits.points.empty())
    return tl::make_unexpected(
        GraphTextFault{"", "no clip is called idle, stand, walk, jog, trot, run, sprint or gallop"});
  GraphDocument::Node body;
  body.kind = GraphDocument::NodeKind::machine;
  body.initial = "ground";
  body.states["ground"].node = "gaits";
  if (const std::string* jump = clip_called(clips, "jump")) {
    graph.nodes["jump"] = clip_node(*jump, false);
    graph.parameters["jump"].kind = GraphParameterKind::trigger;
    body.states["air"].node = "jump";
    GraphDocument::Transition up, down;
    up.to = "air";
    up.when = {{GraphConditionKind::trigger, "jump", 0.0f}};
    up.duration_s = 0.1f;
    down.to = "ground";
    down.when = {{GraphConditionKind::played, "", 1.0f}};
    body.states["ground"].transitions = {up};
    body.states["air"].transitions = {down};
  }
  graph.parameters["speed"] = {};
  graph.nodes["gaits"] = std::move(gaits);
  graph.nodes["body"] = std::move(body);
  return graph;
}

}  // namespace sinew
