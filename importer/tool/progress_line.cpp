// SPDX-License-Identifier: MIT
#include "importer/tool/progress_line.h"

#include <algorithm>
#include <cstdio>

#include <fmt/core.h>

#include "importer/platform/program.h"
#include "importer/tool/batch/captured_output.h"

namespace sinew::tool {
namespace {
constexpr std::chrono::milliseconds kQuiet{300};  // work shorter than this shows nothing
constexpr std::chrono::milliseconds kInterval{100};
}  // namespace

ProgressLine::ProgressLine()
    : terminal_(CapturedOutput::current() == nullptr && platform::is_terminal(platform::kStandardError)),
      next_(Clock::now() + kQuiet) {}

ProgressLine::~ProgressLine() { wipe(); }

void ProgressLine::show(std::string_view work, double done_0_to_1) {
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + kInterval;
  visible_ = true;
  fmt::print(stderr, "\r\033[K{:3.0f} %  {}", 100.0 * std::clamp(done_0_to_1, 0.0, 1.0), work);
  std::fflush(stderr);
}

void ProgressLine::wipe() {
  if (!visible_) return;
  visible_ = false;
  next_ = Clock::now();
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

}  // namespace sinew::tool
