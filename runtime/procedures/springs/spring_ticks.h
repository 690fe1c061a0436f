// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/procedures/springs/spring_collisions.h"
#include "runtime/procedures/springs/spring_memory.h"
#include "runtime/procedures/springs/spring_swing.h"

namespace sinew::springs {

/// The simulation steps of one frame. Frame is UniformFrame or MatrixFrame.
template <class Frame>
class Ticks {
 public:
  Ticks(const SpringTables& tables, const SpringMemory& memory, std::span<const JointInput> inputs,
        double threshold) noexcept
      : tables_(tables),
        memory_(memory),
        inputs_(inputs),
        frames_(reinterpret_cast<Frame*>(memory.frames.data())),
        joints_(reinterpret_cast<Frame*>(memory.joints.data())),
        threshold_(threshold) {}

  /// Places all input frames and colliders at a time between the last frames, or after them.
  void place_inputs(const FrameWeights& weights) noexcept {
    for (std::size_t f = 0; f < memory_.now.size(); ++f)
      place(interpolated(memory_.earlier[f], memory_.before[f], memory_.now[f], weights), frames_[f]);
    for (std::size_t c = 0; c < memory_.shapes.size(); ++c) {
      const SpringColliderRecord& collider = tables_.colliders[c];
      memory_.shapes[c] = world_shape(collider.shape, frames_[collider.frame]);
    }
  }

  /// Puts all tails at their goals, without velocity.
  void reset() noexcept {
    for_each([&](std::size_t r, const SpringRecord& record, const Frame& goal) {
      const Vec end = goal.point(inputs_[r].bone), tail = to_center(record, end);
      memory_.tails[r] = {tail, tail, frames_[record.frame].local_point(end)};
      return goal.scaled(inputs_[r].scale);
    });
  }

  /// Runs a tick from SpringMemory::tails to SpringMemory::next. True if a joint moved faster than the threshold.
  /// in   kShows   true: also writes the rotations, as a show() after the tick would
  /// out  tails    [joints of the setup] or empty; written only with kShows
  template <bool kShows>
  bool tick(std::span<Vec> tails = {}) noexcept {
    bool moves = false;
    for_each([&](std::size_t r, const SpringRecord& record, const Frame& goal) {
      const JointInput& input = inputs_[r];
      const Tail& tail = memory_.tails[r];
      const double bone_length = goal.length_of(input.bone, input.length);
      const Vec axis = goal.direction_along(input.bone, input.axis);
      double length = bone_length;
      if (record.lagging) {
        const Vec lagging = frames_[record.frame].point(tail.end) - goal.at;
        length = std::sqrt(dot(lagging, lagging));
      }
      const Vec ahead = to_world(record, tail.now + (tail.now - tail.before) * record.kept);
      Vec along = direction_of(ahead + axis * record.pull + record.gravity - goal.at, axis);
      Vec next = goal.at + along * length;
      keep_out(tables_, memory_.shapes, record, {goal.at, axis, length}, along, next);
      const Frame turned = swung(goal, input, axis, along);
      NextTail& result = memory_.next[r];
      result.now = to_center(record, next);
      if (record.lagging) result.end = frames_[record.frame].local_point(turned.point(input.bone));
      const Vec step = result.now - tail.now;
      moves |= !(dot(step, step) <= threshold_ * (bone_length * bone_length));
      if constexpr (kShows) {
        memory_.shown[r] = local_rotation(above_of(record), goal, turned, input, along);
        if (!tails.empty()) tails[record.setup] = goal.at + along * bone_length;
      }
      return turned.scaled(input.scale);
    });
    if constexpr (kShows) show_carried(tails);
    return moves;
  }

  /// Makes the result of the last tick the current state.
  void commit() noexcept {
    for (std::size_t r = 0; r < memory_.tails.size(); ++r)
      memory_.tails[r] = {memory_.next[r].now, memory_.tails[r].now, memory_.next[r].end};
  }

  /// Writes all rotations for tails at `fraction` of the way from the last tick to `next`. At 0 `next` is not read.
  /// out  tails[joints of the setup] or empty; sleeping joints keep the bits of their rotations
  void show(double fraction, std::span<Vec> tails, bool writes_rotations = true) noexcept {
    for_each([&](std::size_t r, const SpringRecord& record, const Frame& goal) {
      const JointInput& input = inputs_[r];
      Vec tail = memory_.tails[r].now;
      if (fraction != 0.0) tail = tail * (1.0 - fraction) + memory_.next[r].now * fraction;
      const Vec from_head = to_world(record, tail) - goal.at;
      const Vec local = direction_of(goal.local_direction(from_head), input.axis);
      const Rot swing = turn_between(input.axis, local);
      if (writes_rotations) memory_.shown[r] = input.goal * swing;
      if (!tails.empty()) {
        const Vec along = direction_of(from_head, goal.vector(input.bone));
        tails[record.setup] = goal.at + along * goal.length_of(input.bone, input.length);
      }
      return goal.turned(swing).scaled(input.scale);
    });
    show_carried(tails);
  }

 private:
  /// Calls swing(r, record, its goal) for each joint that swings, parents first. swing returns the joint's new frame.
  template <class Swing>
  void for_each(const Swing& swing) noexcept {
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const SpringRecord& record = tables_.records[r];
      const JointInput& input = inputs_[r];
      const Frame goal = above_of(record).child(input.translation, input.goal);
      joints_[r] = record.group == kNone ? goal.scaled(input.scale) : swing(r, record, goal);
    }
  }

  const Frame& above_of(const SpringRecord& record) const noexcept {
    return record.parent == kNone ? frames_[record.frame] : joints_[record.parent];
  }

  void show_carried(std::span<Vec> tails) noexcept {
    if (!tables_.has_carried) return;
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const SpringRecord& record = tables_.records[r];
      if (record.group != kNone) continue;
      memory_.shown[r] = inputs_[r].goal;
      if (!tails.empty() && record.setup != kNone) tails[record.setup] = joints_[r].at;
    }
  }

  Vec to_world(const SpringRecord& record, const Vec& tail) const noexcept {
    const std::uint32_t center = tables_.groups[record.group].center;
    return center == kNone ? tail : frames_[center].point(tail);
  }
  Vec to_center(const SpringRecord& record, const Vec& tail) const noexcept {
    const std::uint32_t center = tables_.groups[record.group].center;
    return center == kNone ? tail : frames_[center].local_point(tail);
  }

  const SpringTables& tables_;
  const SpringMemory& memory_;
  std::span<const JointInput> inputs_;
  Frame* frames_;
  Frame* joints_;
  double threshold_;
};

}  // namespace sinew::springs
