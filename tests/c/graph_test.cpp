// SPDX-License-Identifier: MIT
// A motion graph from C: the same programs, events and root motion as from C++, and refusals that change nothing.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/c/graph/graph_handles.h"
#include "runtime/c/handles.h"
#include "runtime/graph/graph_builder.h"
#include "runtime/graph/graph_bytes.h"
#include "runtime/graph/update_graph.h"
#include "tests/c/engine_graph.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

constexpr double kWalk_s = 0.9, kRun_s = 0.6;

/// Walk and run in step, a jump over them, and a nod over all.
struct CGraph : testing::Test {
  CGraph() {
    GraphBuilder b;
    b.number("speed", 0.5f);
    const GraphIndex jump = b.trigger("jump");
    const std::vector<GraphBlendPoint> points = {{0, 0, b.clip("walk")}, {1, 0, b.clip("run")}};
    const GraphIndex body = b.machine("body");
    const GraphIndex ground = b.state(body, "ground", b.blend_space("gaits", {.x = 0}, points));
    const GraphIndex air = b.state(body, "air", b.clip("leap", {.loop = false}));
    b.transition(body, ground, {.to = air, .kind = GraphTransitionKind::inertialize}, {when_triggered(jump)});
    b.transition(body, air, {.to = ground}, {when_played(1)});
    GraphTables tables = b.tables(b.layers("all", body, std::vector{GraphLayer{.node = b.clip("nod"), .mask = 0}}));
    const auto text = [&](std::string_view name) {
      const auto offset = static_cast<std::uint32_t>(tables.names.size());
      tables.names.append(name).push_back('\0');
      return offset;
    };
    tables.masks = {{.name = text("head"), .first_joint = 0, .joint_count = 2}};
    const std::string_view first = scene.scene.skeleton.names[0], last = scene.scene.skeleton.names.back();
    tables.mask_joints = {{.name = text(first), .weight = 0.5f}, {.name = text(last), .weight = 1.0f, .below = false}};
    bytes = write_graph_bytes(tables);
    EXPECT_EQ(sinew_graph_create(bytes.data(), bytes.size(), &graph, nullptr), SINEW_OK);
    set_clips();
  }
  ~CGraph() override {
    sinew_graph_clips_destroy(clips);
    sinew_graph_destroy(graph);
  }

  void set_clips() {
    track.animation.translation = {
        Interpolation::linear, {0.0f, static_cast<float>(kWalk_s)}, {{0, 0, 0}, {0, 0, 1.2f}}};
    for (std::uint32_t c = 0; c < 4; ++c) {
      given[c] = {.struct_size = sizeof(sinew_graph_clip), .clip = c, .duration_s = c == 0 ? kWalk_s : kRun_s};
      given[c].event_times_s = {events.data(), events.size()};
    }
    given[0].root = &track;
    given[0].beats = walk_beats.data();
    given[1].beats = run_beats.data();
    given[0].beat_count = given[1].beat_count = 2;
    EXPECT_EQ(sinew_graph_clips_create(graph, given.data(), given.size(), nullptr, &clips), SINEW_OK);
  }

  sinew_scene scene{arm_scene()};
  sinew_root_track track{};
  std::vector<double> events = {0.1, 0.4};
  std::array<sinew_graph_beat, 2> walk_beats = {{{0.1, 0}, {0.6, 1}}}, run_beats = {{{0.3, 1}, {0.7, 0}}};
  std::array<sinew_graph_clip, 4> given{};
  std::vector<std::byte> bytes;
  sinew_graph* graph = nullptr;
  sinew_graph_clips* clips = nullptr;
};

TEST_F(CGraph, plays_as_in_cpp) {
  auto walker = std::make_unique<engine_walker>();
  ASSERT_EQ(engine_start_walker(graph, clips, walker.get()), SINEW_OK);
  std::vector<float> parameters = {0.5f, 0.0f};
  std::vector<std::uint64_t> state(graph->definition.state_bytes() / 8);
  const auto state_bytes = std::as_writable_bytes(std::span(state));
  PoseProgram program;
  GraphStep step;
  std::vector<GraphEvent> log(engine_most_events);
  ASSERT_EQ(run(StartGraphJob{&graph->definition, &clips->set, parameters, state_bytes}), ErrorCode::ok);
  DualQuatd world;
  std::size_t told = 0, longest = 0;
  for (int frame = 0; frame < 90; ++frame) {
    if (frame == 40) {
      EXPECT_EQ(sinew_graph_set_trigger(graph, walker->state.bytes, engine_state_bytes, 1, 1), SINEW_OK);
      EXPECT_EQ(set_trigger(graph->definition, state_bytes, 1), ErrorCode::ok);
    }
    ASSERT_EQ(engine_move_walker(graph, clips, 1.0 / 60.0, walker.get()), SINEW_OK);
    ASSERT_EQ(
        run(UpdateGraphJob{&graph->definition, &clips->set, parameters, state_bytes, 1.0 / 60.0, &program, log, &step}),
        ErrorCode::ok);
    world = normalised(world * step.root_motion);
    ASSERT_EQ(walker->op_count, program.ops().size());
    EXPECT_EQ(std::memcmp(walker->ops, program.ops().data(), program.ops().size_bytes()), 0);
    ASSERT_EQ(walker->event_count, step.event_count);
    for (std::size_t e = 0; e < step.event_count; ++e) {
      EXPECT_EQ(walker->events[e].time_s, seconds_of(log[e].at));
      EXPECT_EQ(walker->events[e].index, log[e].index);
      EXPECT_EQ(walker->events[e].clip == SINEW_NONE, log[e].kind == GraphEventKind::state);
    }
    told += step.event_count;
    longest = std::max(longest, walker->op_count);
  }
  EXPECT_EQ(std::memcmp(&walker->world, &world, sizeof(world)), 0);
  EXPECT_GT(told, 8u);
  EXPECT_GT(longest, 6u);
}

