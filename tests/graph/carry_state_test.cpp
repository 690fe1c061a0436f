// SPDX-License-Identifier: MIT
// Characters that go on playing while their graph is edited.
#include "runtime/graph/carry_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "runtime/graph/read_graph_state.h"
#include "tests/graph/graph_player.h"

namespace sinew {
namespace {

constexpr std::size_t kStates = 5;

/// Changes that an edit makes. The defaults are the graph as it is played first.
struct Edit {
  std::uint32_t order = 0;            ///< seed of the order in which parameters, clips and states are declared
  std::vector<std::string> gone;      ///< states that are left out
  float duration_s = 0.4f;            ///< of all fades
  bool cuts = true;                   ///< false: transitions into odd states cross-fade, too
  std::string first_name = "state0";  ///< name of the first state
};

/// Two machines, one of them over the other; every third state is a select or a space.
struct Edited {
  GraphDefinition graph;
  GraphClipSet clips;
  GraphIndex go = 0, look = 0, jump = 0;

  explicit Edited(const Edit& edit) {
    GraphBuilder b;
    std::vector<std::function<void()>> parameters = {[&] { go = b.number("go"); }, [&] { look = b.number("look"); },
                                                     [&] { jump = b.trigger("jump"); }};
    std::mt19937 random(edit.order);
    if (edit.order != 0) std::shuffle(parameters.begin(), parameters.end(), random);
    for (const auto& declare : parameters) declare();
    const GraphIndex body = add_machine(b, "body", go, edit, random), arms = add_machine(b, "arms", look, edit, random);
    const GraphLayer layer{.weight = 0.5f, .node = arms};
    graph = *b.build(b.layers("all", body, std::vector{layer}));
    std::vector<GraphClip> of_names;
    for (const std::uint32_t name : graph.tables().clip_names) {
      const std::string text(graph.tables().name_at(name));
      const auto number = static_cast<std::uint32_t>(std::hash<std::string>()(text) % 1000);  // the same in all orders
      of_names.push_back({.clip = number, .duration_s = 0.5 + 0.001 * number});
    }
    clips = *GraphClipSet::make(graph, of_names);
  }

 private:
  GraphIndex add_node(GraphBuilder& b, const std::string& name, std::size_t state) {
    const auto clip = [&](const char* more) { return b.clip(name + more, {.speed = 0.7f}); };
    if (state % 3 == 1) {
      const std::vector<GraphIndex> children = {clip(".a"), clip(".b")};
      return b.select(name, look, children);
    }
    if (state % 3 == 2) {
      const std::vector<GraphBlendPoint> points = {{0, 0, clip(".a")}, {1, 0, clip(".b")}};
      return b.blend_space(name, {.x = look}, points);
    }
    return clip("");
  }

  GraphIndex add_machine(GraphBuilder& b, const std::string& name, GraphIndex by, const Edit& edit,
                         std::mt19937& random) {
    std::vector<std::size_t> order(kStates);
    std::iota(order.begin(), order.end(), 0);
    if (edit.order != 0) std::shuffle(order.begin(), order.end(), random);
    const GraphIndex machine = b.machine(name);
    std::vector<GraphIndex> index(kStates, kNoGraphIndex);
    for (const std::size_t s : order) {
      const std::string state = s == 0 ? edit.first_name : "state" + std::to_string(s);
      if (std::find(edit.gone.begin(), edit.gone.end(), state) != edit.gone.end()) continue;
      index[s] = b.state(machine, state, add_node(b, name + std::to_string(s), s));
    }
    for (std::size_t s = 0; s < kStates; ++s) {
      if (index[s] == kNoGraphIndex) continue;
      GraphTransition to{.duration_s = edit.duration_s, .to = index[s]};
      if (edit.cuts && s % 2 == 1)
        to.kind = s == 1 ? GraphTransitionKind::inertialize : GraphTransitionKind::dead_blend;
      b.transition_from_any(machine, to, {{static_cast<float>(s), by, GraphConditionKind::equal}});
    }
    return machine;
  }
};

/// A character of a graph.
struct Character {
  const Edited* of;
  std::vector<std::uint64_t> memory;
  PoseProgram program;
  GraphStep step;
  float go = 0.0f, look = 0.0f;

