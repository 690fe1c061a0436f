// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstddef>
#include <string>

#include "importer/tool/progress_line.h"

namespace sinew::tool {

/// "about 40 s left", in the unit that suits.
std::string time_left_text(double seconds);

/// The progress of many files on a terminal: how many are done, how many a second, and how long the others may take.
class BatchProgress {
 public:
  explicit BatchProgress(std::size_t files) : files_(files), begin_(Clock::now()) {}

  void show(std::size_t done);
  void hide() { line_.wipe(); }  ///< before something else is printed; the next show() draws again at once

 private:
  using Clock = std::chrono::steady_clock;
  ProgressLine line_;
  std::size_t files_;
  Clock::time_point begin_;
};

}  // namespace sinew::tool