TEST_F(CGraph, a_copy_of_the_state_plays_again) {
  auto walker = std::make_unique<engine_walker>(), saved = std::make_unique<engine_walker>();
  ASSERT_EQ(engine_start_walker(graph, clips, walker.get()), SINEW_OK);
  ASSERT_EQ(engine_move_walker(graph, clips, 0.7, walker.get()), SINEW_OK);
  EXPECT_EQ(sinew_graph_request_state(graph, walker->state.bytes, engine_state_bytes,
                                      sinew_graph_find(graph, SINEW_GRAPH_NODE, "body"), 1),
            SINEW_OK);
  *saved = *walker;
  ASSERT_EQ(engine_move_walker(graph, clips, 0.1, walker.get()), SINEW_OK);
  ASSERT_EQ(engine_move_walker(graph, clips, 0.1, saved.get()), SINEW_OK);
  EXPECT_EQ(std::memcmp(walker.get(), saved.get(), sizeof(engine_walker)), 0);
}

TEST_F(CGraph, carries_a_character_into_another_version) {
  auto walker = std::make_unique<engine_walker>(), other = std::make_unique<engine_walker>();
  ASSERT_EQ(engine_start_walker(graph, clips, walker.get()), SINEW_OK);
  ASSERT_EQ(engine_start_walker(graph, clips, other.get()), SINEW_OK);
  ASSERT_EQ(engine_move_walker(graph, clips, 0.7, walker.get()), SINEW_OK);
  const auto carry = [&](std::size_t from_bytes) {
    return sinew_graph_carry(graph, walker->state.bytes, from_bytes, graph, clips, walker->parameters, 2,
                             other->state.bytes, engine_state_bytes);
  };
  EXPECT_EQ(carry(8), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(carry(engine_state_bytes), SINEW_OK);
  ASSERT_EQ(engine_move_walker(graph, clips, 0.1, walker.get()), SINEW_OK);
  ASSERT_EQ(engine_move_walker(graph, clips, 0.1, other.get()), SINEW_OK);
  ASSERT_EQ(walker->op_count, other->op_count);
  EXPECT_EQ(std::memcmp(walker->ops, other->ops, walker->op_count * sizeof(sinew_pose_op)), 0);
  std::memset(walker->state.bytes, 0, engine_state_bytes);
  EXPECT_EQ(carry(engine_state_bytes), SINEW_WRONG_PLAN);
  EXPECT_EQ(sinew_graph_carry(graph, nullptr, 0, graph, clips, nullptr, 0, other->state.bytes, engine_state_bytes),
            SINEW_NULL_ARGUMENT);
}

TEST_F(CGraph, tells_its_names_sizes_and_masks) {
  const auto name = [&](std::uint32_t thing, std::uint32_t index) {
    const sinew_string found = sinew_graph_name(graph, thing, index);
    return std::string(found.data == nullptr ? "" : found.data, found.length);
  };
  EXPECT_EQ(name(SINEW_GRAPH_PARAMETER, 1), "jump");
  EXPECT_EQ(name(SINEW_GRAPH_CLIP, 2), "leap");
  EXPECT_EQ(name(SINEW_GRAPH_MASK, 0), "head");
  EXPECT_EQ(name(SINEW_GRAPH_MASK, 1), "");
  EXPECT_EQ(name(99, 0), "");
  EXPECT_EQ(sinew_graph_find(graph, SINEW_GRAPH_CLIP, "run"), 1u);
  EXPECT_EQ(sinew_graph_find(graph, SINEW_GRAPH_CLIP, "swim"), SINEW_NONE);
  const std::uint32_t body = sinew_graph_find(graph, SINEW_GRAPH_NODE, "body");
  EXPECT_EQ(sinew_graph_find_state(graph, body, "air"), 1u);
  EXPECT_EQ(sinew_graph_find_state(graph, 0, "air"), SINEW_NONE);
  EXPECT_EQ(sinew_graph_initial(graph, 0), 0.5f);
  sinew_program_room room{.struct_size = sizeof(room)};
  EXPECT_EQ(sinew_graph_get_room(graph, &room), SINEW_OK);
  EXPECT_EQ(room.ops, graph->definition.room().ops);
  const std::size_t joints = scene.scene.skeleton.joint_count();
  std::vector<float> weights(joints, -1.0f);
  EXPECT_EQ(sinew_graph_mask(graph, 0, &scene, weights.data(), joints), SINEW_OK);
  EXPECT_EQ(weights.front(), 0.5f);
  EXPECT_EQ(weights.back(), 1.0f);
  EXPECT_EQ(sinew_graph_mask(graph, 1, &scene, weights.data(), joints), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_graph_mask(graph, 0, &scene, weights.data(), joints - 1), SINEW_SIZE_MISMATCH);
  std::vector<std::byte> again(sinew_graph_write(graph, nullptr, 0));
  EXPECT_EQ(sinew_graph_write(graph, again.data(), again.size()), bytes.size());
  EXPECT_EQ(again, bytes);
}

TEST_F(CGraph, refuses_bytes_that_are_no_graph) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    sinew_graph* none = nullptr;
    sinew_messages* messages = nullptr;
    EXPECT_EQ(sinew_graph_create(bytes.data(), size, &none, &messages), SINEW_BAD_FILE) << size;
    EXPECT_EQ(sinew_message_count(messages), 1u);
    sinew_messages_destroy(messages);
  }
  // A changed byte gives another graph or a refusal, never a crash.
  std::size_t refused = 0;
  for (std::size_t place = 0; place < bytes.size(); ++place) {
    std::vector<std::byte> changed = bytes;
    changed[place] ^= std::byte{0x55};
    sinew_graph* other = nullptr;
    refused += sinew_graph_create(changed.data(), changed.size(), &other, nullptr) == SINEW_BAD_FILE;
    sinew_graph_destroy(other);
  }
  EXPECT_GT(refused, bytes.size() / 4);
  EXPECT_EQ(sinew_graph_create(nullptr, 0, &graph, nullptr), SINEW_NULL_ARGUMENT);
}

