// SPDX-License-Identifier: MIT
// Runs reference data of this project and of the corpus through whole jobs, on every instruction set of the machine.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/pose/numeric_jobs.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

/// How GoogleTest and CTest name the test of a kind on a target.
struct JobOnTarget {
  NumericJob job;
  std::int64_t target;
};
void PrintTo(const JobOnTarget& on, std::ostream* out) { *out << on.job.kind << " on " << simd_name(on.target); }

std::vector<JobOnTarget> on_all_targets(const std::vector<NumericJob>& jobs) {
  std::vector<JobOnTarget> all;
  for (const NumericJob& job : jobs)
    for (const std::int64_t target : simd_targets()) all.push_back({job, target});
  return all;
}

/// The cases that a job can compute. For squad only the rotation: its control points are part of the compiled clip.
std::vector<Json> cases_for_jobs(const std::string& kind) {
  std::vector<Json> cases = numeric_cases(kind);
  if (kind == "squad")
    for (Json& c : cases)
      c["accept"] = {{"metric", "rotation_angle"}, {"tol", c["accept"]["tol"]}, {"norm_tol", c["accept"]["norm_tol"]}};
  return cases;
}

void expect_all_cases(const JobOnTarget& on) {
  const auto cases = cases_for_jobs(on.job.kind);
  if (cases.empty()) GTEST_SKIP() << "only a corpus has cases of kind " << on.job.kind;
  const OnlyTarget only(on.target);
  const NumericReport report = run_numeric(cases, {on.job.kind, on.job.run});
  std::printf("  %s on %s: %d cases, worst %.3f of the tolerance (%s)\n", on.job.kind.c_str(),
              simd_name(on.target).c_str(), report.run, report.worst, report.worst_case.c_str());
  EXPECT_EQ(report.run, static_cast<int>(cases.size()));
  EXPECT_EQ(report.failed, 0) << report.failures;
}

class pose_jobs_truth : public ::testing::TestWithParam<JobOnTarget> {};
TEST_P(pose_jobs_truth, N01_N02_N03_N07_N08_N09_G03_G04_every_case_holds) { expect_all_cases(GetParam()); }
INSTANTIATE_TEST_SUITE_P(targets, pose_jobs_truth, ::testing::ValuesIn(on_all_targets(pose_jobs())));

class vertex_jobs_truth : public ::testing::TestWithParam<JobOnTarget> {};
TEST_P(vertex_jobs_truth, N17_N18_N19_N20_N21_N22_N23_G42_every_case_holds) { expect_all_cases(GetParam()); }
INSTANTIATE_TEST_SUITE_P(targets, vertex_jobs_truth, ::testing::ValuesIn(on_all_targets(vertex_jobs())));

}  // namespace
}  // namespace sinew::test
