// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/graph/graph_nodes.h"
#include "runtime/sync/sync_group.h"

namespace sinew {

/// Something that a transition waits for. All conditions of a transition must hold at the same moment. Conditions on
/// parameters hold for a whole update or not at all. Conditions on time hold from an exact moment within the update.
enum class GraphConditionKind : std::uint8_t {
  above,          ///< number > value
  below,          ///< number < value
  equal,          ///< number == value
  not_equal,      ///< number != value
  on,             ///< flag
  off,            ///< not flag
  trigger,        ///< a trigger that no transition has used up yet
  time_in_state,  ///< at least `value` seconds since the state was entered
  played,         ///< the state's main clip has played at least `value` rounds; 1 is its end
  phase,          ///< the main clip passes phase `value`, in [0, 1), of a round at this moment
};

struct GraphCondition {
  float value = 0.0f;
  GraphIndex parameter = kNoGraphIndex;
  GraphConditionKind kind = GraphConditionKind::above;
};

/// Transitions that may interrupt a transition that is still fading. Every kind but `none` also allows transitions from
/// any state.
enum class GraphInterruption : std::uint8_t {
  none,
  source,              ///< transitions of the state that is left, as long as it plays
  target,              ///< transitions of the state that is entered
  source_then_target,  ///< both; at the same moment transitions of the source win
  target_then_source,
};

/// Share of the new pose as a function of u, the elapsed fraction of the fade.
enum class GraphFade : std::uint8_t {
  linear,    ///< u
  smooth,    ///< u^2 (3 - 2 u)
  smoother,  ///< u^3 (10 - 15 u + 6 u^2): no jump in acceleration
  ease_in,   ///< u^2
  ease_out,  ///< u (2 - u)
};

/// A key of a fade's own curve. Between keys the share is a cubic with these slopes.
struct GraphFadeKey {
  float at = 0.0f;     ///< elapsed fraction u of the fade
  float share = 0.0f;  ///< of the new pose
  float slope = 0.0f;  ///< d share / d u
};

/// The curve of a fade. Its first key is (0, 0), its last one (1, 1), and `at` increases. A cubic never leaves the
/// range of its two shares: both slopes have the sign of the secant and at most three times its size.
struct GraphFadeCurve {
  GraphIndex first_key = 0, key_count = 0;
};

/// How the new state starts and plays while the old one fades.
enum class GraphSync : std::uint8_t {
  none,
  start,   ///< it starts at a place that follows from the old state's main clip, by GraphTransition::start_by
  locked,  ///< as `start`; while they fade, both states play with the weighted mean of their lengths
};

/// How a transition gets from the old state to the new one.
enum class GraphTransitionKind : std::uint8_t {
  cross_fade,   ///< both play, mixed by `fade`
  inertialize,  ///< the new state plays at once; the old pose's offset and velocity decay (PoseOpKind::inertialize)
  dead_blend,   ///< the old pose moves on by its velocity and is mixed with the new state (PoseOpKind::dead_blend)
};

/// A transition. If several can be taken at the earliest moment, the smallest priority wins. Among equal priorities a
/// state's own transitions win over transitions from any state, then the last declared transition wins.
struct GraphTransition {
  float duration_s = 0.2f;  ///< finite, >= 0; 0 switches at once
  std::int32_t priority = 0;
  GraphIndex to = 0;                                    ///< state of the machine
  GraphIndex first_condition = 0, condition_count = 0;  ///< no conditions: taken at once
  GraphIndex curve = kNoGraphIndex;                     ///< of a cross-fade, instead of `fade`
  GraphFade fade = GraphFade::smooth;
  /// If the pose of some clip contains its root motion (GraphClip::root_in_pose), all kinds act as cross-fades. Such
  /// places differ by metres, and such an offset must not decay. Root motion and events follow the curve of the pose.
  GraphTransitionKind kind = GraphTransitionKind::cross_fade;
  GraphInterruption interruption = GraphInterruption::target;
  GraphSync sync = GraphSync::none;
  SyncStart start_by = SyncStart::phase;  ///< if `sync` is not none: same phase, same beat or same time left
  bool ordered = false;  ///< transitions of the source may only interrupt this one if their priority is smaller
  bool to_self = false;  ///< transition from any state: may also enter the active state and thus restart it
};

struct GraphMachineState {
  std::uint32_t name = 0;
  GraphIndex node = 0;
  GraphIndex first_transition = 0, transition_count = 0;
};

/// A state machine. At its start it takes the first entry rule that holds, else `initial`. Entry rules are transitions,
/// but only their target, priority and parameter conditions are used.
struct GraphMachine {
  GraphIndex first_state = 0, state_count = 0;
  GraphIndex first_any = 0, any_count = 0;      ///< transitions from any state
  GraphIndex first_entry = 0, entry_count = 0;  ///< transitions
  GraphIndex initial = 0;                       ///< state of the machine
  std::uint8_t fades = 4;  ///< fades at once, 0 to kMostGraphFades; a further fade drops the lightest state
};
inline constexpr std::uint8_t kMostGraphFades = 8;

/// For request_state instead of a state: enter the target of the transition with the smallest priority.
inline constexpr GraphIndex kNextState = 0xFFFE;

}  // namespace sinew
