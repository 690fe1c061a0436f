// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace sinew::tool {

/// While an object of this class lives, results and messages of its thread are kept instead of printed, and progress
/// is silent. So commands print as if they were alone, and files that are worked on side by side are shown in order.
/// One thread has at most one; it does not reach other threads.
class CapturedOutput {
 public:
  CapturedOutput();
  ~CapturedOutput();
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  /// The one of this thread; null where output is printed.
  static CapturedOutput* current() noexcept;

  std::string results, messages;
};

}  // namespace sinew::tool
