// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Work to time: one run over `item_count` joints or vertices. Runs must not depend on each other.
struct Work {
  std::size_t item_count = 1;
  std::function<void()> run;
  std::function<void()> before = {}, after = {};  ///< called around many runs, not timed
};

/// A group in the making: the errors of its points are known, the times are not yet.
struct Study {
  Group group;
  std::vector<Work> works;                                         ///< parallel to the group's points
  std::function<std::vector<std::string>(const Group&)> findings;  ///< called when the times are known

  void add(Point point, Work work) {
    group.points.push_back(std::move(point));
    works.push_back(std::move(work));
  }
};

/// Marks a study that does not apply to the subject; the report says why.
inline Study left_out(Study study, std::string why) {
  study.group.left_out = std::move(why);
  return study;
}

/// How long to measure: a few repetitions for a first impression, or enough for reliable numbers.
struct Effort {
  int repetitions = 15;
  double seconds_per_repetition = 0.02;
  std::size_t key_intervals = 64;   ///< number of a clip's key intervals that are measured
  std::size_t probe_points = 4000;  ///< number of points of the surface that are measured

  static Effort quick() { return {7, 0.004, 16, 1000}; }
};

}  // namespace sinew::cost
