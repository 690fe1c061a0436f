// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/graph/graph_nodes.h"

namespace sinew {

/// Something that a transition waits for. All conditions of a transition must hold at one moment. Values of parameters
/// hold for a whole update; conditions of time hold from an exact moment within it.
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
  phase,          ///< the moment, in each round, where the main clip passes `value` in [0, 1)
};

struct GraphCondition {
  float value = 0.0f;
  GraphIndex parameter = kNoGraphIndex;
  GraphConditionKind kind = GraphConditionKind::above;
};

/// The transitions that may interrupt a transition that is still fading. With all but `none`, transitions from any
/// state may, too.
enum class GraphInterruption : std::uint8_t {
  none,
  source,              ///< transitions of the state that is left, as long as it plays
  target,              ///< transitions of the state that is entered
  source_then_target,  ///< both; at the same moment those of the source win
  target_then_source,
};

/// Share of the new pose by the fraction u of the fade.
enum class GraphFade : std::uint8_t {
  linear,    ///< u
  smooth,    ///< u^2 (3 - 2 u)
  smoother,  ///< u^3 (10 - 15 u + 6 u^2): no jump in acceleration
  ease_in,   ///< u^2
  ease_out,  ///< u (2 - u)
};

/// How the new state starts and plays while the old one fades.
enum class GraphSync : std::uint8_t {
  none,
  start,   ///< it starts at the phase of the old state's main clip
  locked,  ///< as start, and both play with the weighted mean of their lengths while they fade
};

/// How a transition gets from the old state to the new one.
enum class GraphTransitionKind : std::uint8_t {
  cross_fade,   ///< both play, mixed by `fade`
  inertialize,  ///< the new state plays at once; the old pose's offset and velocity decay (PoseOpKind::inertialize)
  dead_blend,   ///< the old pose goes on by its velocity and is mixed with the new state (PoseOpKind::dead_blend)
};

/// A transition. Of those that can be taken at the earliest moment the smallest priority wins. Among equal ones a
/// state's own come before those of any state, and the last declared wins.
struct GraphTransition {
  float duration_s = 0.2f;  ///< finite, >= 0; 0 cuts
  std::int32_t priority = 0;
  GraphIndex to = 0;                                    ///< state of the machine
  GraphIndex first_condition = 0, condition_count = 0;  ///< none: at once
  GraphFade fade = GraphFade::smooth;
  /// Where clips move the character, all kinds are cross-fades: their places differ by metres, which must not decay.
  GraphTransitionKind kind = GraphTransitionKind::cross_fade;
  GraphInterruption interruption = GraphInterruption::target;
  GraphSync sync = GraphSync::none;
  bool ordered = false;  ///< of the source's transitions only those with a smaller priority may interrupt this one
  bool to_self = false;  ///< of any state: may enter the state that is active, and so start it anew
};

struct GraphMachineState {
  std::uint32_t name = 0;
  GraphIndex node = 0;
  GraphIndex first_transition = 0, transition_count = 0;
};

/// A state machine. A machine that starts takes the first entry rule that holds, or else `initial`. Entry rules are
/// transitions of which only target, priority and conditions of parameters count.
struct GraphMachine {
  GraphIndex first_state = 0, state_count = 0;
  GraphIndex first_any = 0, any_count = 0;      ///< transitions from any state
  GraphIndex first_entry = 0, entry_count = 0;  ///< transitions
  GraphIndex initial = 0;                       ///< state of the machine
  std::uint8_t fades = 4;  ///< fades at once, 0 to kMostGraphFades; one more leaves out the state that weighs least
};
inline constexpr std::uint8_t kMostGraphFades = 8;

/// In place of a state, for request_state: the target of the transition of smallest priority.
inline constexpr GraphIndex kNextState = 0xFFFE;

}  // namespace sinew
