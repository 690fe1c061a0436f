// SPDX-License-Identifier: MIT
#pragma once
#include <rapidcheck.h>

#include "tests/support/fixed_random.h"

namespace rc {

/// Uniform rotations and motions: RapidCheck draws the seed, so a failing case is shrunk to a small seed and
/// repeatable.
template <>
struct Arbitrary<sinew::Quat<double>> {
  static Gen<sinew::Quat<double>> arbitrary() {
    return gen::map(gen::arbitrary<std::uint64_t>(),
                    [](std::uint64_t seed) { return sinew::test::FixedRandom(seed).rotation<double>(); });
  }
};

template <>
struct Arbitrary<sinew::Vec3<double>> {
  static Gen<sinew::Vec3<double>> arbitrary() {
    return gen::map(gen::arbitrary<std::uint64_t>(),
                    [](std::uint64_t seed) { return sinew::test::FixedRandom(seed).vec3<double>(-2, 2); });
  }
};

}  // namespace rc
