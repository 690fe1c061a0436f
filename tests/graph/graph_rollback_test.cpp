// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <vector>

#include "tests/graph/graph_player.h"

namespace sinew {
namespace {

using test::GraphPlayer;

/// One update: what the player and the network set, and how long it is.
struct Input {
  double dt_s;
  float speed;
  bool go, jump;
};

rc::Gen<Input> any_input() {
  return rc::gen::map(rc::gen::tuple(rc::gen::inRange(-40, 400), rc::gen::inRange(-10, 50), rc::gen::arbitrary<bool>(),
                                     rc::gen::inRange(0, 8)),
                      [](const auto& values) {
                        const auto [ms, speed, go, jump] = values;
                        return Input{ms * 0.00137, static_cast<float>(speed) * 0.1f, go, jump == 0};
                      });
}

/// Two layers of machines, a blend space, a nested machine and root motion.
class Character {
 public:
  Character() : player_(make()) {}

  void play(const std::vector<Input>& inputs) {
    for (const Input& input : inputs) {
      player_.set(speed_, input.speed);
      player_.set(go_, input.go ? 1.0f : 0.0f);
      if (input.jump) player_.trigger(jump_);
      player_.advance(input.dt_s);
      programs_.insert(programs_.end(), player_.ops().begin(), player_.ops().end());
      roots_.push_back(player_.step().root_motion);
    }
  }

  struct Past {
    std::vector<std::byte> state;
    std::vector<GraphEvent> log;
    std::vector<PoseOp> programs;
    std::vector<DualQuatd> roots;
  };
  Past take() {
    const auto bytes = player_.state();
    Past past{{bytes.begin(), bytes.end()}, player_.log(), programs_, roots_};
    return past;
  }
  void restore(const std::vector<std::byte>& state) { std::memcpy(player_.state().data(), state.data(), state.size()); }

 private:
  GraphPlayer make() {
    BoneAnimation forward;
    forward.translation = {Interpolation::linear, {0.0f, 0.4f, 1.0f}, {{0, 0, 0}, {0.1f, 0, 1}, {0, 0, 2}}};
    root_ = RootTrack::make(forward, {}, {}, 1e-5);
    GraphBuilder b;
    speed_ = b.number("speed");
    go_ = b.flag("go");
    jump_ = b.trigger("jump");
    const std::vector<GraphBlendPoint> points = {{0, 0, b.clip("idle")}, {1, 0, b.clip("walk")}, {3, 0, b.clip("run")}};
    const GraphIndex gaits = b.blend_space("gaits", {.x = speed_}, points);
    const GraphIndex air = b.machine("air");
    const GraphIndex up = b.state(air, "up", b.clip("up", {.loop = false}));
    const GraphIndex down = b.state(air, "down", b.clip("down"));
    b.transition(air, up, {.duration_s = 0.1f, .to = down}, {when_played(0.8f)});
    const GraphIndex body = b.machine("body", {.fades = 2});
    const GraphIndex ground = b.state(body, "ground", gaits);
    const GraphIndex flying = b.state(body, "flying", air);
    const GraphIndex crouch = b.state(body, "crouch", b.clip("crouch", {.speed_parameter = speed_, .mirror = true}));
    b.transition(body, ground, {.to = flying, .interruption = GraphInterruption::source_then_target},
                 {when_triggered(jump_)});
    b.transition(body, flying, {.duration_s = 0.3f, .to = ground, .sync = GraphSync::locked},
                 {when_in_state_for(0.4f)});
    b.transition(body, ground, {.to = crouch, .sync = GraphSync::start}, {when_on(go_), when_at_phase(0.5f)});
    b.transition_from_any(body, {.priority = -1, .to = ground}, {when_off(go_), when_above(speed_, 3.5f)});
    const GraphIndex arms = b.machine("arms");
    const GraphIndex rest = b.state(arms, "rest", b.clip("rest"));
    const GraphIndex wave = b.state(arms, "wave", b.clip("wave"));
    b.transition(arms, rest, {.duration_s = 0.5f, .to = wave}, {when_on(go_)});
    b.transition(arms, wave, {.duration_s = 0.5f, .to = rest}, {when_off(go_)});
    const GraphLayer layer{.node = arms, .weight_parameter = speed_, .mask = 0};
    const GraphIndex root = b.layers("all", body, std::vector{layer});
    std::vector<GraphClip> clips;
    for (std::uint32_t c = 0; c < 8; ++c)
      clips.push_back({c, 1.0 + 0.1 * c, times_, c == 1 || c == 2 ? &root_ : nullptr});
    return GraphPlayer(b, root, clips);
  }

  GraphIndex speed_ = 0, go_ = 0, jump_ = 0;
  RootTrack root_;
  std::vector<double> times_ = {0.0, 0.25, 0.7};
  GraphPlayer player_;
  std::vector<PoseOp> programs_;
  std::vector<DualQuatd> roots_;
};

bool same_bits(const std::vector<DualQuatd>& a, const std::vector<DualQuatd>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(DualQuatd)) == 0;
}

RC_GTEST_PROP(graph_rollback, a_copied_state_plays_the_same_bits_again, ()) {
  const auto first = *rc::gen::container<std::vector<Input>>(100, any_input());
  const auto second = *rc::gen::container<std::vector<Input>>(100, any_input());
  Character lived;
  lived.play(first);
  const auto saved = lived.take();
  lived.play(second);
  const auto once = lived.take();
  lived.restore(saved.state);
  lived.play(second);
  const auto twice = lived.take();
  Character other;  // that has never lived through the first inputs
  other.restore(saved.state);
  other.play(second);
  const auto elsewhere = other.take();

  RC_ASSERT(once.state == twice.state);
  RC_ASSERT(once.state == elsewhere.state);
  const auto tail = [](const auto& all, std::size_t from) {
    return std::decay_t<decltype(all)>(all.begin() + static_cast<std::ptrdiff_t>(from), all.end());
  };
  RC_ASSERT(tail(once.programs, saved.programs.size()) == elsewhere.programs);
  RC_ASSERT(tail(once.log, saved.log.size()) == elsewhere.log);
  RC_ASSERT(tail(twice.log, once.log.size()) == elsewhere.log);
  RC_ASSERT(same_bits(tail(once.roots, saved.roots.size()), elsewhere.roots));
}

RC_GTEST_PROP(graph_rollback, programs_of_all_inputs_are_sound, ()) {
  const auto inputs = *rc::gen::container<std::vector<Input>>(100, any_input());
  Character character;
  for (const Input& input : inputs) {
    character.play({input});
    const auto past = character.take();
    RC_ASSERT(!past.programs.empty());
  }
  for (const PoseOp& op : character.take().programs) {
    RC_ASSERT(op.weight >= 0.0f && op.weight <= 5.0f);
    RC_ASSERT(op.time_s >= 0.0 && op.time_s <= 2.0);
  }
}

}  // namespace
}  // namespace sinew
