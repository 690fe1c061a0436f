// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <variant>

#include "runtime/base/run_job.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Influences for the skinning jobs, in the integer types of a file or an engine and in the order of VertexInfluences.
/// Jobs convert 8-bit joints and integer weights tile by tile. The results are the same as with converted arrays.
struct InfluenceStreams {
  /// The largest number of influences per vertex that can be converted.
  static constexpr std::uint32_t kMaxConverted = 32;

  std::span<const InfluenceGroup> groups;
  std::variant<std::span<const std::uint16_t>, std::span<const std::uint8_t>> joints;
  std::variant<std::span<const float>, std::span<const std::uint16_t>, std::span<const std::uint8_t>>
      weights;  ///< integer weights are normalised: the largest integer means 1

  InfluenceStreams() = default;
  InfluenceStreams(decltype(groups) g, decltype(joints) j, decltype(weights) w) noexcept
      : groups(g), joints(j), weights(w) {}
  /// nullptr = no influences.
  InfluenceStreams(const VertexInfluences* from) noexcept {  // NOLINT(google-explicit-constructor): jobs take either
    if (!from) return;
    groups = from->groups;
    joints = std::span(from->joints);
    weights = std::span(from->weights);
  }

  bool is_wide() const noexcept { return joints.index() == 0 && weights.index() == 0; }
  std::size_t joint_count() const noexcept {
    return std::visit([](auto all) { return all.size(); }, joints);
  }
  std::size_t weight_count() const noexcept {
    return std::visit([](auto all) { return all.size(); }, weights);
  }
  bool have_memory() const noexcept {
    const auto has = [](auto all) { return sinew::have_memory(all); };
    return has(groups) && std::visit(has, joints) && std::visit(has, weights);
  }
};

}  // namespace sinew
