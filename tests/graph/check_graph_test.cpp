// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "runtime/graph/graph_builder.h"
#include "runtime/graph/state_blocks.h"

namespace sinew {
namespace {

/// A graph with a node of each kind.
GraphTables tables_of_all() {
  GraphBuilder b;
  const GraphIndex speed = b.number("speed"), jump = b.trigger("jump");
  const std::vector<GraphBlendPoint> points = {{0, 0, b.clip("idle")}, {1, 0, b.clip("walk")}};
  const GraphIndex space = b.blend_space("gaits", {.x = speed}, points);
  const GraphIndex machine = b.machine("body");
  const GraphIndex ground = b.state(machine, "ground", space);
  const std::vector<GraphIndex> children = {b.clip("jump"), b.external("ragdoll", 2)};
  const GraphIndex air = b.state(machine, "air", b.select("choice", speed, children));
  b.transition(machine, ground, {.to = air}, {when_triggered(jump)});
  b.transition(machine, air, {.to = ground}, {when_played(1)});
  const GraphLayer layer{.node = b.clip("wave"), .mask = 3};
  return b.tables(b.layers("all", machine, std::vector{layer}));
}

TEST(check_graph, each_rule_names_what_breaks_it) {
  struct Case {
    const char* text;
    ErrorCode code;
    std::function<void(GraphTables&)> change;
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  using enum ErrorCode;
  const std::vector<Case> cases = {
      {"graph: the root is no node", index_out_of_range, [](auto& t) { t.root = 99; }},
      {"parameter 1 'jump': its kind is unknown", unsupported,
       [](auto& t) { t.parameters[1].kind = static_cast<GraphParameterKind>(9); }},
      {"parameter 0 'speed': its initial value is not finite", not_finite,
       [=](auto& t) { t.parameters[0].initial = kNan; }},
      {"clip 0 (node 'idle'): its clip does not exist", index_out_of_range, [](auto& t) { t.clips[0].clip = 9; }},
      {"clip 0 (node 'idle'): its speed is not between -256 and 256", too_large,
       [=](auto& t) { t.clips[0].speed = kNan; }},
      {"blend space 0 (node 'gaits'): its parameter is a trigger, which has no value", unsupported,
       [](auto& t) { t.spaces[0].x = 1; }},
      {"point 1 (node 'gaits'): points of a line do not rise", times_not_increasing,
       [](auto& t) { t.points[1].x = 0; }},
      {"point 1 (node 'gaits'): its node is used elsewhere, too", unsupported,
       [](auto& t) { t.points[1].node = t.points[0].node; }},
      {"state 1 'air' (node 'body'): no transition leads to it", unsupported, [](auto& t) { t.transitions[0].to = 0; }},
      {"transition 0 (node 'body'): its target is no state of the machine", index_out_of_range,
       [](auto& t) { t.transitions[0].to = 2; }},
      {"transition 0 (node 'body'): it does not last 0 to 3600 s", too_large,
       [=](auto& t) { t.transitions[0].duration_s = kNan; }},
      {"condition 0 (node 'body'): its parameter is no trigger", index_out_of_range,
       [](auto& t) { t.conditions[0].parameter = 0; }},
      {"layer 0 (node 'all'): its weight is below 0", negative_weight, [](auto& t) { t.layer_list[0].weight = -1; }},
      {"machine 0 (node 'body'): its initial state does not exist", index_out_of_range,
       [](auto& t) { t.machines[0].initial = 2; }},
      {"child 1 (node 'choice'): its node does not exist", index_out_of_range, [](auto& t) { t.children[1] = 77; }},
      {"node 0 (node 'idle'): its kind is unknown", unsupported,
       [](auto& t) { t.nodes[0].kind = static_cast<GraphNodeKind>(77); }},
      {"graph (node 'all'): more than 254 pose operations can be live at once", too_large,
       [](auto& t) {
         t.machines[0].fades = 8;
         const auto first = t.points[0];
         for (int i = 2; i < 32; ++i) {
           t.nodes.push_back(t.nodes[first.node]);
           t.points.push_back({static_cast<float>(i), 0, static_cast<GraphIndex>(t.nodes.size() - 1)});
         }
         t.spaces[0].point_count = 32;
       }},
  };
  ASSERT_EQ(find_fault(tables_of_all()).code, ok);
  for (const Case& c : cases) {
    GraphTables tables = tables_of_all();
    c.change(tables);
    const auto graph = GraphDefinition::make(tables);
    ASSERT_FALSE(graph) << c.text;
    EXPECT_EQ(graph.error().code, c.code) << c.text;
    EXPECT_EQ(describe(graph.error(), tables), c.text);
  }
}

TEST(check_graph, a_node_below_itself_is_a_cycle) {
  GraphBuilder b;
  const GraphIndex root = b.clip("root");
  const GraphIndex machine = b.machine("loop");
  GraphTables t = b.tables(root);
  t.states.push_back({.node = machine});
  t.machines[0].state_count = 1;
  EXPECT_EQ(describe(find_fault(t), t), "node 1 (node 'loop'): it lies on a cycle");
}

TEST(check_graph, a_transition_from_no_state_is_not_lost) {
  GraphBuilder b;
  const GraphIndex machine = b.machine("m");
  b.state(machine, "only", b.clip("c"));
  b.transition(machine, 5, {.to = 0}, {});
  EXPECT_FALSE(b.build(machine));
}

TEST(check_graph, room_says_what_programs_need_at_most) {
  const GraphDefinition graph = *GraphDefinition::make(tables_of_all());
  EXPECT_EQ(graph.room().externals, 3u);
  EXPECT_EQ(graph.room().masks, 4u);
  EXPECT_EQ(graph.find_node("choice"), graph.find_node("choice"));
  EXPECT_EQ(graph.find_parameter("jump"), 1);
  EXPECT_EQ(graph.find_parameter("fly"), kNoGraphIndex);
}

TEST(check_graph, the_state_of_100_states_with_4_layers_of_4_fades_takes_1_kibibyte) {
  GraphBuilder b;
  const GraphIndex go = b.number("go");
  std::vector<GraphLayer> layers;
  GraphIndex base = 0;
  for (int m = 0; m < 4; ++m) {
    const GraphIndex machine = b.machine("machine");
    for (int i = 0; i < 25; ++i) b.state(machine, "state", b.clip("clip"));
    for (GraphIndex i = 0; i < 25; ++i)
      b.transition_from_any(machine, {.to = i}, {{static_cast<float>(i), go, GraphConditionKind::equal}});
    if (m == 0)
      base = machine;
    else
      layers.push_back({.node = machine});
  }
  const auto graph = b.build(b.layers("all", base, layers));
  ASSERT_TRUE(graph);
  EXPECT_LE(graph->state_bytes(), 1024u);
}

}  // namespace
}  // namespace sinew
