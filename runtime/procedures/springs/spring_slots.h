// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sinew::springs {

/// A tick computes joints side by side in vector lanes. So all numbers of a tick are planes of doubles, one for each
/// component, and joints are numbered by slots. The first slots are the input frames, then comes the identity, and then
/// the joints by their depth below the frames. Joints of one depth do not depend on each other.

/// Most lanes of a vector. Planes are this much longer than their slots. The last vector of a depth runs into the next
/// depth, which is computed after it.
inline constexpr std::size_t kSpringLanes = 8;

/// Planes of an array; `stride` is a multiple of kSpringLanes.
template <class T>
struct Planes {
  T* data = nullptr;
  std::size_t stride = 0;

  T* plane(std::size_t p) const noexcept { return data + p * stride; }
  T& at(std::size_t p, std::size_t slot) const noexcept { return data[p * stride + slot]; }
};

/// First planes of the members of JointInput, and their number.
namespace input {
enum Plane : std::size_t { translation = 0, goal = 3, scale = 7, bone = 10, axis = 13, length = 16, count = 17 };
}
/// Numbers of SpringRecord. `group`, `swings` and `lagging` are whole numbers, and flags of 0 and 1.
namespace constant {
enum Plane : std::size_t { kept, pull, gravity, hit_radius = 5, group, swings, lagging, count };
}
/// Tails in the space of their centre, and the end of the bone in the space of the frame above the chain. A tick writes
/// all but `before`.
namespace tail {
enum Plane : std::size_t { before = 0, now = 3, end = 6, count = 9 };
}
/// Rotations of joints as a pose takes them, and ends of bones in the world.
namespace shown {
enum Plane : std::size_t { rotation = 0, end = 4, count = 7 };
}
/// A frame is its origin, and then either a rotation and a scale or the columns of a matrix.
inline constexpr std::size_t kFramePlanes = 12;

/// Slots of a definition.
struct SpringSlots {
  std::size_t first_joint = 0;        ///< number of input frames + 1; the slot before it is the identity
  std::size_t stride = 0;             ///< of all planes: slots and kSpringLanes, rounded up
  std::vector<std::size_t> depths;    ///< [depths + 1] first slot of each depth, and the end
  std::vector<std::uint32_t> record;  ///< [joints] record of each slot from first_joint on
  std::vector<std::uint32_t> slot;    ///< [records]
  std::vector<std::int64_t> parent;   ///< [stride] slots of parents, an input frame for the first joint of a chain
  std::vector<std::int64_t> frame;    ///< [stride] slots of the frames above the chains
  std::vector<std::int64_t> center;   ///< [stride] slots of centres, the identity for the world
  std::vector<double> constants;      ///< planes of constant::Plane
  std::vector<double> rest_inputs;    ///< planes of input::Plane, with all joints at rest
  bool has_centers = false, has_lagging = false, has_colliders = false;

  std::size_t identity() const noexcept { return first_joint - 1; }
};

}  // namespace sinew::springs
