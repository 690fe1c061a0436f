// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "viewer/light/environment.h"

namespace sinew::viewer {

/// A cache key of everything that a prefiltered environment depends on: the bits of the sky and the version of the
/// algorithms.
std::uint64_t environment_key(const CubeMap& sky);

/// The expensive parts of an environment as bytes: diffuse coefficients, filtered levels, split-sum table.
std::vector<std::byte> stored_parts(const Environment& environment);

/// Rebuilds an environment from its sky and stored parts, bit-identical to make_environment. Null if `parts` has the
/// wrong size.
std::shared_ptr<Environment> complete_environment(CubeMap sky, std::span<const std::byte> parts);

}  // namespace sinew::viewer
