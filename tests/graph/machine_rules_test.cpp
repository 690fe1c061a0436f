// SPDX-License-Identifier: MIT
// State machines beside rules that are written plainly, and cases of another engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "tests/graph/graph_player.h"
#include "tests/graph/plain_machine.h"
#include "tests/support/corpus.h"
#include "tests/support/fixed_random.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

constexpr int kFlags = 3;

PlainMachine any_machine(FixedRandom& random) {
  PlainMachine m;
  const std::uint32_t count = 2 + random.below(4);
  for (std::uint32_t s = 0; s < count; ++s) m.states.push_back({static_cast<int>(20 + 20 * random.below(10))});
  m.flags.assign(kFlags, false);
  // A ring, so that each state is reached, and more at random.
  const std::uint32_t arrows = count + random.below(8);
  for (std::uint32_t i = 0; i < arrows; ++i) {
    PlainMachine::Transition t;
    t.from = i < count ? static_cast<int>(i) : static_cast<int>(random.below(count + 1)) - 1;
    t.to = i < count ? static_cast<int>((i + 1) % count) : static_cast<int>(random.below(count));
    if (t.from == t.to) continue;
    t.duration = static_cast<int>(10 * random.below(20));
    t.priority = static_cast<int>(random.below(4));
    t.by = static_cast<PlainMachine::By>(random.below(5));
    t.ordered = random.below(3) == 0;
    using Kind = PlainMachine::Condition::Kind;
    const std::uint32_t conditions = i < count ? 1 + random.below(2) : 1 + random.below(3);
    bool has_phase = false;
    for (std::uint32_t c = 0; c < conditions; ++c) {
      auto kind = static_cast<Kind>(random.below(5));
      if (kind == Kind::phase && (has_phase || t.from < 0)) kind = Kind::on;
      if (kind == Kind::played && t.from < 0) kind = Kind::off;
      has_phase |= kind == Kind::phase;
      const int length = t.from < 0 ? 0 : m.states[static_cast<std::size_t>(t.from)].length;
      int value = static_cast<int>(random.below(kFlags));
      if (kind == Kind::in_state) value = static_cast<int>(5 * random.below(60));
      if (kind == Kind::played) value = length / 4 * static_cast<int>(random.below(9));
      if (kind == Kind::phase) value = length / 4 * static_cast<int>(random.below(4));
      t.conditions.push_back({kind, value});
    }
    m.transitions.push_back(t);
  }
  return m;
}

GraphCondition condition_of(const PlainMachine::Condition& c, int length) {
  using Kind = PlainMachine::Condition::Kind;
  const auto fraction = [&] { return static_cast<float>(c.value) / static_cast<float>(length); };
  switch (c.kind) {
    case Kind::on: return when_on(static_cast<GraphIndex>(c.value));
    case Kind::off: return when_off(static_cast<GraphIndex>(c.value));
    case Kind::in_state: return when_in_state_for(static_cast<float>(c.value * 0.001));
    case Kind::played: return when_played(fraction());
    case Kind::phase: break;
  }
  return when_at_phase(fraction());
}

GraphPlayer player_of(const PlainMachine& m) {
  GraphBuilder b;
  for (int f = 0; f < kFlags; ++f) b.flag("flag" + std::to_string(f));
  const GraphIndex machine = b.machine("m", {.fades = 8});
  std::vector<GraphClip> clips;
  for (std::size_t s = 0; s < m.states.size(); ++s) {
    b.state(machine, "state", b.clip("clip" + std::to_string(s)));
    clips.push_back({static_cast<std::uint32_t>(s), m.states[s].length * 0.001});
  }
  for (const PlainMachine::Transition& t : m.transitions) {
    const int length = t.from < 0 ? 1 : m.states[static_cast<std::size_t>(t.from)].length;
    std::vector<GraphCondition> conditions;
    for (const auto& c : t.conditions) conditions.push_back(condition_of(c, length));
    const GraphTransition settings{.duration_s = static_cast<float>(t.duration * 0.001),
                                   .priority = t.priority,
                                   .to = static_cast<GraphIndex>(t.to),
                                   .interruption = static_cast<GraphInterruption>(t.by),
                                   .ordered = t.ordered};
    if (t.from < 0)
      b.transition_from_any(machine, settings, conditions);
    else
      b.transition(machine, static_cast<GraphIndex>(t.from), settings, conditions);
  }
  return GraphPlayer(b, machine, clips);
}

