// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/procedures/springs/spring_frames.h"
#include "runtime/procedures/springs/spring_records.h"

namespace sinew::springs {

/// swung() turns a joint away from its goal, so that its bone points along a world direction.
/// local_rotation() returns the rotation of the turned joint in its parent's space.
/// in   goal   frame of the joint at its goal, without its own scale;   axis, along   unit: direction of the bone at
///      the goal, and after the turn

inline UniformFrame swung(const UniformFrame& goal, const JointInput&, const Vec& axis, const Vec& along) noexcept {
  return UniformFrame{goal.at, turn_between(axis, along) * goal.rotation, goal.scale};
}
inline Rot local_rotation(const UniformFrame& above, const UniformFrame&, const UniformFrame& turned, const JointInput&,
                          const Vec&) noexcept {
  return quat_conjugate(above.rotation) * turned.rotation;
}

inline Rot swing_of(const MatrixFrame& goal, const JointInput& input, const Vec& along) noexcept {
  return turn_between(input.axis, direction_of(goal.local_direction(along), input.axis));
}
inline MatrixFrame swung(const MatrixFrame& goal, const JointInput& input, const Vec&, const Vec& along) noexcept {
  return goal.turned(swing_of(goal, input, along));
}
inline Rot local_rotation(const MatrixFrame&, const MatrixFrame& goal, const MatrixFrame&, const JointInput& input,
                          const Vec& along) noexcept {
  return input.goal * swing_of(goal, input, along);
}

}  // namespace sinew::springs