TEST_F(CGraph, misuse_is_refused_and_changes_nothing) {
  auto walker = std::make_unique<engine_walker>();
  ASSERT_EQ(engine_start_walker(graph, clips, walker.get()), SINEW_OK);
  const engine_walker before = *walker;
  sinew_graph_step step{.struct_size = sizeof(step), .ops = walker->ops};
  void* const state = walker->state.bytes;
  float* const p = walker->parameters;
  const auto update = [&](const float* parameters, std::size_t count, std::size_t bytes_given, double dt_s) {
    return sinew_graph_update(graph, clips, parameters, count, state, bytes_given, dt_s, &step);
  };
  EXPECT_EQ(update(p, 1, engine_state_bytes, 0.1), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(update(nullptr, 2, engine_state_bytes, 0.1), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(update(p, 2, 8, 0.1), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(update(p, 2, engine_state_bytes, 1e9), SINEW_TOO_LARGE);
  step.ops = nullptr;
  EXPECT_EQ(update(p, 2, engine_state_bytes, 0.1), SINEW_NULL_ARGUMENT);
  step = {.struct_size = 8, .ops = walker->ops};
  EXPECT_EQ(update(p, 2, engine_state_bytes, 0.1), SINEW_WRONG_STRUCT_SIZE);
  step = {.struct_size = sizeof(step), .ops = walker->ops, .event_room = 1};
  EXPECT_EQ(update(p, 2, engine_state_bytes, 0.1), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_graph_set_trigger(graph, state, engine_state_bytes, 0, 1), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_graph_set_trigger(graph, nullptr, 0, 1, 1), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_graph_request_state(graph, state, engine_state_bytes, 0, 1), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(std::memcmp(&before, walker.get(), sizeof(before)), 0);
  sinew_graph_clips* none = nullptr;
  EXPECT_EQ(sinew_graph_clips_create(graph, given.data(), 3, nullptr, &none), SINEW_SIZE_MISMATCH);
  given[0].struct_size = 4;
  EXPECT_EQ(sinew_graph_clips_create(graph, given.data(), 4, nullptr, &none), SINEW_WRONG_STRUCT_SIZE);
  given[0].struct_size = sizeof(given[0]);
  walk_beats[0].phase = 0.7;
  EXPECT_EQ(sinew_graph_clips_create(graph, given.data(), 4, nullptr, &none), SINEW_TIMES_NOT_INCREASING);
  EXPECT_EQ(none, nullptr);
}

}  // namespace
}  // namespace sinew::test
