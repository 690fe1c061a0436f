// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// The reason why `folder` cannot become the folder of a report; empty if it can. It may be new, empty, or hold nothing
/// but an older report.
/// in    inputs   files that are read; none of them is replaced
std::string find_folder_error(const std::filesystem::path& folder, std::span<const std::filesystem::path> inputs);

/// Writes report.json, report.csv and report.html into `folder`. The folder appears complete or not at all: an older
/// report stays until the new one is there.
/// out   nothing, or why it could not be written
std::optional<std::string> write_report(const Report& report, const std::filesystem::path& folder);

}  // namespace sinew::cost
