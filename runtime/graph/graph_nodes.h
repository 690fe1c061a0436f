// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/blend_space/blend_space.h"

namespace sinew {

/// Index into a table of a graph.
using GraphIndex = std::uint16_t;
inline constexpr GraphIndex kNoGraphIndex = 0xFFFF;

/// Kinds of nodes. Each node makes one pose.
enum class GraphNodeKind : std::uint8_t {
  clip,         ///< plays a clip
  blend_space,  ///< mixes clips by one or two parameters; all clips share one phase
  select,       ///< plays one of its children, chosen by a parameter
  layers,       ///< a base pose with layers on top
  machine,      ///< a state machine: plays one state, and fades from state to state
  external,     ///< a pose of the caller: a ragdoll, the network
};

/// A node. `settings` is an index into the table of its kind; for `external` it is the index of the caller's pose.
struct GraphNode {
  std::uint32_t name = 0;
  GraphIndex settings = 0;
  GraphNodeKind kind = GraphNodeKind::clip;
};

/// Kinds of parameters. Values are floats: a flag is on if its value is not 0.
enum class GraphParameterKind : std::uint8_t {
  number,
  flag,
  trigger,  ///< has no value; set_trigger sets it until a transition uses it up
};

struct GraphParameter {
  std::uint32_t name = 0;
  float initial = 0.0f;
  GraphParameterKind kind = GraphParameterKind::number;
};

/// Steps of a formula. Each takes its operands from a stack of numbers and puts its result there. Truths are 1 and 0;
/// every number but 0 is true.
enum class GraphFormulaKind : std::uint8_t {
  number,          ///< the step's value
  parameter,       ///< the value of the step's parameter
  negate,          ///< -a
  absolute,        ///< |a|
  is_false,        ///< a == 0
  add,             ///< a + b
  subtract,        ///< a - b
  multiply,        ///< a b
  divide,          ///< a / b; 0 if b is 0
  minimum,         ///< of a and b
  maximum,         ///< of a and b
  length,          ///< sqrt(a^2 + b^2)
  below,           ///< a < b
  below_or_equal,  ///< a <= b
  equal,           ///< a == b
  both,            ///< a and b are true
  either,          ///< a or b is true
  choose,          ///< b if a is true, else c
};

struct GraphFormulaStep {
  float value = 0.0f;
  GraphIndex parameter = kNoGraphIndex;
  GraphFormulaKind kind = GraphFormulaKind::number;
};

/// Computes a parameter from others, in double precision, at the start of each update. The caller's value of the
/// parameter is ignored. A formula may read parameters that earlier formulas compute. Results beyond the range of float
/// are its largest numbers.
struct GraphFormula {
  GraphIndex parameter = 0;
  GraphIndex first_step = 0, step_count = 0;
};
inline constexpr std::size_t kMostFormulaNumbers = 16;     ///< on the stack at once
inline constexpr std::size_t kMostParametersBeside = 256;  ///< parameters of a graph that has formulas

struct GraphClipNode {
  float speed = 1.0f;                          ///< from -kMostGraphSpeed to kMostGraphSpeed; negative plays backwards
  float offset_s = 0.0f;                       ///< time in the clip at which it starts
  GraphIndex clip = 0;                         ///< index of a clip name of the graph
  GraphIndex speed_parameter = kNoGraphIndex;  ///< multiplies `speed`
  bool loop = true;                            ///< false: the clip stops at its end
  bool mirror = false;
};
inline constexpr float kMostGraphSpeed = 256.0f;

/// Clip nodes at points on a line or in a plane. Weights follow the parameters without delay. The clips' speeds and
/// lengths are mixed by weight. Mirror and speed of each clip node are used, its offset is not.
struct GraphBlendSpace {
  GraphIndex x = kNoGraphIndex;
  GraphIndex y = kNoGraphIndex;  ///< kNoGraphIndex: the space is a line
  GraphIndex first_point = 0, point_count = 0;
  BlendSpaceKind form = BlendSpaceKind::cartesian;  ///< how a place in a plane becomes weights of the points
  float angle_factor = 1.0f;                        ///< as BlendSpace::angle_factor
};

struct GraphBlendPoint {
  float x = 0.0f, y = 0.0f;  ///< on a line y is 0, and x increases from point to point
  GraphIndex node = 0;
};

/// Plays child floor(value + 0.5) of its list, clamped to the list. A newly chosen child starts from its beginning,
/// without a fade.
struct GraphSelect {
  GraphIndex parameter = 0;
  GraphIndex first_child = 0, child_count = 0;
};

/// How a layer is combined with the pose below it.
enum class GraphLayerKind : std::uint8_t {
  mean,           ///< (below + w layer) / (1 + w)
  overlay,        ///< (1 - w) below + w layer, by the mask
  overlay_model,  ///< as overlay, but rotations are mixed in model space
  additive,       ///< adds the layer's difference from the rest pose, times w
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
  std::uint8_t mask = 255;                      ///< index of joint weights, as PoseOp::mask; 255 = all joints
  GraphLayerKind kind = GraphLayerKind::overlay;
};

/// A named choice of joints for layers (make_graph_masks).
struct GraphMask {
  std::uint32_t name = 0;
  GraphIndex first_joint = 0, joint_count = 0;
};

/// An entry of a mask. Later entries of a mask win, so an entry of weight 0 takes joints out again.
struct GraphMaskJoint {
  std::uint32_t name = 0;
  float weight = 1.0f;  ///< [0, 1]
  bool below = true;    ///< true: also all joints below it
};

}  // namespace sinew
