// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "importer/tool/exit_code.h"
#include "importer/tool/verify/pose_history.h"

namespace sinew::tool {

/// The largest difference of each sample of a clip, over its tolerance: above 1 the sample has failed.
struct DifferenceOverTime {
  std::string clip;
  std::vector<double> times_s, ratios;
};

/// Findings of `sinew verify` about one file.
struct VerifiedFile {
  std::string file, golden;
  ExitCode code = ExitCode::done;
  std::uint64_t compared = 0, failed = 0;
  double largest_m = 0.0, seconds = 0.0;
  std::vector<Deviation> worst;    ///< the worst first
  std::vector<std::string> lines;  ///< `worst` as the program prints it
  std::vector<DifferenceOverTime> over_time;
  PoseHistory history;
  std::string picture;  ///< PNG of the worst pose as it is now; empty without a viewer

  bool moved() const { return code != ExitCode::cannot_read && failed > 0; }
};

/// Collects findings. Files may be added from several threads.
class VerifyReport {
 public:
  void add(VerifiedFile file);
  std::vector<VerifiedFile> take();  ///< all files, in the order of their names

 private:
  std::mutex mutex_;
  std::vector<VerifiedFile> files_;
};

/// The findings as JUnit XML: a test case for each file. A file that has moved is a failure, and one that cannot be
/// compared an error.
std::string junit_report(std::span<const VerifiedFile> files);

/// The findings as one HTML page without other files: what failed first, and of that the farthest out of tolerance.
/// limits  curves and figures of the first 50 files that moved, so that a page can be opened
std::string verify_page(std::span<const VerifiedFile> files);

}  // namespace sinew::tool
