// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/pose/pose.h"
#include "tests/support/fixed_random.h"

/// Builders of small assets.
namespace sinew::test {

/// Memory of one pose and the view over it.
class PoseBuffer {
 public:
  explicit PoseBuffer(std::size_t joint_count)
      : joint_count_(joint_count), blocks_(PoseSpan::floats_for(joint_count) / 16 + 1) {
    for (std::size_t j = 0; j < joint_count; ++j) span().set(j, {});
  }
  PoseSpan span() noexcept {
    return pose_over({blocks_.front().floats, PoseSpan::floats_for(joint_count_)}, joint_count_);
  }

 private:
  struct alignas(64) Block {
    float floats[16] = {};
  };
  std::size_t joint_count_;
  std::vector<Block> blocks_;
};

/// A skeleton from its parents, which must come breadth first; rest transforms are identities.
inline Skeleton skeleton_of(std::vector<std::uint32_t> parents) {
  Skeleton s;
  const std::size_t count = parents.size();
  std::vector<std::uint32_t> depth(count, 0);
  for (std::uint32_t j = 0; j < count; ++j) {
    depth[j] = parents[j] == kNone ? 0 : depth[parents[j]] + 1;
    if (j == 0 || depth[j] > depth[j - 1]) s.level_begin.push_back(j);
    s.names.push_back("joint" + std::to_string(j));
    s.node_of_joint.push_back(j);
    s.joint_of_node.push_back(j);
  }
  s.level_begin.push_back(static_cast<std::uint32_t>(count));
  s.parents = std::move(parents);
  s.rest.resize(count);
  s.fixed_matrix_of.assign(count, kNone);
  return s;
}

inline Skeleton chain_skeleton(std::uint32_t count) {
  std::vector<std::uint32_t> parents(count, kNone);
  for (std::uint32_t j = 1; j < count; ++j) parents[j] = j - 1;
  return skeleton_of(std::move(parents));
}

template <class V>
Track<V> track_of(Interpolation interpolation, std::initializer_list<float> times_s, std::initializer_list<V> values) {
  return {interpolation, times_s, values};
}

/// Key times that rise by random steps. The `jumps` keys after the second one repeat its time: equal times make a jump.
inline std::vector<float> random_times(FixedRandom& random, std::size_t count, std::size_t jumps = 0) {
  std::vector<float> times;
  float t = static_cast<float>(random.in(0, 1));
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(t);
    if (i == 0 || i > jumps) t += static_cast<float>(random.in(1e-3, 0.5));
  }
  return times;
}

inline std::size_t value_count(Interpolation interpolation, std::size_t keys) {
  return interpolation == Interpolation::cubic_spline ? 3 * keys : keys;
}

inline Vec3Track random_vectors(FixedRandom& random, Interpolation interpolation, const std::vector<float>& times) {
  Vec3Track track{interpolation, times, {}};
  for (std::size_t i = 0; i < value_count(interpolation, times.size()); ++i) track.values.push_back(random.vec3(-2, 2));
  return track;
}

inline QuatTrack random_rotations(FixedRandom& random, Interpolation interpolation, const std::vector<float>& times) {
  QuatTrack track{interpolation, times, {}};
  for (std::size_t i = 0; i < value_count(interpolation, times.size()); ++i) track.values.push_back(random.rotation());
  return track;
}

inline WeightTrack random_weights(FixedRandom& random, Interpolation interpolation, const std::vector<float>& times,
                                  std::uint32_t target_count) {
  WeightTrack track{interpolation, times, {}, target_count};
  for (std::size_t i = 0; i < value_count(interpolation, times.size()) * target_count; ++i)
    track.values.push_back(static_cast<float>(random.in(-1, 2)));
  return track;
}

/// Compiles an animation of joints only.
inline Clip clip_of(const Animation& animation, const Skeleton& skeleton) {
  return compile_clip(animation, skeleton, {}, {});
}

inline Animation animation_of(std::vector<BoneAnimation> bones) {
  Animation a;
  a.name = "test";
  a.bones = std::move(bones);
  for (const BoneAnimation& b : a.bones) a.duration_s = std::max(a.duration_s, b.end_time());
  return a;
}

}  // namespace sinew::test
