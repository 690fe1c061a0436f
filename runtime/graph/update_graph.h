// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/graph/graph_clips.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/graph/graph_time.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew {

enum class GraphEventKind : std::uint8_t { clip, state };

/// An event of an update.
struct GraphEvent {
  GraphTicks at = 0;                ///< time on the graph's clock, which starts at 0
  GraphIndex node = 0;              ///< clip node or blend space that plays the clip, or the machine
  GraphIndex clip = kNoGraphIndex;  ///< index into GraphTables::clip_names
  std::uint32_t index = 0;          ///< index of the clip's event, or of the machine's state that is entered
  float weight = 1.0f;              ///< weight of the clip in the pose at that moment
  GraphEventKind kind = GraphEventKind::clip;

  friend bool operator==(const GraphEvent&, const GraphEvent&) = default;
};

/// The outcome of an update.
struct GraphStep {
  DualQuatd root_motion;  ///< world = normalised(world * root_motion)
  DualQuatd root_place;   ///< FrameInput::root = world * inverse of root_place
  std::uint32_t event_count = 0;
  std::uint64_t events_left_out = 0;  ///< events not written: `events` was full, or a clip played over 1,024 rounds
  bool transitions_left_out = false;  ///< the update has taken kMostGraphTransitions and takes no more
};

inline constexpr double kMostGraphStep_s = 3600.0;
inline constexpr std::uint32_t kMostGraphTransitions = 16384;

/// Writes the start state of a character: machines enter their first states.
/// in   parameters[P]  entry rules read them;   state  8-byte aligned, GraphDefinition::state_bytes
/// err  size_mismatch, not_finite
struct StartGraphJob {
  const GraphDefinition* graph = nullptr;
  const GraphClipSet* clips = nullptr;
  std::span<const float> parameters;  ///< GraphParameter::initial, or values of the caller
  std::span<std::byte> state;
};
SINEW_API ErrorCode check(const StartGraphJob& job) noexcept;
SINEW_API void run_unchecked(const StartGraphJob& job) noexcept;

/// Plays a character's graph for a time step, and writes the program of its pose.
/// The state is plain bytes: a copy of it restores the character. The step is cut into pieces where a transition is
/// taken or a fade ends, so results do not depend on how time is cut into steps. Parameters hold for the whole step.
/// Backwards (dt_s < 0) clips play backwards, fades and times in states stand still, and no transition is taken. Root
/// motion of several clips has their weighted mean velocity, which is constant in cells of 1/60 s of the graph's clock.
/// in   dt_s  from -kMostGraphStep_s to kMostGraphStep_s
/// out  program  cleared first;   events  in the order of time;   step
/// err  size_mismatch (parameters, state, clips), wrong_plan (a state of another graph), not_finite, too_large (dt_s)
/// cost O(what plays + transitions of active states), no allocation; nodes that do not play are not visited
struct UpdateGraphJob {
  const GraphDefinition* graph = nullptr;
  const GraphClipSet* clips = nullptr;
  std::span<const float> parameters;
  std::span<std::byte> state;
  double dt_s = 0.0;
  PoseProgram* program = nullptr;
  std::span<GraphEvent> events = {};
  GraphStep* step = nullptr;
};
SINEW_API ErrorCode check(const UpdateGraphJob& job) noexcept;
SINEW_API void run_unchecked(const UpdateGraphJob& job) noexcept;

/// Sets a trigger. It stays set until a transition uses it up. Several machines may use it at the same moment.
/// err  index_out_of_range (no such trigger), wrong_plan
SINEW_API ErrorCode set_trigger(const GraphDefinition& graph, std::span<std::byte> state,
                                GraphIndex parameter) noexcept;
SINEW_API ErrorCode reset_trigger(const GraphDefinition& graph, std::span<std::byte> state,
                                  GraphIndex parameter) noexcept;

/// Makes a machine enter a state at the next update, regardless of conditions, if the machine plays then.
/// in   machine  node;   target  state of the machine, or kNextState
/// err  index_out_of_range, wrong_plan
SINEW_API ErrorCode request_state(const GraphDefinition& graph, std::span<std::byte> state, GraphIndex machine,
                                  GraphIndex target) noexcept;

}  // namespace sinew
