// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/support/json.h"

namespace sinew::test {

/// Reference data for kernels, from tests/numeric and from the corpus's folder numeric/. Each case has a kind, an
/// input, the true result and a tolerance.

/// The result of a kernel, by the names of the truth's values: "q", "m", "p", ...
using Outcome = std::map<std::string, std::vector<double>>;

/// One implementation of a kind of kernel in one precision. It returns an empty outcome for cases that it does not
/// support.
struct NumericVariant {
  std::string name;
  std::function<Outcome(const Json& in)> run;
};

/// All cases of one kind; empty if no file has that kind.
std::vector<Json> numeric_cases(const std::string& kind);

/// All kinds, sorted, each once.
std::vector<std::string> numeric_kinds();

/// Result of one variant over many cases.
struct NumericReport {
  int run = 0;
  int failed = 0;
  double worst = 0;  ///< largest error, in units of the allowed error
  std::string worst_case;
  std::string failures;  ///< the first few, one per line
};

/// Runs every case and measures its error with numeric_miss() (numeric_metrics.h).
NumericReport run_numeric(const std::vector<Json>& cases, const NumericVariant& variant);

}  // namespace sinew::test
