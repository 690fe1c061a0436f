// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/support/json.h"

namespace sinew::test {

/// Reference data, of the project (tests/numeric) and of the corpus (its folder numeric/): cases by kind, each with
/// input, truth and what is accepted.

/// The answer of a kernel, under the names that the truth uses: "q", "m", "p", ...
using Outcome = std::map<std::string, std::vector<double>>;

/// One implementation of a kind in one precision. It returns an empty outcome for cases that it does not cover.
struct NumericVariant {
  std::string name;
  std::function<Outcome(const Json& in)> run;
};

/// All cases of the files of `kind`; empty without such a file.
std::vector<Json> numeric_cases(const std::string& kind);

/// Kinds of all files, sorted, each once.
std::vector<std::string> numeric_kinds();

/// How a variant did over cases.
struct NumericReport {
  int run = 0;
  int failed = 0;
  double worst = 0;  ///< largest error, in units of the allowed error
  std::string worst_case;
  std::string failures;  ///< the first few, one per line
};

/// Runs every case and measures it with numeric_miss (numeric_metrics.h).
NumericReport run_numeric(const std::vector<Json>& cases, const NumericVariant& variant);

}  // namespace sinew::test
