// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sinew {

/// Where the lanes of a block of tracks belong in a pose, seen from the pose: whole vectors of joints are put together
/// from neighbouring lanes, so that nothing is scattered.
struct JointPlaces {
  static constexpr std::size_t kStep = 16, kPart = 4;  ///< joints of the widest and of the narrowest vector

  std::uint32_t first_joint = 0;      ///< a multiple of kStep
  std::vector<std::int32_t> lane_of;  ///< [multiple of kStep] lane of joint first_joint + i, -1 = none
  std::vector<std::uint32_t>
      lanes_before;  ///< [lane_of.size() / kPart + 1] lanes of all joints before first_joint + i * kPart

  JointPlaces() = default;
  /// in   joints  of the lanes, increasing, at least one
  explicit JointPlaces(std::span<const std::uint32_t> joints)
      : first_joint(static_cast<std::uint32_t>(joints.front() / kStep * kStep)),
        lane_of((joints.back() - first_joint) / kStep * kStep + kStep, -1),
        lanes_before(lane_of.size() / kPart + 1, 0) {
    for (std::size_t lane = 0; lane < joints.size(); ++lane) {
      lane_of[joints[lane] - first_joint] = static_cast<std::int32_t>(lane);
      ++lanes_before[(joints[lane] - first_joint) / kPart + 1];
    }
    for (std::size_t i = 1; i < lanes_before.size(); ++i) lanes_before[i] += lanes_before[i - 1];
  }

  std::size_t byte_size() const noexcept {
    return lane_of.size() * sizeof(std::int32_t) + lanes_before.size() * sizeof(std::uint32_t);
  }
};

}  // namespace sinew
