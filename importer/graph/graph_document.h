// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "runtime/graph/graph_definition.h"

namespace sinew {

/// A motion graph as its JSON file states it: nodes, parameters and masks refer to each other by name. The maps sort
/// names, so equal documents give equal text. graph_schema.h lists the JSON key of each member.
struct GraphDocument {
  struct Parameter {
    GraphParameterKind kind = GraphParameterKind::number;
    float initial = 0.0f;
  };
  struct Condition {
    GraphConditionKind kind = GraphConditionKind::on;
    std::string parameter;
    float value = 0.0f;
  };
  struct Transition {
    std::string to;
    std::vector<Condition> when;
    float duration_s = 0.2f;
    std::int32_t priority = 0;
    GraphTransitionKind kind = GraphTransitionKind::cross_fade;
    GraphFade fade = GraphFade::smooth;
    GraphInterruption interruption = GraphInterruption::target;
    GraphSync sync = GraphSync::none;
    bool ordered = false, to_self = false;
  };
  struct State {
    std::string node;
    std::vector<Transition> transitions;
  };
  struct Point {
    float x = 0.0f, y = 0.0f;
    std::string node;
  };
  struct Layer {
    std::string node;
    GraphLayerKind kind = GraphLayerKind::overlay;
    float weight = 1.0f;
    std::string weight_by, mask;
  };

  /// A node of the graph. `kind` selects the group of members that is used; all other members keep their defaults.
  struct Node {
    GraphNodeKind kind = GraphNodeKind::clip;
    std::string clip, speed_by;  // clip
    float speed = 1.0f, offset_s = 0.0f;
    bool loop = true, mirror = false;
    std::string x, y;  // blend_space
    BlendSpaceKind form = BlendSpaceKind::cartesian;
    float angle_factor = 1.0f;
    std::vector<Point> points;
    std::string by;  // select
    std::vector<std::string> children;
    std::string base;  // layers
    std::vector<Layer> layers;
    std::string initial;  // machine
    std::int32_t fades = 4;
    std::map<std::string, State> states;
    std::vector<Transition> any, entry;
    std::int32_t pose = 0;  // external
  };

  std::map<std::string, Parameter> parameters;
  /// Joint names of each mask; a joint stands for itself and all its descendants. Compiled masks are in name order.
  std::map<std::string, std::vector<std::string>> masks;
  std::map<std::string, Node> nodes;
  std::string root;
};

}  // namespace sinew
