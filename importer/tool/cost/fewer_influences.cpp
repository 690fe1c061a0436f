// SPDX-License-Identifier: MIT
#include "importer/tool/cost/fewer_influences.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace sinew::cost {
namespace {

void make_sum_one(std::span<float> weights) {
  double sum = 0.0;
  for (const float w : weights) sum += static_cast<double>(w);
  if (!(sum > 0.0)) return;
  for (float& w : weights) w = static_cast<float>(static_cast<double>(w) / sum);
}

}  // namespace

VertexInfluences heaviest_influences(const VertexInfluences& influences, std::uint32_t count) {
  VertexInfluences out;
  for (const InfluenceGroup& group : influences.groups) {
    const std::uint32_t kept = std::min(count, group.influence_count);
    const auto first = static_cast<std::uint32_t>(out.weights.size());
    for (std::size_t v = 0; v < group.vertex_count; ++v) {
      const std::size_t from = group.first_influence + v * group.influence_count;
      for (std::size_t i = from; i < from + kept; ++i) {
        out.joints.push_back(influences.joints[i]);
        out.weights.push_back(influences.weights[i]);
      }
      make_sum_one(std::span(out.weights).last(kept));
    }
    const bool continues = !out.groups.empty() && out.groups.back().influence_count == kept;
    if (continues)
      out.groups.back().vertex_count += group.vertex_count;
    else
      out.groups.push_back({group.first_vertex, group.vertex_count, kept, first});
  }
  return out;
}

template <class N>
std::vector<N> whole_weights(const VertexInfluences& influences) {
  constexpr int kOne = std::numeric_limits<N>::max();
  std::vector<N> out;
  for (const float w : influences.weights) out.push_back(static_cast<N>(std::lround(static_cast<double>(w) * kOne)));
  for (const InfluenceGroup& group : influences.groups)
    for (std::size_t v = 0; v < group.vertex_count; ++v) {
      const auto weights =
          std::span(out).subspan(group.first_influence + v * group.influence_count, group.influence_count);
      weights[0] = static_cast<N>(weights[0] + kOne - std::accumulate(weights.begin(), weights.end(), 0));
    }
  return out;
}

template std::vector<std::uint8_t> whole_weights(const VertexInfluences&);
template std::vector<std::uint16_t> whole_weights(const VertexInfluences&);

}  // namespace sinew::cost
