// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace sinew::test {

/// The rules of state machines, written plainly: each millisecond looks at every transition. Times are whole
/// milliseconds. It knows no fades of more than two states, since rules do not depend on them.
struct PlainMachine {
  enum class By { none, source, target, source_then_target, target_then_source };

  struct Condition {
    enum class Kind { on, off, in_state, played, phase } kind;
    int value = 0;  ///< a flag, or milliseconds; phase: milliseconds in the round
  };
  struct Transition {
    int from, to, duration, priority;  ///< from -1: any state
    By by;
    bool ordered;
    std::vector<Condition> conditions;
  };
  struct State {
    int length;  ///< of its clip
  };
  struct Entered {
    int at, state;
    bool operator==(const Entered&) const = default;
  };

  static constexpr int kOfSource = 1, kNeverGone = 1 << 30;

  std::vector<State> states;
  std::vector<Transition> transitions;
  std::vector<bool> flags;

  int now = 0, current = 0, source = -1, current_since = 0, source_since = 0, source_gone = kNeverGone;
  int by = -1;  ///< transition that led to the current state
  bool has_entered = false;
  std::vector<Entered> log;

  bool fades() const { return by >= 0 && now - current_since < transitions[static_cast<std::size_t>(by)].duration; }

  bool holds(const Condition& c, int state, int since) const {
    const int time = now - since;
    switch (c.kind) {
      case Condition::Kind::on: return flags[static_cast<std::size_t>(c.value)];
      case Condition::Kind::off: return !flags[static_cast<std::size_t>(c.value)];
      case Condition::Kind::in_state:
      case Condition::Kind::played: return time >= c.value;
      case Condition::Kind::phase: return time % states[static_cast<std::size_t>(state)].length == c.value;
    }
    return false;
  }

  /// The candidate of smallest (rank, priority); own transitions before those of any state, later ones first.
  void look() {
    if (has_entered && now - current_since < 1) return;
    const bool fading = fades();
    const By may = fading ? transitions[static_cast<std::size_t>(by)].by : By::target;
    int best = -1, best_rank = 0, best_order = 0;
    const auto offer = [&](std::size_t i, int state, int since, int rank, int order) {
      const Transition& t = transitions[i];
      for (const Condition& c : t.conditions)
        if (!holds(c, state, since)) return;
      if (best >= 0) {
        const Transition& b = transitions[static_cast<std::size_t>(best)];
        const auto worse = [&] {
          if (rank != best_rank) return rank > best_rank;
          if (t.priority != b.priority) return t.priority > b.priority;
          return order < best_order;
        };
        if (worse()) return;
      }
      best = static_cast<int>(i);
      best_rank = rank;
      best_order = order;
    };
    for (std::size_t i = 0; i < transitions.size(); ++i) {
      const Transition& t = transitions[i];
      if (t.from == -1 && t.to != current && may != By::none) offer(i, current, current_since, 0, 0);
      if (fading && now < source_gone && t.from == source && t.to != current && may != By::none && may != By::target) {
        const Transition& running = transitions[static_cast<std::size_t>(by)];
        if (!running.ordered || t.priority < running.priority)
          offer(i, source, source_since, may == By::target_then_source ? 1 : 0, kOfSource);
      }
      if (t.from == current && may != By::none && may != By::source)
        offer(i, current, current_since, may == By::source_then_target ? 1 : 0, 2);
    }
    if (best < 0) return;
    if (best_order == kOfSource) {  // the source stays, and is gone when the fade that is interrupted would have ended
      source_gone = std::min(source_gone, current_since + transitions[static_cast<std::size_t>(by)].duration);
    } else {
      source = current;
      source_since = current_since;
      source_gone = kNeverGone;
    }
    current = transitions[static_cast<std::size_t>(best)].to;
    current_since = now;
    by = best;
    has_entered = true;
    log.push_back({now, current});
  }

  void advance(int milliseconds) {
    look();
    for (int i = 0; i < milliseconds; ++i) {
      ++now;
      look();
    }
  }
};

}  // namespace sinew::test
