// SPDX-License-Identifier: MIT
#pragma once
#include <ostream>

#include "tests/support/numeric_corpus.h"

namespace sinew::test {

/// The implementations that are tested with one kind of reference cases.
struct NumericKind {
  std::string kind;
  std::vector<NumericVariant> careful;  ///< must pass every case: our functions in float and double
  std::vector<NumericVariant> naive;    ///< known mistakes, each of which must fail some case
};

/// Name of the test of a kind in GoogleTest and CTest.
inline void PrintTo(const NumericKind& kind, std::ostream* out) { *out << kind.kind; }

/// The variants of a generic lambda in float and in double.
template <class Kernel>
std::vector<NumericVariant> in_both_precisions(const std::string& name, Kernel kernel) {
  return {{name + ", float", [kernel](const Json& in) { return kernel.template operator()<float>(in); }},
          {name + ", double", [kernel](const Json& in) { return kernel.template operator()<double>(in); }}};
}

NumericKind slerp_kind();
NumericKind nlerp_kind();
NumericKind squad_kind();
NumericKind hermite_kind();
NumericKind quat_log_exp_pow_kind();
NumericKind axis_angle_kind();
NumericKind euler_kind();
NumericKind quat_to_matrix_kind();
NumericKind matrix_to_quat_kind();
NumericKind vector_to_vector_kind();
NumericKind trs_compose_kind();
NumericKind decompose_kind();
NumericKind normal_transform_kind();
NumericKind projection_kind();
NumericKind depth_kind();
NumericKind hast_kind();
NumericKind lbs_kind();
NumericKind dqs_kind();
NumericKind cor_kind();
NumericKind candy_wrapper_kind();
NumericKind morph_kind();

/// All kinds of all numeric_*.cpp files.
std::vector<NumericKind> all_numeric_kinds();

}  // namespace sinew::test
