// SPDX-License-Identifier: MIT
#include "importer/tool/batch/batch_progress.h"

#include <algorithm>

#include <fmt/core.h>

namespace sinew::tool {

std::string time_left_text(double seconds) {
  if (seconds < 90.0) return fmt::format("about {:.0f} s left", seconds);
  if (seconds < 90.0 * 60.0) return fmt::format("about {:.0f} min left", seconds / 60.0);
  return fmt::format("about {:.1f} h left", seconds / 3600.0);
}

void BatchProgress::show(std::size_t done) {
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - begin_).count();
  const double rate = static_cast<double>(done) / std::max(elapsed_s, 1e-3);
  const double left_s = static_cast<double>(files_ - done) / std::max(rate, 1e-9);
  line_.show(fmt::format("{} of {} files, {:.{}f} files/s, {}", done, files_, rate, rate < 10.0 ? 1 : 0,
                         time_left_text(left_s)),
             static_cast<double>(done) / static_cast<double>(files_));
}

}  // namespace sinew::tool
