// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/compress/key_lists.h"
#include "runtime/compress/truth_samples.h"

namespace sinew {

/// Leaves out more keys, as long as no virtual vertex of the whole pose is farther off than the budget. Tracks that
/// share a list of key times lose a key together, with its time: a row. The first rounds take only rows whose loss
/// leaves a part of the budget, so that the cheapest go first. First and last keys stay, as do both sides of a jump.
/// in   stored   the keys as a reader of the file will see them;   samples  of the truth, at the times that count
///      tracks   hold the budget, and after it, too
/// cost O(rows x times between two keys x J); stops after kMostWork steps of that kind
void drop_rows(const Animation& stored, const TruthSamples& samples, double budget_m, std::vector<KeptKeys>& tracks);

}  // namespace sinew
