// SPDX-License-Identifier: MIT
#include "tests/bench/combinations.h"

#include <algorithm>
#include <map>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/combinations.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::bench::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// eq   M = sum(w_i * palette[joint_i]), fused from the second on
void blend_joints(const JointMatrix* palette, const std::uint16_t* joints, const float* weights, std::span<const std::size_t> counts, JointMatrix* out) {
  const hn::CappedTag<float, 16> d;
  for (const std::size_t count : counts) {
    for (std::size_t at = 0; at < 16; at += hn::Lanes(d)) {
      auto sum = hn::Mul(hn::Load(d, &palette[joints[0]].column[0].x + at), hn::Set(d, weights[0]));
      for (std::size_t i = 1; i < count; ++i) sum = hn::MulAdd(hn::Load(d, &palette[joints[i]].column[0].x + at), hn::Set(d, weights[i]), sum);
      hn::Store(sum, d, &out->column[0].x + at);
    }
    joints += count, weights += count, ++out;
  }
}

}  // namespace
}  // namespace sinew::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew::bench {
namespace {
HWY_EXPORT(blend_joints);
}  // namespace

Combinations::Combinations(const VertexInfluences& influences, std::size_t joint_count) {
  std::map<std::vector<std::pair<std::uint16_t, float>>, std::size_t> known;
  std::uint32_t vertex = 0;
  for (const InfluenceGroup& group : influences.groups)
    for (std::uint32_t v = 0; v < group.vertex_count; ++v, ++vertex) {
      const std::size_t first = group.first_influence + std::size_t{v} * group.influence_count;
      std::vector<std::pair<std::uint16_t, float>> combination;
      for (std::size_t i = first; i < first + group.influence_count; ++i) combination.emplace_back(influences.joints[i], influences.weights[i]);
      std::size_t matrix = combination[0].first;
      if (group.influence_count > 1) {
        const auto [at, is_new] = known.try_emplace(combination, joint_count + counts_.size());
        if (is_new) {
          counts_.push_back(combination.size());
          for (const auto& [joint, weight] : combination) joints_.push_back(joint), weights_.push_back(weight);
        }
        matrix = at->second;
      }
      single_.joints.push_back(static_cast<std::uint16_t>(matrix)), single_.weights.push_back(1.0f);
    }
  single_.groups = {{0, vertex, 1, 0}};
  matrices_.resize(joint_count + counts_.size());
}

void Combinations::skin(std::span<const JointMatrix> palette, const VertexInput& in, const VertexOutput& out) {
  std::copy(palette.begin(), palette.end(), matrices_.begin());
  HWY_DYNAMIC_DISPATCH(blend_joints)(palette.data(), joints_.data(), weights_.data(), counts_, matrices_.data() + palette.size());
  run(SkinLinearJob{&single_, matrices_, in, out, NormalRule::linear});
}

}  // namespace sinew::bench
#endif
