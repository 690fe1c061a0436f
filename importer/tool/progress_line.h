// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <string_view>

namespace sinew::tool {

/// One line on the terminal that shows the progress of long work. It is silent if stderr is not a terminal, in a job
/// that runs beside others, and during the first moment, so that quick work prints nothing.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  ///< wipes the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::string_view work, double done_0_to_1);
  void wipe();  ///< before a message is printed; the next show() draws the line again at once

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_ = false;
  bool visible_ = false;
  Clock::time_point next_;
};

}  // namespace sinew::tool
