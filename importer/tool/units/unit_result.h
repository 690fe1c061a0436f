// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace sinew::tool {

/// The outcome of a unit. It is one line of JSON in a file of its own, named by the unit's id.
struct UnitResult {
  std::string name;
  int status = 0;  ///< exit status of the command; 128 + N if signal N ended it
  std::string output;
  double seconds = 0.0;

  /// The last line that the command printed, which says what was wrong.
  std::string last_line() const;
};

/// The file of a unit's result.
std::filesystem::path result_file(const std::filesystem::path& out, const std::string& id);

/// Empty if there is no whole result.
std::optional<UnitResult> read_result(const std::filesystem::path& file);

/// Writes a result. The file appears complete or not at all, also if the process is killed.
/// out  false if it cannot be written
bool write_result(const std::filesystem::path& file, const UnitResult& result);

}  // namespace sinew::tool
