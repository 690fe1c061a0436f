// SPDX-License-Identifier: MIT
// Prints a hash of the bits of poses and skinned vertices of a generated character. Numbers come from integers and
// square roots, which are the same on every machine.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include <sinew/animation.h>
#include <sinew/clip.h>
#include <sinew/pose_jobs.h>

#include "runtime/base/bit_hash.h"

namespace {

using namespace sinew;

constexpr std::uint32_t kJoints = 67, kKeys = 31, kSamples = 1000;

/// Numbers in [-1, 1) from a linear congruence (Knuth, MMIX).
class Numbers {
 public:
  float next() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<float>(static_cast<std::int32_t>(state_ >> 32)) / 2147483648.0f;
  }

 private:
  std::uint64_t state_ = 1;
};

/// A chain of short bones.
Skeleton make_chain() {
  Skeleton chain;
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    chain.parents.push_back(j == 0 ? kNone : j - 1);
    chain.rest.push_back({.translation = {0.0f, 0.125f, 0.0f}});
    chain.fixed_matrix_of.push_back(kNone);
    chain.names.emplace_back();
    chain.node_of_joint.push_back(j);
    chain.level_begin.push_back(j);
  }
  chain.joint_of_node = chain.node_of_joint;
  chain.level_begin.push_back(kJoints);
  return chain;
}

Result<Animation> make_motion(Numbers& numbers) {
  Animation motion;
  motion.duration_s = kKeys - 1;
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    std::array<Keyframe, kKeys> keys;
    for (std::uint32_t k = 0; k < kKeys; ++k) {
      const float x = numbers.next(), y = numbers.next(), z = numbers.next(), w = 2.0f + numbers.next();
      const float length = std::sqrt(x * x + y * y + z * z + w * w);
      keys[k] = {.time_s = static_cast<double>(k), .translation = {numbers.next(), numbers.next(), numbers.next()}};
      keys[k].rotation = quat_xyzw(x / length, y / length, z / length, w / length);
    }
    auto bone = BoneAnimation::from_keyframes(j, keys);
    if (!bone) return tl::unexpected(bone.error());
    motion.bones.push_back(std::move(*bone));
  }
  return motion;
}

}  // namespace

int main() {
  Numbers numbers;
  const Skeleton chain = make_chain();
  const Result<Animation> motion = make_motion(numbers);
  if (!motion) return 1;
  const Clip clip = compile_clip(*motion, chain, {}, {});
  alignas(64) static std::array<float, PoseSpan::floats_for(kJoints)> memory{};
  const PoseSpan pose = pose_over(memory, kJoints);
  std::vector<Affine> world(kJoints);
  BitHash locals, matrices;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const double time_s = (0.5 + 0.5 * numbers.next()) * (kKeys - 1);
    const SampleClipJob sample{.clip = &clip, .time_s = time_s, .pose = pose, .weights = {}};
    const LocalToModelJob to_model{.skeleton = &chain, .local = pose, .root = {}, .model = world};
    if (run(sample) != ErrorCode::ok || run(to_model) != ErrorCode::ok) return 1;
    locals.add(std::span<const float>(memory));
    matrices.add(std::span<const Affine>(world));
  }
  std::printf("locals %016llx, matrices %016llx\n", static_cast<unsigned long long>(locals.value()),
              static_cast<unsigned long long>(matrices.value()));
}
