// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/blend_space/blend_space.h"

namespace sinew {

/// Index into a table of a graph.
using GraphIndex = std::uint16_t;
inline constexpr GraphIndex kNoGraphIndex = 0xFFFF;

/// Kinds of nodes. Each node makes one pose.
enum class GraphNodeKind : std::uint8_t {
  clip,         ///< plays a clip
  blend_space,  ///< mixes clips by one or two numbers; all of them share one phase
  select,       ///< plays one of its children, chosen by a number
  layers,       ///< a base and poses above it
  machine,      ///< a state machine: one state at a time, faded into each other
  external,     ///< a pose of the caller: a ragdoll, the network
};

/// A node. `settings` is an index into the table of its kind; for external it is the index of the pose.
struct GraphNode {
  std::uint32_t name = 0;
  GraphIndex settings = 0;
  GraphNodeKind kind = GraphNodeKind::clip;
};

/// Kinds of parameters. Values are floats: a flag is on if its value is not 0.
enum class GraphParameterKind : std::uint8_t {
  number,
  flag,
  trigger,  ///< has no value; set_trigger keeps it until a transition uses it up
};

struct GraphParameter {
  std::uint32_t name = 0;
  float initial = 0.0f;
  GraphParameterKind kind = GraphParameterKind::number;
};

struct GraphClipNode {
  float speed = 1.0f;     ///< at most kMostGraphSpeed on either side of 0; negative plays backwards
  float offset_s = 0.0f;  ///< where the clip starts
  GraphIndex clip = 0;    ///< of the graph's clip names
  GraphIndex speed_parameter = kNoGraphIndex;  ///< multiplies `speed`
  bool loop = true;                            ///< else the clip stays at its end
  bool mirror = false;
};
inline constexpr float kMostGraphSpeed = 256.0f;

/// Clip nodes at places on a line or in a plane. Weights follow the parameters at once. Speeds and lengths of the clips
/// are mixed by weight. The mirror and speed of each clip node count, its offset does not.
struct GraphBlendSpace {
  GraphIndex x = kNoGraphIndex;
  GraphIndex y = kNoGraphIndex;  ///< none: the space is a line
  GraphIndex first_point = 0, point_count = 0;
  BlendSpaceKind form = BlendSpaceKind::cartesian;  ///< in a plane; on a line it does not count
  float angle_factor = 1.0f;                        ///< as BlendSpace::angle_factor
};

struct GraphBlendPoint {
  float x = 0.0f, y = 0.0f;  ///< on a line y is 0 and x rises
  GraphIndex node = 0;
};

/// Child floor(value + 0.5) of the list, the first or last one beyond its ends. A new choice starts anew, at once.
struct GraphSelect {
  GraphIndex parameter = 0;
  GraphIndex first_child = 0, child_count = 0;
};

/// How a layer joins what lies below it.
enum class GraphLayerKind : std::uint8_t {
  mean,           ///< (below + w layer) / (1 + w)
  overlay,        ///< (1 - w) below + w layer, by the mask
  overlay_model,  ///< overlay whose rotations are mixed in model space
  additive,       ///< adds the layer's difference from the rest pose, w times
};

/// Layers above a base. Root motion comes from the base and from mean layers.
struct GraphLayers {
  GraphIndex base = 0;
  GraphIndex first_layer = 0, layer_count = 0;
};

struct GraphLayer {
  float weight = 1.0f;  ///< finite, >= 0
  GraphIndex node = 0;
  GraphIndex weight_parameter = kNoGraphIndex;  ///< multiplies `weight`; values below 0 count as 0
  std::uint8_t mask = 255;                      ///< joint weights, as PoseOp::mask; 255 is all joints
  GraphLayerKind kind = GraphLayerKind::overlay;
};

}  // namespace sinew
