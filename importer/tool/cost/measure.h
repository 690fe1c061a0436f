// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <span>

#include "importer/tool/cost/study.h"

namespace sinew::cost {

/// Fills in time and spread of all points of all studies: medians over repetitions. Their order is random, so a
/// disturbance of the machine affects all points alike. Then marks the Pareto fronts and lets each study write its
/// findings.
/// in    progress   called now and then with the share that is done; may be empty
/// cost  about repetitions * (seconds_per_repetition + one run) per point, on the calling thread
void measure(std::span<Study> studies, const Effort& effort, const std::function<void(double done_0_to_1)>& progress);

/// Sets Point::pareto of all points: true if no other point is better in error or in cost and as good in the other.
/// Errors below Group::rounding count as equal. Of two points that are equal in both, both are on the
/// front. Points of another aim are neither on the front nor compared with.
void mark_pareto_front(Group& group);

/// The median of `values`, and their interquartile range divided by it. Sorts the values.
struct Middle {
  double median = 0.0, spread = 0.0;
};
Middle middle_of(std::span<double> values);

}  // namespace sinew::cost
