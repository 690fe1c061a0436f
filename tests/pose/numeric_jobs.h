// SPDX-License-Identifier: MIT
#pragma once
#include "tests/support/numeric_corpus.h"

namespace sinew::test {

/// One kind of reference data, computed by a whole job from a compiled clip with SIMD kernels.
struct NumericJob {
  std::string kind;
  std::function<Outcome(const Json& in)> run;
};

/// The kinds that concern poses: slerp, nlerp (a blend of two layers), squad, hermite, trs_compose.
std::vector<NumericJob> pose_jobs();

/// The kinds that concern vertices: lbs, dqs, cor, candy_wrapper, normal_transform, morph.
std::vector<NumericJob> vertex_jobs();

}  // namespace sinew::test
