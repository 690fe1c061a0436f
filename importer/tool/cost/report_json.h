// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// The whole report as JSON; numbers that are not finite become null.
nlohmann::ordered_json report_json(const Report& report);

/// The report as CSV: a header, then one row per point with group, name, error, unit, time, spread, flags, size, and
/// further values as NAME=VALUE.
std::string report_csv(const Report& report);

/// The report as one HTML page without other files: the template with the JSON in it.
std::string report_page(const Report& report);

}  // namespace sinew::cost
