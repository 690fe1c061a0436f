// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// The whole report; numbers that are not finite become null.
nlohmann::ordered_json report_json(const Report& report);

/// A header and one row per point: group, name, error, unit, time, spread, flags, size, and what else is known as
/// NAME=VALUE.
std::string report_csv(const Report& report);

/// One page that needs nothing else: the template with the JSON in it.
std::string report_page(const Report& report);

}  // namespace sinew::cost
