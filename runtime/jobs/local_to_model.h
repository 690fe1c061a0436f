// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/assets/skeleton.h"
#include "runtime/base/result.h"
#include "runtime/jobs/pose.h"

namespace sinew {

/// Model-space transform of every joint, parents first.
/// eq   M[j] = M[parent(j)] * T(j) * R(j) * S(j); roots start from `root`   (glTF 2.0, "Transformations")
///      a joint with a fixed matrix uses that matrix in place of T * R * S (G50)
/// in   skeleton   parents[j] < j;   local  [J] unit quaternions
/// out  model[J]   must not overlap `local`
/// err  size_mismatch     cost O(J), no allocation
struct LocalToModelJob {
  const Skeleton* skeleton = nullptr;
  PoseSpan local;
  Affine root;
  std::span<Affine> model;
};

ErrorCode check(const LocalToModelJob& job) noexcept;
void run(const LocalToModelJob& job) noexcept;

}  // namespace sinew
