// SPDX-License-Identifier: MIT
#include "tests/bench/combinations.h"

#include <algorithm>
#include <map>
#include <utility>

#include "runtime/deform/blend_combinations.h"

namespace sinew::bench {

Combinations::Combinations(const VertexInfluences& influences, std::size_t joint_count) {
  std::map<std::vector<std::pair<std::uint16_t, float>>, std::size_t> known;
  std::uint32_t vertex = 0, count = 0;
  for (const InfluenceGroup& group : influences.groups) {
    combinations_.groups.push_back(
        {count, 0, group.influence_count, static_cast<std::uint32_t>(combinations_.joints.size())});
    for (std::uint32_t v = 0; v < group.vertex_count; ++v, ++vertex) {
      const std::size_t first = group.first_influence + std::size_t{v} * group.influence_count;
      std::vector<std::pair<std::uint16_t, float>> combination;
      for (std::size_t i = first; i < first + group.influence_count; ++i)
        combination.emplace_back(influences.joints[i], influences.weights[i]);
      std::size_t matrix = combination[0].first;
      if (group.influence_count > 1) {
        const auto [at, is_new] = known.try_emplace(combination, joint_count + count);
        if (is_new) {
          ++count;
          ++combinations_.groups.back().vertex_count;
          for (const auto& [joint, weight] : combination) {
            combinations_.joints.push_back(joint);
            combinations_.weights.push_back(weight);
          }
        }
        matrix = at->second;
      }
      single_.joints.push_back(static_cast<std::uint16_t>(matrix));
      single_.weights.push_back(1.0f);
    }
  }
  single_.groups = {{0, vertex, 1, 0}};
  matrices_.resize(joint_count + count);
}

void Combinations::skin(std::span<const JointMatrix> palette, const VertexInput& in, const VertexOutput& out) {
  std::copy(palette.begin(), palette.end(), matrices_.begin());
  run_unchecked(BlendCombinationsJob{&combinations_, palette, std::span(matrices_).subspan(palette.size())});
  run_unchecked(SkinLinearJob{&single_, matrices_, in, out, NormalRule::linear});
}

}  // namespace sinew::bench
