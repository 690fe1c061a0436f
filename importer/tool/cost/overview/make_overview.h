// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "importer/tool/cost/overview/overview.h"
#include "importer/tool/cost/report.h"
#include "importer/tool/cost/subject.h"

namespace sinew::cost {

/// Makes the first screen of a report, with pictures where the viewer lies beside this program and finds a device.
/// in   groups  measured;   file  as the user wrote it; empty for a built-in scene, which is neither drawn nor compiled
/// cost some hundred frames, and some seconds of the viewer
Overview make_overview(std::span<const Group> groups, const Subject& subject, const std::string& file);

}  // namespace sinew::cost
