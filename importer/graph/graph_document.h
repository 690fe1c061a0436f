// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/graph/graph_definition.h"

namespace sinew {

/// A motion graph as its JSON file states it: nodes, parameters and masks refer to each other by name. The maps sort
/// names, so equal documents give equal text. graph_schema.h lists the JSON key of each member.
struct GraphDocument {
  /// The kinds of nodes of a GraphDefinition, and `graph`: a reference to the graph of another file.
  enum class NodeKind : std::uint8_t { clip, blend_space, select, layers, machine, external, graph };

  /// New names by old names.
  using Names = std::map<std::string, std::string>;

  struct Parameter {
    GraphParameterKind kind = GraphParameterKind::number;
    float initial = 0.0f;
    std::string formula;  ///< computes it from other parameters (formula_text.h); empty: the caller sets it
  };
  struct CurveKey {
    float at = 0.0f, share = 0.0f;
  };
  struct Curve {
    float start_slope = 0.0f, end_slope = 0.0f;
    std::vector<CurveKey> keys;
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
    std::optional<Curve> curve;
    GraphInterruption interruption = GraphInterruption::target;
    GraphSync sync = GraphSync::none;
    SyncStart start_by = SyncStart::phase;
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
    NodeKind kind = NodeKind::clip;
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
    std::string file;       // graph
    Names parameters, clips;
  };

  /// An entry of a mask. A joint of weight 1 that counts with all below it is written as the name alone.
  struct MaskJoint {
    std::string joint;
    std::string mask;  ///< instead of `joint`: another mask, whose entries stand here
    float weight = 1.0f;
    bool below = true;
  };

  /// A foot that touches the ground.
  struct Beat {
    std::string event, foot, mirror;
  };

  std::map<std::string, Parameter> parameters;
  std::map<std::string, Beat> beats;
  /// Later entries of a mask win. Compiled masks are in name order.
  std::map<std::string, std::vector<MaskJoint>> masks;
  std::map<std::string, Node> nodes;
  /// Clips that characters of another kind play instead of the graph's clips.
  std::map<std::string, Names> variations;
  std::string root;
};

}  // namespace sinew
