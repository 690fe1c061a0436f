// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Work that is timed: one run over `item_count` joints or vertices. It must not depend on earlier runs.
struct Work {
  std::size_t item_count = 1;
  std::function<void()> run;
  std::function<void()> before = {}, after = {};  ///< around many runs, not timed
};

/// A group on its way: the errors of its points are known, their times are not.
struct Study {
  Group group;
  std::vector<Work> works;                                         ///< parallel to the group's points
  std::function<std::vector<std::string>(const Group&)> findings;  ///< once the times are known

  void add(Point point, Work work) {
    group.points.push_back(std::move(point));
    works.push_back(std::move(work));
  }
};

/// How long to look: few repetitions for a first impression, or enough of them for numbers worth keeping.
struct Effort {
  int repetitions = 15;
  double seconds_per_repetition = 0.02;
  std::size_t key_intervals = 64;   ///< of a clip, looked at between its keys
  std::size_t probe_points = 4000;  ///< of the model's surface

  static Effort quick() { return {7, 0.004, 16, 1000}; }
};

}  // namespace sinew::cost
