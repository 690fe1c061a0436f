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
// Not linked by programs without kernels.
[[gnu::weak]] void DisableTargets(decltype(SupportedTargets()) targets);
}  // namespace hwy

extern "C" {
int sinew_mutant = 0;
}

namespace {

constexpr int kMutantLimit = 1 << 16;
struct Reached {
  std::bitset<kMutantLimit> mutants;
  std::set<std::string> shaders;  // the stages that were loaded
};
Reached reached;

// Before other static objects are made, which may already run mutated code.
[[gnu::constructor(101)]] void read_environment() {
  if (const char* number = std::getenv("SINEW_MUTANT")) sinew_mutant = std::atoi(number);
  // Mutated kernels are compiled for AVX2 and the plainest set only (mutated_build.py); the others keep to the same.
  if (hwy::DisableTargets != nullptr) hwy::DisableTargets(HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL);
}

/// Writes one line a test: its name, its milliseconds, the numbers of the mutants that it reached and the shaders that
/// it loaded.
class Recorder : public testing::EmptyTestEventListener {
 public:
  explicit Recorder(const char* path) : out_(path) {}

  void OnTestSuiteStart(const testing::TestSuite&) override {
    reached = {};
    in_suite_ = false;
  }

  /// What a suite sets up once is reached by each of its tests.
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

  /// A record without this line is that of a program that did not come to its end.
  void OnTestProgramEnd(const testing::UnitTest&) override { out_ << kEnd << std::endl; }

 private:
  static constexpr const char* kEnd = "end";
  std::ofstream out_;
  Reached of_suite_;
  bool in_suite_ = false;
};

/// Tests that run under a mutant passed without it: one that is skipped, for example without a device, has noticed it.
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
  ::unsetenv("SINEW_MUTATION_RECORD");  // programs that tests start would begin the file again
  return true;
}();

}  // namespace

extern "C" void sinew_mutant_is_reached(int number) noexcept { reached.mutants.set(static_cast<std::size_t>(number)); }

/// The SPIR-V of a mutated shader from the folder SINEW_MUTANT_SHADERS; empty when the shader is as it was written.
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
