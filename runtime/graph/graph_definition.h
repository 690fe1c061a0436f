// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/graph/graph_machine.h"
#include "runtime/graph/graph_nodes.h"
#include "runtime/graph/graph_time.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew {

/// A graph as plain tables that refer to each other by index. GraphBuilder fills them, and so may other code. Names are
/// offsets into `names`, where each name ends with a zero byte.
struct GraphTables {
  std::string names;
  std::vector<std::uint32_t> clip_names;  ///< [clips] a GraphClipSet assigns a clip to each name
  std::vector<GraphParameter> parameters;
  std::vector<GraphNode> nodes;
  GraphIndex root = 0;  ///< node

  std::vector<GraphClipNode> clips;
  std::vector<GraphBlendSpace> spaces;
  std::vector<GraphBlendPoint> points;
  std::vector<GraphSelect> selects;
  std::vector<GraphIndex> children;  ///< nodes that selects choose from
  std::vector<GraphLayers> layers;
  std::vector<GraphLayer> layer_list;
  std::vector<GraphMachine> machines;
  std::vector<GraphMachineState> states;
  std::vector<GraphTransition> transitions;
  std::vector<GraphCondition> conditions;
  std::vector<GraphFadeCurve> curves;
  std::vector<GraphFadeKey> curve_keys;
  std::vector<GraphFormula> formulas;  ///< in the order in which they are computed
  std::vector<GraphFormulaStep> formula_steps;
  std::vector<GraphMask> masks;  ///< those that layers refer to by index; masks of the caller may follow
  std::vector<GraphMaskJoint> mask_joints;

  std::span<const GraphFadeKey> keys_of(GraphIndex curve) const noexcept {
    return std::span(curve_keys).subspan(curves[curve].first_key, curves[curve].key_count);
  }
  std::string_view name_at(std::uint32_t offset) const noexcept {
    return offset < names.size() ? std::string_view(names.c_str() + offset) : std::string_view();
  }
};

/// Kind of table entry that breaks a rule.
enum class GraphTable : std::uint8_t {
  graph,
  parameter,
  node,
  clip,
  space,
  point,
  select,
  child,
  layers,
  layer,
  machine,
  state,
  transition,
  condition,
  mask,
  formula,
  curve
};

/// The first rule that a graph breaks, and the table and entry that break it.
struct GraphFault {
  ErrorCode code = ErrorCode::ok;
  GraphTable table = GraphTable::graph;
  std::uint32_t index = 0;
  GraphIndex node = kNoGraphIndex;  ///< the node that the entry belongs to
  const char* rule = "";            ///< in words
};

/// Checks all rules of a graph.
/// err  index_out_of_range, not_finite, negative_weight, not_a_fraction, too_large, times_not_increasing (points of a
///      line), unsupported (an unknown kind; a cycle; a node with two users or none; a state that nothing leads to;
///      more live operations than a program has room for)
/// cost O(tables), allocates
SINEW_API GraphFault find_fault(const GraphTables& tables);

/// Text such as "transition 2 (node locomotion): its target is no state of the machine". Empty if there is no fault.
SINEW_API std::string describe(const GraphFault& fault, const GraphTables& tables);

/// A checked graph: immutable, and shared by all characters that use it. It knows the size and layout of a character's
/// state.
class SINEW_API GraphDefinition {
 public:
  static tl::expected<GraphDefinition, GraphFault> make(GraphTables tables);

  const GraphTables& tables() const noexcept { return tables_; }

  /// Bytes of a character's state, a multiple of 8.
  std::size_t state_bytes() const noexcept { return state_bytes_; }
  /// Upper limit of the room that the pose programs of this graph need.
  const PoseProgramRoom& room() const noexcept { return room_; }

  /// A hash of the state's layout and meaning. States may only be used with graphs of the same signature.
  std::uint32_t signature() const noexcept { return signature_; }

  /// A blend space with its precomputed numbers.
  BlendSpace blend_space(GraphIndex space) const noexcept {
    const GraphBlendSpace& s = tables_.spaces[space];
    return {form_of(s), std::span(places_).subspan(s.first_point, s.point_count),
            std::span(numbers_).subspan(first_numbers_[space]), s.angle_factor};
  }

  /// Byte offset of a node's state. It counts from the memory of the nearest machine state or choice of a select above
  /// the node, else from the start of the character's state.
  std::uint32_t offset_of(GraphIndex node) const noexcept { return offsets_[node]; }
  /// Bytes of the machine's largest state, including all nodes below it.
  std::uint32_t largest_state(GraphIndex machine) const noexcept { return largest_states_[machine]; }
  /// Bytes of a machine's slot. A slot holds a state that plays or fades.
  std::uint32_t slot_bytes(GraphIndex machine) const noexcept { return slot_bytes_[machine]; }
  GraphTicks duration_of(GraphIndex transition) const noexcept { return durations_[transition]; }

  /// True if a formula computes the parameter, so that callers do not set it.
  bool is_computed(GraphIndex parameter) const noexcept;
  /// Index of the entry with this name, or kNoGraphIndex.
  GraphIndex find_parameter(std::string_view name) const noexcept;
  GraphIndex find_node(std::string_view name) const noexcept;

 private:
  static BlendSpaceKind form_of(const GraphBlendSpace& space) noexcept {
    return space.y == kNoGraphIndex ? BlendSpaceKind::line : space.form;
  }
  ErrorCode prepare_spaces(std::size_t& space);

  GraphTables tables_;
  std::vector<std::uint32_t> offsets_, largest_states_, slot_bytes_;
  std::size_t state_bytes_ = 0;
  std::vector<GraphTicks> durations_;       // [transitions]
  std::vector<glm::vec2> places_;           // [points]
  std::vector<double> numbers_;             // of all spaces
  std::vector<std::size_t> first_numbers_;  // [spaces]
  PoseProgramRoom room_;
  std::uint32_t signature_ = 0;
};

}  // namespace sinew
