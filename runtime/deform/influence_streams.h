// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <variant>

#include "runtime/model/skin.h"

namespace sinew {

/// Influences for the skinning jobs, as VertexInfluences orders them, in numbers as small as a file or an engine keeps
/// them. A job's tiles widen what is not 16-bit joints and float weights as they come to it; results are those of the
/// widened numbers.
struct InfluenceStreams {
  /// Influences of a vertex, at the most, where numbers have to be widened.
  static constexpr std::uint32_t kMostWidened = 32;

  std::span<const InfluenceGroup> groups;
  std::variant<std::span<const std::uint16_t>, std::span<const std::uint8_t>> joints;
  std::variant<std::span<const float>, std::span<const std::uint16_t>, std::span<const std::uint8_t>>
      weights;  ///< of integers the largest is 1

  InfluenceStreams() = default;
  InfluenceStreams(decltype(groups) g, decltype(joints) j, decltype(weights) w) noexcept
      : groups(g), joints(j), weights(w) {}
  /// No influences where there are none.
  InfluenceStreams(const VertexInfluences* from) noexcept {  // NOLINT(google-explicit-constructor): jobs take either
    if (from) groups = from->groups, joints = std::span(from->joints), weights = std::span(from->weights);
  }

  bool is_wide() const noexcept { return joints.index() == 0 && weights.index() == 0; }
  std::size_t joint_count() const noexcept {
    return std::visit([](auto all) { return all.size(); }, joints);
  }
  std::size_t weight_count() const noexcept {
    return std::visit([](auto all) { return all.size(); }, weights);
  }
};

}  // namespace sinew
