// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "importer/tool/units/unit_result.h"

namespace sinew::tool {

/// The results of all units of a batch. Equal results give equal texts, to the byte: no text names a time, a machine or
/// a shard.
struct UnitReport {
  struct Row {
    std::string name;
    std::optional<UnitResult> result;  ///< empty: the unit was not run
  };

  std::string command;
  std::vector<Row> rows;  ///< in the order of the units

  std::size_t failed() const;
  std::size_t missing() const;
};

std::string report_json(const UnitReport& report);
/// A line for each unit: name, status, last line of its output.
std::string report_csv(const UnitReport& report);
/// A page without other files: failures first, each with its output.
std::string report_html(const UnitReport& report);

}  // namespace sinew::tool
