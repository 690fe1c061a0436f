// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "importer/graph/graph_text.h"
#include "importer/graph/join_graphs.h"
#include "runtime/base/checksum.h"
#include "runtime/graph/graph_bytes.h"
#include "runtime/graph/update_graph.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {
namespace {

/// Choices that follow from a seed (splitmix64), so that an input always plays in the same way.
class Choices {
 public:
  explicit Choices(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
  }
  template <class T, std::size_t N>
  T one_of(const std::array<T, N>& list) {
    return list[next() % N];
  }

 private:
  std::uint64_t state_;
};

void check_text(const GraphDocument& document) {
  const std::string text = write_graph(document);
  const auto again = read_graph(text);
  require(again.has_value(), "a written graph can be read");
  require(write_graph(*again) == text, "a graph keeps its text");
  require(compare_graphs(document, *again).empty(), "a graph equals itself");
  require(!draw_graph(document).empty(), "a graph has a picture");
}

/// The graph that all references of an input stand for.
const JoinedGraph& other_graph() {
  static const JoinedGraph other{
      *read_graph(R"({"graph":1,"root":"all","parameters":{"pace":{"kind":"number","initial":0.5}},
"masks":{"arm":["a"],"most":[{"mask":"arm"},"b"]},"beats":{"left":{"event":"l"}},"variations":{"hurt":{"A":"C"}},
"nodes":{"all":{"kind":"layers","base":"gait","layers":[{"node":"over","mask":"most"}]},
"gait":{"kind":"blend_space","x":"pace","points":[{"x":0,"node":"slow"},{"x":1,"node":"fast"}]},
"slow":{"kind":"clip","clip":"A"},"fast":{"kind":"clip","clip":"B"},"over":{"kind":"clip","clip":"C"}}})"),
      {}};
  return other;
}

/// Joins the references of a document with the other graph.
std::optional<GraphTextFault> join_references(JoinedGraph& joined) {
  std::vector<std::string> names;
  for (const auto& [name, node] : joined.document.nodes)
    if (node.kind == GraphDocument::NodeKind::graph) names.push_back(name);
  for (const std::string& name : names)
    if (auto fault = join_graph(joined, name, other_graph(), "other.json")) return fault;
  return std::nullopt;
}

void check_bytes(const GraphDefinition& graph) {
  const std::vector<std::byte> bytes = write_graph_bytes(graph.tables());
  const auto again = read_graph_bytes(bytes);
  require(again.has_value() && write_graph_bytes(*again) == bytes, "a graph keeps its bytes");
  const auto other = GraphDefinition::make(*again);
  require(other.has_value() && other->signature() == graph.signature(), "a graph keeps its states");
}

/// One character of a graph whose clips, parameters and time steps are chosen at random.
class Player {
 public:
  Player(const GraphDefinition& graph, Choices choices) : graph_(graph), choices_(choices) {
    constexpr std::array kDurations{0.0, 1e-6, 0.001, 0.4, 1.0, 1.0333333, 100.0, 6000.0};
    std::vector<GraphClip> clips(graph.tables().clip_names.size());
    std::vector<std::array<double, 2>> events(clips.size());
    std::vector<std::vector<SyncBeat>> beats(clips.size());
    for (std::size_t c = 0; c < clips.size(); ++c) {
      const double duration_s = choices_.one_of(kDurations);
      events[c] = {duration_s * choices_.one_of(std::array{0.0, 0.1}), duration_s};
      for (std::size_t beat = choices_.next() % 5; beat-- > 0;)
        beats[c].insert(beats[c].begin(),
                        {0.2 * static_cast<double>(beat), static_cast<std::uint32_t>(choices_.next() % 2)});
      clips[c] = {.clip = static_cast<std::uint32_t>(c),
                  .duration_s = duration_s,
                  .event_times_s = events[c],
                  .beats = beats[c]};
    }
    constexpr std::array kMirrored{1u, 0u};
    auto set = GraphClipSet::make(graph, clips, kMirrored);
    require(set.has_value(), "clips of any length are taken");
    clips_ = std::move(*set);
    for (const GraphParameter& parameter : graph.tables().parameters) values_.push_back(parameter.initial);
    state_.resize(graph.state_bytes() / sizeof(std::uint64_t) + 1);
  }

