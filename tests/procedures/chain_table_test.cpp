// SPDX-License-Identifier: MIT
// Residuals by solver and number of iterations. They are compared with the usual budget of engines: four iterations of
// CCD in which a joint turns by at most 2 degrees.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/procedures/chains.h"

namespace sinew::test {
namespace {

/// Mean residual of 200 random chains of 1 m.
double mean_left(ChainSolver solver, std::uint32_t count, std::uint32_t iterations, float most_turn_rad) {
  FixedRandom random(count);
  double sum = 0.0;
  constexpr int kRuns = 200;
  for (int i = 0; i < kRuns; ++i) {
    Posed posed = random_chain(random, count);
    const Vec3<double> target = random.direction<double>() * random.in(0.3, 0.9);
    const std::vector joints = all_joints(count);
    const std::array effectors{ChainEffector{.joint = count, .target = target}};
    sum += static_cast<double>(ChainRun{posed,
                                        {.joints = joints,
                                         .effectors = effectors,
                                         .solver = solver,
                                         .iterations = iterations,
                                         .most_turn_rad = most_turn_rad,
                                         .tolerance = 0.0f}}()
                                   .metres_left);
  }
  return sum / kRuns;
}

TEST(chain_table, every_solver_leaves_less_than_the_common_budget_at_equal_iterations) {
  for (const std::uint32_t count : {4u, 8u, 28u}) {
    const double common = mean_left(ChainSolver::ccd, count, 4, glm::radians(2.0f));
    std::printf("%2u joints, common budget %.4f m\n", count, common);
    for (const ChainSolver solver : kSolvers) {
      double last = 1.0;
      for (const std::uint32_t iterations : {1u, 2u, 4u, 8u, 16u}) {
        const double left = mean_left(solver, count, iterations, 0.0f);
        std::printf("  solver %d, %2u iterations: %.2e m\n", static_cast<int>(solver), iterations, left);
        EXPECT_LE(left, last * 1.01 + 1e-7) << "more iterations leave no more";
        last = left;
        if (iterations == 4) {
          EXPECT_LT(left, 0.6 * common);
        }
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