  explicit Character(const Edited& graph) : of(&graph), memory(graph.graph.state_bytes() / 8) {
    EXPECT_EQ(run(StartGraphJob{&of->graph, &of->clips, values(), state()}), ErrorCode::ok);
  }
  /// The same character with another version of its graph.
  Character(const Character& before, const Edited& graph) : of(&graph), memory(graph.graph.state_bytes() / 8) {
    go = before.go;
    look = before.look;
    EXPECT_EQ(run(CarryStateJob{&before.of->graph, std::as_bytes(std::span(before.memory)), &of->graph, &of->clips,
                                values(), state()}),
              ErrorCode::ok);
  }
  std::span<std::byte> state() { return std::as_writable_bytes(std::span(memory)); }
  std::vector<float> values() const {
    std::vector<float> all(of->graph.tables().parameters.size(), 0.0f);
    all[of->go] = go;
    all[of->look] = look;
    return all;
  }
  std::vector<PoseOp> advance(double dt_s) {
    EXPECT_EQ(run(UpdateGraphJob{&of->graph, &of->clips, values(), state(), dt_s, &program, {}, &step}), ErrorCode::ok);
    return {program.ops().begin(), program.ops().end()};
  }
  /// "MACHINE:STATE" of the states that play.
  std::vector<std::string> playing() {
    std::vector<GraphStateView> views(32);
    views.resize(read_graph_state(of->graph, of->clips, values(), state(), views));
    std::vector<std::string> names;
    const GraphTables& t = of->graph.tables();
    for (const GraphStateView& view : views)
      names.push_back(
          std::string(t.name_at(t.nodes[view.node].name)) + ':' +
          std::string(t.name_at(t.states[t.machines[t.nodes[view.node].settings].first_state + view.state].name)));
    return names;
  }
};

TEST(carry_state, another_order_of_declaration_changes_no_bit_of_what_follows) {
  const Edited plain({});
  for (std::uint32_t order = 1; order <= 12; ++order) {
    const Edited shuffled(Edit{.order = order, .gone = {}});
    std::mt19937 random(order);
    Character stays(plain);
    for (int round = 0; round < 40; ++round) {
      for (int i = 0; i < 3; ++i) {
        stays.go = static_cast<float>(random() % kStates);
        stays.look = static_cast<float>(random() % kStates);
        stays.advance(0.07 * static_cast<double>(random() % 4));
      }
      Character moves(stays, shuffled);
      const std::vector<std::uint64_t> saved = stays.memory;
      ASSERT_EQ(moves.playing(), stays.playing()) << order << ' ' << round;
      for (int i = 0; i < 12; ++i) {
        if (i == 3) stays.go = moves.go = static_cast<float>(random() % kStates);
        const double dt_s = 0.05 * (i % 3);
        ASSERT_EQ(moves.advance(dt_s), stays.advance(dt_s)) << order << ' ' << round << ' ' << i;
      }
      stays.memory = saved;
    }
  }
}

TEST(carry_state, a_machine_whose_state_is_gone_starts_anew_and_others_go_on) {
  const Edited plain({}), less(Edit{.gone = {"state3"}});
  Character before(plain);
  before.go = 3.0f;
  before.advance(1.0);
  before.look = 2.0f;
  before.advance(1.0);
  before.advance(0.3);
  ASSERT_EQ(before.playing(), (std::vector<std::string>{"body:state3", "arms:state2"}));
  Character after(before, less);
  EXPECT_EQ(after.playing(), (std::vector<std::string>{"body:state0", "arms:state2"}));
  const std::vector<PoseOp> played = before.advance(0.0), plays = after.advance(0.0);
  ASSERT_EQ(played.size(), plays.size());
  EXPECT_EQ(plays[0].time_s, 0.0) << "anew";
  EXPECT_EQ(plays[1], played[1]) << "the upper machine";
}

TEST(carry_state, fades_go_on_unless_their_transition_or_its_kind_is_gone) {
  const Edited plain({}), slower(Edit{.gone = {}, .duration_s = 0.8f}), without_cuts(Edit{.gone = {}, .cuts = false}),
      other(Edit{.gone = {}, .first_name = "start"});
  Character before(plain);
  before.go = 2.0f;
  before.advance(0.0);
  before.advance(0.2);
  ASSERT_EQ(before.playing(), (std::vector<std::string>{"body:state0", "body:state2", "arms:state0"}));
  std::vector<GraphStateView> views(8);
  const auto share_of_new = [&](Character character) {
    views.resize(8);
    views.resize(
        read_graph_state(character.of->graph, character.of->clips, character.values(), character.state(), views));
    return views.size() > 1 ? views[1].weight : -1.0f;
  };
  EXPECT_FLOAT_EQ(share_of_new(before), 0.5f);
  EXPECT_FLOAT_EQ(share_of_new(Character(before, slower)), 0.15625f) << "0.2 of 0.8 s";
  Character after(before, other);
  EXPECT_EQ(after.playing(), (std::vector<std::string>{"body:state2", "arms:start"})) << "the state that fades is gone";
  before.go = 1.0f;  // by inertialization
  before.advance(0.0);
  before.advance(0.05);
  EXPECT_GT(before.advance(0.0).size(), 8u) << "an inertialization is under way";
  Character cross(before, without_cuts);
  EXPECT_EQ(cross.playing(), (std::vector<std::string>{"body:state1", "arms:state0"}));
}

TEST(carry_state, triggers_requests_and_the_clock_stay) {
  const Edited plain({}), shuffled(Edit{.order = 5, .gone = {}});
  Character before(plain);
  before.advance(0.25);
  ASSERT_EQ(set_trigger(plain.graph, before.state(), plain.jump), ErrorCode::ok);
  ASSERT_EQ(request_state(plain.graph, before.state(), plain.graph.find_node("arms"), 4), ErrorCode::ok);
  Character after(before, shuffled);
  const GraphHeader& header = block_at<GraphHeader>(after.state().data());
  EXPECT_EQ(header.now, ticks_of(0.25));
  EXPECT_EQ(header.triggers, std::uint64_t{1} << shuffled.jump);
  after.advance(0.0);
  EXPECT_EQ(after.playing().back(), "arms:state4");
}

TEST(carry_state, positions_fit_clips_that_are_shorter_now) {
  GraphBuilder b;
  const GraphDefinition graph = *b.build(b.clip("once", {.loop = false}));
  const GraphClipSet length_2 = *GraphClipSet::make(graph, std::vector<GraphClip>{{0, 2.0}}),
                     length_1 = *GraphClipSet::make(graph, std::vector<GraphClip>{{0, 1.0}});
  std::vector<std::uint64_t> old_state(graph.state_bytes() / 8), state(graph.state_bytes() / 8);
  PoseProgram program;
  GraphStep step;
  const auto old_bytes = std::as_writable_bytes(std::span(old_state)), bytes = std::as_writable_bytes(std::span(state));
  ASSERT_EQ(run(StartGraphJob{&graph, &length_2, {}, old_bytes}), ErrorCode::ok);
  ASSERT_EQ(run(UpdateGraphJob{&graph, &length_2, {}, old_bytes, 1.5, &program, {}, &step}), ErrorCode::ok);
  ASSERT_EQ(run(CarryStateJob{&graph, old_bytes, &graph, &length_1, {}, bytes}), ErrorCode::ok);
  ASSERT_EQ(run(UpdateGraphJob{&graph, &length_1, {}, bytes, 0.0, &program, {}, &step}), ErrorCode::ok);
  EXPECT_EQ(program.ops()[0].time_s, 1.0);
  EXPECT_EQ(run(CarryStateJob{nullptr, old_bytes, &graph, &length_1, {}, bytes}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(CarryStateJob{&graph, old_bytes.first(8), &graph, &length_1, {}, bytes}), ErrorCode::size_mismatch);
  old_state.assign(old_state.size(), 0);
  EXPECT_EQ(run(CarryStateJob{&graph, old_bytes, &graph, &length_1, {}, bytes}), ErrorCode::wrong_plan);
}

}  // namespace
}  // namespace sinew