  void play() {
    require(run(StartGraphJob{&graph_, &clips_, values_, bytes()}) == ErrorCode::ok, "a graph starts");
    for (int step = 0; step < 8; ++step) {
      change_parameters();
      const double dt_s = choices_.one_of(std::array{0.0, 1e-9, 0.001, 1.0 / 60, 0.1, 0.7, -0.02, -0.5});
      const std::vector<std::uint64_t> before = state_;
      update(dt_s);
      const std::vector<std::uint64_t> after = state_;
      const std::vector<PoseOp> ops(program_.ops().begin(), program_.ops().end());
      state_ = before;
      update(dt_s);
      require(state_ == after && ops.size() == program_.ops().size() &&
                  std::memcmp(ops.data(), program_.ops().data(), ops.size() * sizeof(PoseOp)) == 0,
              "a restored state plays again bit for bit");
    }
  }

 private:
  std::span<std::byte> bytes() { return std::as_writable_bytes(std::span(state_)); }

  void change_parameters() {
    constexpr std::array kValues{0.0f, 1.0f, -1.0f, 0.3f, 0.5f, 2.0f, 1e-30f, 1e30f, -3.4e38f};
    const auto& parameters = graph_.tables().parameters;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      if (choices_.next() % 2 == 0) continue;
      if (parameters[p].kind == GraphParameterKind::trigger)
        require(set_trigger(graph_, bytes(), static_cast<GraphIndex>(p)) == ErrorCode::ok, "a trigger is set");
      else
        values_[p] = choices_.one_of(kValues);
    }
  }

  void update(double dt_s) {
    GraphStep step;
    require(run(UpdateGraphJob{&graph_, &clips_, values_, bytes(), dt_s, &program_, events_, &step}) == ErrorCode::ok,
            "a sound graph plays");
    require(program_.is_complete(), "a program fits");
    const PoseProgramRoom& room = graph_.room();
    const PoseProgramLimits limits{.clips = clips_.entries().size(),
                                   .externals = room.externals,
                                   .masks = room.masks,
                                   .mirror = true,
                                   .slots = room.slots,
                                   .kept = room.kept,
                                   .overlays_in_model_space = room.overlays_in_model_space};
    require(program_.ops().size() <= room.ops, "the room tells the length of a program");
    require(check(program_.ops(), limits) == ErrorCode::ok, "a program is sound");
    const auto events = std::span(events_).first(step.event_count);
    require(std::is_sorted(events.begin(), events.end(),
                           [&](const auto& a, const auto& b) { return dt_s < 0.0 ? a.at > b.at : a.at < b.at; }),
            "events have the order of time");
    for (const GraphEvent& event : events)
      require(event.weight >= 0.0f && std::isfinite(event.weight), "events have weights");
  }

  const GraphDefinition& graph_;
  Choices choices_;
  GraphClipSet clips_;
  std::vector<float> values_;
  std::vector<std::uint64_t> state_;
  std::vector<GraphEvent> events_ = std::vector<GraphEvent>(64);
  PoseProgram program_;
};

}  // namespace

void play_graphs(Bytes input) {
  const auto document = read_graph({reinterpret_cast<const char*>(input.data()), input.size()});
  if (!document) return require(!document.error().sentence.empty(), "an error says what is wrong");
  check_text(*document);
  JoinedGraph joined{*document, {}};
  if (const auto fault = join_references(joined))
    return require(!fault->sentence.empty(), "an error says what is wrong");
  const auto graph = compile_graph(joined.document);
  if (!graph) return require(!graph.error().sentence.empty(), "an error says what is wrong");
  check_bytes(*graph);
  Player(*graph, Choices(checksum(input))).play();
}

void play_graph_bytes(Bytes input) {
  const auto tables = read_graph_bytes(input);
  if (!tables) return;
  const auto graph = GraphDefinition::make(*tables);
  if (!graph) return require(!describe(graph.error(), *tables).empty(), "an error says what is wrong");
  check_bytes(*graph);
  Player(*graph, Choices(checksum(input))).play();
}

}  // namespace sinew::fuzz
