// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/procedures/springs/spring_collisions.h"
#include "runtime/procedures/springs/spring_memory.h"

namespace sinew::springs {

/// The steps of one frame, for frames of one kind.
template <class Frame>
class Ticks {
 public:
  Ticks(const SpringTables& tables, const SpringMemory& memory, double threshold) noexcept
      : tables_(tables),
        memory_(memory),
        frames_(reinterpret_cast<Frame*>(memory.frames.data())),
        joints_(reinterpret_cast<Frame*>(memory.joints.data())),
        threshold_(threshold) {
    static_assert(sizeof(Frame) <= sizeof(MatrixFrame));
  }

  /// Places all input frames and colliders at a time between the last frames, or behind them.
  void place_inputs(const FrameWeights& weights) noexcept {
    for (std::size_t f = 0; f < memory_.now.size(); ++f)
      place(interpolated(memory_.earlier[f], memory_.before[f], memory_.now[f], weights), frames_[f]);
    for (std::size_t c = 0; c < memory_.shapes.size(); ++c) {
      const SpringColliderRecord& collider = tables_.colliders[c];
      memory_.shapes[c] = world_shape(collider.shape, frames_[collider.frame]);
    }
  }

  /// Puts all tails at rest where their goals are.
  void reset() noexcept {
    for_each([&](std::size_t r, const SpringRecord& record, const Frame& goal) {
      const Vec end = goal.point(memory_.inputs[r].bone), tail = to_center(record, end);
      memory_.tails[r] = {tail, tail, frames_[record.frame].local_point(end)};
      return goal.scaled(memory_.inputs[r].scale);
    });
  }

  /// One tick, from SpringMemory::tails to SpringMemory::next. True if a joint moved faster than the threshold.
  bool tick() noexcept {
    bool moves = false;
    for_each([&](std::size_t r, const SpringRecord& record, const Frame& goal) {
      const JointInput& input = memory_.inputs[r];
      const Tail& tail = memory_.tails[r];
      const Vec bone = goal.vector(input.bone);
      const double square = dot(bone, bone);
      double length = std::sqrt(square);
      const Vec axis = square > 1e-200 ? bone * (1.0 / length) : Vec(0, 1, 0);
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
      moves |= !(dot(step, step) <= threshold_ * square);
      return turned.scaled(input.scale);
    });
    return moves;
  }

  /// Makes the last tick's result the state.
  void commit() noexcept {
    for (std::size_t r = 0; r < memory_.tails.size(); ++r)
      memory_.tails[r] = {memory_.next[r].now, memory_.tails[r].now, memory_.next[r].end};
  }

  /// Rotations of all joints for tails at a fraction of the way from the last tick to `next`; 0 needs no `next`.
  /// out  tails[joints of the setup] or empty
  void show(double fraction, std::span<Vec> tails) noexcept {
    for_each([&](std::size_t r, const SpringRecord& record, const Frame& goal) {
      const JointInput& input = memory_.inputs[r];
      Vec tail = memory_.tails[r].now;
      if (fraction != 0.0) tail = tail * (1.0 - fraction) + memory_.next[r].now * fraction;
      const Vec from_head = to_world(record, tail) - goal.at;
      const Vec local = direction_of(goal.local_direction(from_head), input.axis);
      const Rot swing = turn_between(input.axis, local);
      memory_.shown[r] = input.goal * swing;
      if (!tails.empty()) tails[record.setup] = at_length(goal, input, from_head);
      return goal.turned(swing).scaled(input.scale);
    });
    for (std::size_t r = 0; r < tables_.records.size(); ++r)
      if (const SpringRecord& record = tables_.records[r]; record.group == kNone) {
        memory_.shown[r] = memory_.inputs[r].goal;
        if (!tails.empty() && record.setup != kNone) tails[record.setup] = joints_[r].at;
      }
  }

 private:
  /// Calls swing(record, its goal) for each joint that swings, parents first; it returns the joint's new frame.
  template <class Swing>
  void for_each(const Swing& swing) noexcept {
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const SpringRecord& record = tables_.records[r];
      const JointInput& input = memory_.inputs[r];
      const Frame& above = record.parent == kNone ? frames_[record.frame] : joints_[record.parent];
      const Frame goal = above.child(input.translation, input.goal);
      joints_[r] = record.group == kNone ? goal.scaled(input.scale) : swing(r, record, goal);
    }
  }

  /// The tail in a direction from the head, as far from it as at the goal.
  static Vec at_length(const Frame& goal, const JointInput& input, const Vec& from_head) noexcept {
    const Vec bone = goal.vector(input.bone);
    return goal.at + direction_of(from_head, bone) * std::sqrt(dot(bone, bone));
  }

  Vec to_world(const SpringRecord& record, const Vec& tail) const noexcept {
    const std::uint32_t center = tables_.groups[record.group].center;
    return center == kNone ? tail : frames_[center].point(tail);
  }
  Vec to_center(const SpringRecord& record, const Vec& tail) const noexcept {
    const std::uint32_t center = tables_.groups[record.group].center;
    return center == kNone ? tail : frames_[center].local_point(tail);
  }

  static UniformFrame swung(const UniformFrame& goal, const JointInput&, const Vec& axis, const Vec& along) noexcept {
    return UniformFrame{goal.at, turn_between(axis, along) * goal.rotation, goal.scale};
  }
  static MatrixFrame swung(const MatrixFrame& goal, const JointInput& input, const Vec&, const Vec& along) noexcept {
    const Vec local = direction_of(goal.local_direction(along), input.axis);
    return goal.turned(turn_between(input.axis, local));
  }

  const SpringTables& tables_;
  const SpringMemory& memory_;
  Frame* frames_;
  Frame* joints_;
  double threshold_;
};

}  // namespace sinew::springs
