// SPDX-License-Identifier: MIT
#include "importer/tool/verify/verify_report.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

/// Text of an XML attribute or element. Characters that XML forbids become question marks.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\n': out += "&#10;"; break;
      default: out += static_cast<unsigned char>(c) < 0x20 && c != '\t' ? '?' : c;
    }
  }
  return out;
}

std::string test_case(const VerifiedFile& file) {
  std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", escaped(file.golden),
                                 escaped(file.file), file.seconds);
  if (file.code == ExitCode::done) return text + "/>\n";
  std::string lines;
  for (const std::string& line : file.lines) lines += escaped(line) + "\n";
  if (file.code == ExitCode::input_at_fault && file.failed > 0)
    return text + fmt::format(
                      ">\n      <failure message=\"{} of {} values out of tolerance, largest distance {:.3g} m\">{}"
                      "</failure>\n    </testcase>\n",
                      file.failed, file.compared, file.largest_m, lines);
  return text + fmt::format(">\n      <error message=\"nothing was compared\">{}</error>\n    </testcase>\n",
                            lines.empty() ? "the file or its golden poses cannot be read; the log says why" : lines);
}

}  // namespace

void VerifyReport::add(VerifiedFile file) {
  const std::lock_guard lock(mutex_);
  files_.push_back(std::move(file));
}

std::vector<VerifiedFile> VerifyReport::take() {
  const std::lock_guard lock(mutex_);
  std::stable_sort(files_.begin(), files_.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  return std::exchange(files_, {});
}

std::string junit_report(std::span<const VerifiedFile> files) {
  std::size_t failures = 0, errors = 0;
  double seconds = 0.0;
  std::string cases;
  for (const VerifiedFile& file : files) {
    const bool moved = file.code == ExitCode::input_at_fault && file.failed > 0;
    failures += moved;
    errors += file.code != ExitCode::done && !moved;
    seconds += file.seconds;
    cases += test_case(file);
  }
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", files.size(),
                                         failures, errors, seconds);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"sinew verify\" {}>\n"
      "  <testsuite name=\"sinew verify\" {}>\n{}  </testsuite>\n</testsuites>\n",
      counts, counts, cases);
}

}  // namespace sinew::tool
