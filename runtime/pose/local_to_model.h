// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Model-space transform of every joint, parents first.
/// eq   M[j] = M[parent(j)] * T(j) * R(j) * S(j); roots start from `root`   (glTF 2.0, "Transformations")
///      A joint with a fixed matrix uses that matrix in place of T * R * S (G50).
/// in   skeleton   parents[j] < j;   local[J]  unit quaternions
///      only       increasing indices of the joints to compose; `model` holds the others already. Empty = all joints
/// out  model[J]   must not overlap `local`
/// err  size_mismatch, index_out_of_range, overlapping_buffers     cost O(J), or O(joints of `only`); no allocation
struct LocalToModelJob {
  const Skeleton* skeleton = nullptr;
  PoseSpan local;
  Affine root;
  std::span<Affine> model;
  std::span<const std::uint32_t> only = {};
};

ErrorCode check(const LocalToModelJob& job) noexcept;
void run_unchecked(const LocalToModelJob& job) noexcept;

}  // namespace sinew
