// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/pose_samples.h"

namespace sinew {

/// Basis functions of a PoseCorrective, in double: a radial one for each of the S samples, then those of the
/// polynomial tail. Solving and evaluating a corrective use the same functions, so both see the same bits.

std::size_t basis_size(const PoseSamples& samples) noexcept;

/// First step, called for each driver: adds its squared distance from each sample, and fills in its tail functions.
/// eq   basis[s] += (weight * angle(rotation, rotation of sample s))^2;  angles by atan2, so that q and -q are
///      the same, and the distance from a sample itself is exactly 0
/// in   basis[basis_size]  zero before the first driver
void add_driver(const PoseSamples& samples, std::size_t driver, const glm::quat& rotation,
                std::span<double> basis) noexcept;

/// Second step: replaces squared distances by values of the kernel.
void finish_basis(const PoseSamples& samples, std::span<double> basis) noexcept;

}  // namespace sinew
