// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/math/numeric_variants.h"

namespace sinew::test {

std::vector<NumericKind> all_numeric_kinds() {
  return {slerp_kind(),
          nlerp_kind(),
          squad_kind(),
          hermite_kind(),
          quat_log_exp_pow_kind(),
          axis_angle_kind(),
          euler_kind(),
          quat_to_matrix_kind(),
          matrix_to_quat_kind(),
          vector_to_vector_kind(),
          trs_compose_kind(),
          decompose_kind(),
          normal_transform_kind(),
          projection_kind(),
          depth_kind(),
          hast_kind(),
          lbs_kind(),
          dqs_kind(),
          cor_kind(),
          candy_wrapper_kind(),
          morph_kind()};
}

namespace {

class numeric_truth : public ::testing::TestWithParam<NumericKind> {
 protected:
  void SetUp() override {
    cases_ = numeric_cases(GetParam().kind);
    if (cases_.empty()) GTEST_SKIP() << "only a corpus has cases of kind " << GetParam().kind;
  }

  std::vector<Json> cases_;
};

TEST_P(numeric_truth, careful_kernels_hold_every_case) {
  ASSERT_FALSE(GetParam().careful.empty());
  for (const NumericVariant& variant : GetParam().careful) {
    const NumericReport report = run_numeric(cases_, variant);
    RecordProperty(variant.name, std::to_string(report.worst));
    std::printf("  %-18s %-34s %4d cases, worst %.3f of the tolerance (%s)\n", GetParam().kind.c_str(),
                variant.name.c_str(), report.run, report.worst, report.worst_case.c_str());
    EXPECT_EQ(report.run, static_cast<int>(cases_.size())) << variant.name << " left cases out";
    EXPECT_EQ(report.failed, 0) << variant.name << " of " << report.run << " cases:\n" << report.failures;
  }
}

TEST_P(numeric_truth, naive_variants_fail_so_the_cases_bite) {
  for (const NumericVariant& variant : GetParam().naive) {
    const NumericReport report = run_numeric(cases_, variant);
    std::printf("  %-18s %-34s fails %d of %d, worst in %s\n", GetParam().kind.c_str(), variant.name.c_str(),
                report.failed, report.run, report.worst_case.c_str());
    EXPECT_GT(report.failed, 0) << variant.name << " passed all " << report.run << " cases";
  }
}

INSTANTIATE_TEST_SUITE_P(kinds, numeric_truth, ::testing::ValuesIn(all_numeric_kinds()));

TEST(numeric_truth_folders, every_kind_is_known_here) {
  std::string unknown;
  const auto known = all_numeric_kinds();
  for (const std::string& kind : numeric_kinds())
    if (std::none_of(known.begin(), known.end(), [&](const NumericKind& k) { return k.kind == kind; }))
      unknown += " " + kind;
  if (!unknown.empty()) GTEST_SKIP() << "kinds without an implementation to run, not tested:" << unknown;
  EXPECT_GE(numeric_kinds().size(), 16u) << "the project's own";
}

}  // namespace
}  // namespace sinew::test
