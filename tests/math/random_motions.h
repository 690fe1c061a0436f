// SPDX-License-Identifier: MIT
#pragma once
#include <rapidcheck.h>

#include "tests/support/fixed_random.h"

namespace rc {

/// Uniform random rotations and motions. RapidCheck draws only a seed, so a failing case can be repeated and shrinks
/// to a small seed.
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
