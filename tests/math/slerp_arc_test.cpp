// SPDX-License-Identifier: MIT
#include "runtime/math/slerp_arc.h"

#include <gtest/gtest.h>

#include <cstring>
#include <utility>
#include <vector>

#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

/// The exact bits, also of the sign of a zero.
bool same_bits(const Quat<double>& a, const Quat<double>& b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

TEST(slerp_arc, gives_the_bits_of_slerp_at_every_place) {
  test::FixedRandom random(11);
  std::vector<std::pair<Quat<double>, Quat<double>>> arcs;
  for (int i = 0; i < 200; ++i)
    arcs.emplace_back(quat_cast<double>(random.rotation()), quat_cast<double>(random.rotation()));
  const Quat<double> q = arcs[0].first, i = quat_xyzw(1.0, 0.0, 0.0, 0.0);
  const Quat<double> twice = q * 2.0, beside = normalised(q + quat_xyzw(1e-200, 1e-9, 0.0, 0.0));
  arcs.insert(arcs.end(), {{q, q}, {q, -q}, {q, q * i}, {q * i, -q}, {twice, twice}, {q, beside}, {-q, beside}});
  for (const auto& [from, to] : arcs) {
    const SlerpArc<double> arc(from, to);
    for (const double t : {0.0, 1e-300, 0.25, 1.0 / 3.0, 0.5, 1.0 - 1e-16, 1.0})
      EXPECT_TRUE(same_bits(arc.at(t), slerp_short_arc(from, to, t))) << t;
  }
}

}  // namespace
}  // namespace sinew
