// SPDX-License-Identifier: MIT
#pragma once
#include "tests/support/numeric_corpus.h"

namespace sinew::test {

/// One kind of reference data through a whole job: what a compiled clip and the SIMD kernels make of each case.
struct NumericJob {
  std::string kind;
  std::function<Outcome(const Json& in)> run;
};

/// Kinds that poses are made of: slerp, nlerp (a blend of two layers), squad, hermite, trs_compose.
std::vector<NumericJob> pose_jobs();

/// Kinds that vertices are made of: lbs, dqs, cor, candy_wrapper, normal_transform, morph.
std::vector<NumericJob> vertex_jobs();

}  // namespace sinew::test
