// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace sinew::tool {

/// While an object of this class lives, results and messages of its thread are kept instead of printed, and progress is
/// silent. Commands can then print as usual, while files that are processed side by side are shown in order. A thread
/// has at most one such object, which does not affect other threads.
class CapturedOutput {
 public:
  CapturedOutput();
  ~CapturedOutput();
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  /// The object of this thread; null if output is printed directly.
  static CapturedOutput* current() noexcept;

  std::string results, messages;
};

}  // namespace sinew::tool
