// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "importer/tool/cost/overview/overview.h"
#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// A share of the model's size that a viewer hardly sees, and one that is seen in motion.
inline constexpr double kHardlySeen = 1e-4, kSeen = 1e-3;

/// Chooses what the first screen shows: the kind of skinning, the storage of keys, and one more. That is, of
/// influences, interpolation and morphing, the one that changes the frame's time most. Choices that do not apply are
/// left out.
/// in   evaluation  times of this model: a choice changes its part as it changes the time of its group
std::vector<Choice> find_choices(std::span<const Group> groups, std::span<const FramePart> evaluation, double size_m);

/// Command lines that follow the choices, for a file. Budgets are shares of the model, so they hold in any unit.
/// in   file  as the user wrote it;   groups  those that the choices are made of
std::string recommended_command(std::span<const Choice> choices, std::span<const Group> groups,
                                const std::string& file);

}  // namespace sinew::cost
