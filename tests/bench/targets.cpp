// SPDX-License-Identifier: MIT
#include "tests/bench/targets.h"

#include <algorithm>
#include <cctype>

#include "tests/support/simd_targets.h"

namespace sinew::bench {
namespace {

std::string name_of(std::int64_t target) {
  std::string name = test::simd_name(target);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

}  // namespace

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (const std::int64_t target : test::simd_targets()) names.push_back(name_of(target));
  return names;
}

bool choose_target(std::string_view name) {
  test::allow_all_targets();  // an earlier choice would hide the others
  for (const std::int64_t target : test::simd_targets()) {
    if (name_of(target) != name) continue;
    test::allow_only(target);
    return true;
  }
  return false;
}

std::string compiler() {
#if defined(__clang__)
  const std::string name = "clang++ " __clang_version__;
#else
  const std::string name = "g++ " __VERSION__;
#endif
#if defined(__OPTIMIZE__)
  return name;
#else
  return name + " without optimisation";
#endif
}

}  // namespace sinew::bench
