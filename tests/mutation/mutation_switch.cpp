// SPDX-License-Identifier: MIT
#include "tests/mutation/mutation_switch.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bitset>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace hwy {
// Weak, because programs without kernels do not link it.
[[gnu::weak]] void DisableTargets(decltype(SupportedTargets()) targets);
}  // namespace hwy

extern "C" {
int sinew_mutant = 0;
}

namespace {

constexpr int kMutantLimit = 1 << 16;
struct Reached {
  std::bitset<kMutantLimit> mutants;
  std::set<std::string> shaders;  // shader stages that were loaded
};
Reached reached;

// Runs before other static constructors, which may already run mutated code.
[[gnu::constructor(101)]] void read_environment() {
  if (const char* number = std::getenv("SINEW_MUTANT")) sinew_mutant = std::atoi(number);
  // Mutated kernels are compiled only for AVX2 and the basic set (mutated_build.py), so the other sets are disabled.
  if (hwy::DisableTargets != nullptr) hwy::DisableTargets(HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL);
}

/// Writes one line per test: its name, its milliseconds, the numbers of the mutants it reached and the shaders it
/// loaded.
class Recorder : public testing::EmptyTestEventListener {
 public:
  explicit Recorder(const char* path) : out_(path) {}

  void OnTestSuiteStart(const testing::TestSuite&) override {
    reached = {};
    in_suite_ = false;
  }

  /// Every test of a suite also reaches what its suite's setup reached.
  void OnTestStart(const testing::TestInfo&) override {
    if (!in_suite_) of_suite_ = reached;
    in_suite_ = true;
    reached = of_suite_;
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    const testing::TestResult& result = *test.result();
    const char* state = result.Skipped() ? "skipped" : result.Passed() ? "passed" : "failed";
    out_ << test.test_suite_name() << '.' << test.name() << ' ' << state << ' ' << result.elapsed_time();
    for (int number = 0; number < kMutantLimit; ++number)
      if (reached.mutants[number]) out_ << ' ' << number;
    for (const std::string& shader : reached.shaders) out_ << ' ' << shader;
    out_ << std::endl;
  }

  /// If this line is missing, the program did not run to its end.
  void OnTestProgramEnd(const testing::UnitTest&) override { out_ << kEnd << std::endl; }

 private:
  static constexpr const char* kEnd = "end";
  std::ofstream out_;
  Reached of_suite_;
  bool in_suite_ = false;
};

/// Fails skipped tests. Only tests that pass without a mutant run under it, so a skip, for example without a device,
/// means that it noticed the mutant.
class SkipFails : public testing::EmptyTestEventListener {
 public:
  void OnTestEnd(const testing::TestInfo& test) override {
    if (test.result()->Skipped()) std::_Exit(1);
  }
};

const bool recording = [] {
  const char* path = std::getenv("SINEW_MUTATION_RECORD");
  if (path == nullptr) {
    const bool mutated = sinew_mutant > 0 || std::getenv("SINEW_MUTANT_SHADERS") != nullptr;
    if (mutated) testing::UnitTest::GetInstance()->listeners().Append(new SkipFails);
    return false;
  }
  testing::UnitTest::GetInstance()->listeners().Append(new Recorder(path));
  ::unsetenv("SINEW_MUTATION_RECORD");  // else programs that tests start would overwrite the file
  return true;
}();

}  // namespace

extern "C" void sinew_mutant_is_reached(int number) noexcept { reached.mutants.set(static_cast<std::size_t>(number)); }

/// The SPIR-V of a mutated shader from the folder SINEW_MUTANT_SHADERS; empty if the shader is not mutated.
std::span<const std::uint32_t> mutated_shader(const char* name) {
  const char* folder = std::getenv("SINEW_MUTANT_SHADERS");
  if (folder == nullptr) {
    reached.shaders.insert(name);
    return {};
  }
  static std::map<std::string, std::unique_ptr<std::vector<std::uint32_t>>> files;
  auto& words = files[name];
  if (!words) {
    words = std::make_unique<std::vector<std::uint32_t>>();
    std::ifstream in(std::string(folder) + "/" + name + ".spv", std::ios::binary);
    for (std::uint32_t word; in.read(reinterpret_cast<char*>(&word), sizeof(word));) words->push_back(word);
  }
  return *words;
}
