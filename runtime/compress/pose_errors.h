// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/compress/truth_samples.h"

namespace sinew {

/// Local transforms of a few poses of one skeleton, in double. Numbers of the same kind lie side by side for all poses,
/// so that one vector computes several poses.
class PoseBlock {
 public:
  static constexpr std::size_t kPoses = 8, kNumbers = 10;

  explicit PoseBlock(std::size_t joint_count) : numbers_(joint_count * kNumbers * kPoses, 0.0) {}

  std::size_t joint_count() const noexcept { return numbers_.size() / (kNumbers * kPoses); }
  /// The number of each pose: 0 to 2 translation, 3 to 6 rotation xyzw, 7 to 9 scale.
  const double* number(std::size_t joint, std::size_t n) const noexcept {
    return numbers_.data() + (joint * kNumbers + n) * kPoses;
  }
  void set(std::size_t pose, std::size_t joint, const Transformd& local) noexcept {
    double* at = numbers_.data() + joint * kNumbers * kPoses + pose;
    const auto &t = local.translation, &s = local.scale;
    const auto& r = local.rotation;
    for (const double number : {t.x, t.y, t.z, r.x, r.y, r.z, r.w, s.x, s.y, s.z}) {
      *at = number;
      at += kPoses;
    }
  }

 private:
  std::vector<double> numbers_;
};

/// Computes how far the virtual vertices of each joint are from their places in the truth, for a few poses at once.
/// eq   out[pose * J + j] = max |M c - truth c|^2 over the corners c of boxes[j]; M as model_from_local()
/// in   poses          count <= kPoses of them are used
///      truth[count]   corners of the exact poses, [J] each
///      models[J * kModelNumbers]   memory for the kernel
/// out  squared[count * J], and its largest numbers: largest[J] of each joint, where larger than before, worst[count]
///      of each pose. The same bits on every instruction set. A number that is not finite counts as 0.
/// cost O(J) vectors of poses, no allocation
struct PoseErrorsJob {
  static constexpr std::size_t kModelNumbers = 12 * PoseBlock::kPoses;

  const Skeleton* skeleton = nullptr;
  std::span<const Aabb> boxes;
  const PoseBlock* poses = nullptr;
  std::span<const BoxCorners* const> truth;
  std::span<double> models;
  std::span<double> squared, largest, worst;
};
SINEW_API ErrorCode check(const PoseErrorsJob& job) noexcept;
SINEW_API void run_unchecked(const PoseErrorsJob& job) noexcept;

}  // namespace sinew
