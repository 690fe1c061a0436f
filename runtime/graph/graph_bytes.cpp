// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "runtime/clip/byte_stream.h"

namespace sinew {
namespace {

constexpr std::array<char, 7> kHead = {'S', 'I', 'N', 'E', 'W', 'G', 'R'};
constexpr char kNewest = 2;

/// The oldest version that has the tables of a graph.
char version_for(const GraphTables& t) {
  return t.formulas.empty() && t.formula_steps.empty() && t.curves.empty() && t.curve_keys.empty() ? 1 : 2;
}

// The fields of each entry, in their order in the bytes. Writing and reading use the same lists.
template <class Stream>
void pass(Stream& s, GraphParameter& e) {
  s(e.name, e.initial, e.kind);
}
template <class Stream>
void pass(Stream& s, GraphNode& e) {
  s(e.name, e.settings, e.kind);
}
template <class Stream>
void pass(Stream& s, GraphClipNode& e) {
  s(e.speed, e.offset_s, e.clip, e.speed_parameter, e.loop, e.mirror);
}
template <class Stream>
void pass(Stream& s, GraphBlendSpace& e) {
  s(e.x, e.y, e.first_point, e.point_count, e.form, e.angle_factor);
}
template <class Stream>
void pass(Stream& s, GraphBlendPoint& e) {
  s(e.x, e.y, e.node);
}
template <class Stream>
void pass(Stream& s, GraphSelect& e) {
  s(e.parameter, e.first_child, e.child_count);
}
template <class Stream>
void pass(Stream& s, GraphLayers& e) {
  s(e.base, e.first_layer, e.layer_count);
}
template <class Stream>
void pass(Stream& s, GraphLayer& e) {
  s(e.weight, e.node, e.weight_parameter, e.mask, e.kind);
}
template <class Stream>
void pass(Stream& s, GraphMachine& e) {
  s(e.first_state, e.state_count, e.first_any, e.any_count, e.first_entry, e.entry_count, e.initial, e.fades);
}
template <class Stream>
void pass(Stream& s, GraphMachineState& e) {
  s(e.name, e.node, e.first_transition, e.transition_count);
}
template <class Stream>
void pass(Stream& s, GraphTransition& e) {
  s(e.duration_s, e.priority, e.to, e.first_condition, e.condition_count, e.fade, e.kind, e.interruption, e.sync,
    e.start_by, e.ordered, e.to_self);
  if (s.version >= 2) s(e.curve);
}
template <class Stream>
void pass(Stream& s, GraphCondition& e) {
  s(e.value, e.parameter, e.kind);
}
template <class Stream>
void pass(Stream& s, GraphMask& e) {
  s(e.name, e.first_joint, e.joint_count);
}
template <class Stream>
void pass(Stream& s, GraphMaskJoint& e) {
  s(e.name, e.weight, e.below);
}
template <class Stream>
void pass(Stream& s, GraphFadeCurve& e) {
  s(e.first_key, e.key_count);
}
template <class Stream>
void pass(Stream& s, GraphFadeKey& e) {
  s(e.at, e.share, e.slope);
}
template <class Stream>
void pass(Stream& s, GraphFormula& e) {
  s(e.parameter, e.first_step, e.step_count);
}
template <class Stream>
void pass(Stream& s, GraphFormulaStep& e) {
  s(e.value, e.parameter, e.kind);
}
template <class Stream>
void pass(Stream& s, GraphTables& t) {
  s(t.names, t.clip_names, t.parameters, t.nodes, t.root, t.clips, t.spaces, t.points, t.selects, t.children, t.layers,
    t.layer_list, t.machines, t.states, t.transitions, t.conditions, t.masks, t.mask_joints);
  if (s.version >= 2) s(t.curves, t.curve_keys, t.formulas, t.formula_steps);
}

struct GraphWriter {
  char version;
  ByteWriter out;

  template <class... T>
  void operator()(T&... values) {
    (add(values), ...);
  }
  template <class T>
  void add(T& value) {
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>)
      out.add(static_cast<std::uint8_t>(value));
    else if constexpr (std::is_arithmetic_v<T>)
      out.add(value);
    else
      pass(*this, value);
  }
  void add(std::string& text) { out.add(std::span<const char>(text)); }
  template <class T>
  void add(std::vector<T>& table) {
    out.add(static_cast<std::uint32_t>(table.size()));
    for (T& entry : table) add(entry);
  }
};

struct GraphBytesReader {
  char version;
  ByteReader in;

  template <class... T>
  void operator()(T&... values) {
    (take(values), ...);
  }
  template <class T>
  void take(T& value) {
    if constexpr (std::is_same_v<T, bool>)
      value = in.number<std::uint8_t>() != 0;
    else if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(in.number<std::uint8_t>());
    else if constexpr (std::is_arithmetic_v<T>)
      value = in.number<T>();
    else
      pass(*this, value);
  }
  void take(std::string& text) {
    const std::vector<char> bytes = in.numbers<char>();
    text.assign(bytes.begin(), bytes.end());
  }
  template <class T>
  void take(std::vector<T>& table) {
    const auto count = in.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < count && !in.ended(); ++i) take(table.emplace_back());
  }
};

}  // namespace

std::vector<std::byte> write_graph_bytes(const GraphTables& tables) {
  GraphWriter writer{version_for(tables), {}};
  for (const char letter : kHead) writer.out.add(letter);
  writer.out.add(writer.version);
  GraphTables copy = tables;  // the lists of fields serve reading, too, so they take entries that can change
  pass(writer, copy);
  return std::move(writer.out.bytes());
}

Result<GraphTables> read_graph_bytes(std::span<const std::byte> bytes) {
  const bool is_graph =
      bytes.size() > kHead.size() && std::equal(kHead.begin(), kHead.end(), bytes.begin(),
                                                [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
  if (!is_graph) return tl::make_unexpected(ErrorCode::unsupported);
  const auto version = static_cast<char>(bytes[kHead.size()]);
  if (version < 1 || version > kNewest) return tl::make_unexpected(ErrorCode::unsupported);
  GraphBytesReader reader{version, ByteReader(bytes, kHead.size() + 1)};
  GraphTables tables;
  pass(reader, tables);
  if (reader.in.ended() || reader.in.left() != 0) return tl::make_unexpected(ErrorCode::size_mismatch);
  // Equal tables have equal bytes, so an empty graph of a newer version is none.
  if (version_for(tables) != version) return tl::make_unexpected(ErrorCode::unsupported);
  return tables;
}

}  // namespace sinew
