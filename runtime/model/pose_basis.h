// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/pose_samples.h"

namespace sinew {

/// The functions that an interpolant over poses is made of, in double: S radial ones, one per sample, then those of the
/// polynomial tail. Used to solve a corrective and to evaluate it, so that both see the same bits.

std::size_t basis_size(const PoseSamples& samples) noexcept;

/// First half, one driver after another: squared distances from each sample are summed, the tail is filled in.
/// eq   basis[s] += (weight * angle(rotation, rotation of sample s))^2;  angles by atan2 (N03), so that q and -q are
///      the same, and the distance from a sample itself is exactly 0
/// in   basis[basis_size]  zeros before the first driver
void add_driver(const PoseSamples& samples, std::size_t driver, const glm::quat& rotation,
                std::span<double> basis) noexcept;

/// Second half: squared distances become values of the kernel.
void finish_basis(const PoseSamples& samples, std::span<double> basis) noexcept;

}  // namespace sinew