TEST(machine_rules, are_those_of_the_plain_machine) {
  FixedRandom random(40);
  std::size_t entered = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    PlainMachine plain = any_machine(random);
    GraphPlayer player = player_of(plain);
    for (int step = 0; step < 30; ++step) {
      const std::uint32_t flag = random.below(kFlags);
      const bool on = random.below(2) == 0;
      plain.flags[flag] = on;
      player.set(static_cast<GraphIndex>(flag), on ? 1.0f : 0.0f);
      const int ms = static_cast<int>(1 + random.below(80));
      plain.advance(ms);
      player.advance(ms * 0.001);
    }
    // From the ninth fade at once on the player forgets states, and with them what may interrupt.
    std::size_t sure = plain.log.size();
    for (std::size_t i = plain.log.size(); i-- > 8;)
      if (plain.log[i].at - plain.log[i - 8].at < 200) sure = i;
    if (sure == plain.log.size()) {
      ASSERT_EQ(player.log().size(), plain.log.size()) << trial;
    }
    ASSERT_GE(player.log().size(), sure) << trial;
    for (std::size_t i = 0; i < sure; ++i) {
      ASSERT_EQ(player.log()[i].index, static_cast<std::uint32_t>(plain.log[i].state)) << trial << ' ' << i;
      ASSERT_EQ(player.log()[i].at, GraphTicks{plain.log[i].at} * (kTicksPerSecond / 1000)) << trial << ' ' << i;
    }
    entered += sure;
  }
  EXPECT_GT(entered, 20000u);
}

/// Runs one case of the corpus: transitions of "at_end", "immediate" and "sync", and a script.
void expect_case(const Json& test, bool reversed) {
  GraphBuilder b;
  const GraphIndex machine = b.machine("m");
  const std::string names = "ABC";
  for (const char name : names) b.state(machine, std::string(1, name), b.clip(std::string(1, name)));
  std::vector<std::string> flags;
  std::vector<Json> arrows = test["t"];
  if (reversed) std::reverse(arrows.begin(), arrows.end());
  for (const Json& t : arrows) {
    std::vector<GraphCondition> conditions;
    if (t[2] == "at_end") conditions.push_back(when_played(1));
    if (!t[4].is_null()) {
      const std::string flag = t[4];
      auto found = std::find(flags.begin(), flags.end(), flag);
      if (found == flags.end()) {
        b.flag(flag);
        found = flags.insert(flags.end(), flag);
      }
      conditions.push_back(when_on(static_cast<GraphIndex>(found - flags.begin())));
    }
    const auto state = [&](const Json& name) { return static_cast<GraphIndex>(names.find(name.get<std::string>())); };
    b.transition(machine, state(t[0]),
                 {.duration_s = 0.0f,
                  .priority = t[3],
                  .to = state(t[1]),
                  .sync = t[2] == "sync" ? GraphSync::start : GraphSync::none},
                 conditions);
  }
  // Some cases have states that nothing leads to.
  const GraphIndex never = b.flag("never");
  for (GraphIndex s = 0; s < 3; ++s) b.transition_from_any(machine, {.priority = 99, .to = s}, {when_on(never)});
  GraphPlayer player(b, machine, {{0, 2.0}, {1, 2.0}, {2, 2.0}});
  for (const Json& step : test["script"]) {
    if (step[0] == "set") {
      player.set(player.graph().find_parameter(step[1].get<std::string>()), 1.0f);
    } else if (step[0] == "next") {
      ASSERT_EQ(request_state(player.graph(), player.state(), machine, kNextState), ErrorCode::ok);
    } else {
      player.advance(0.1, static_cast<int>(std::lround(step[1].get<double>() / 0.1)));
      EXPECT_EQ(player.active(), step[2].get<std::string>()) << test["name"];
    }
  }
}

TEST(machine_rules_corpus, priorities_are_those_of_the_cases) {
  const auto folder = corpus();
  if (!folder) GTEST_SKIP() << "no corpus";
  std::size_t cases = 0;
  for (const auto& file : corpus_files("motion", {".json"})) {
    std::ifstream stream(file);
    const Json all = Json::parse(stream, nullptr, false);
    if (!all.is_object() || !all.contains("states") || !all.contains("cases")) continue;
    for (const Json& test : all["cases"]) {
      expect_case(test, false);
      if (test.value("both_orders", false)) expect_case(test, true);
      ++cases;
    }
  }
  EXPECT_GE(cases, 6u);
}

}  // namespace
}  // namespace sinew::test
