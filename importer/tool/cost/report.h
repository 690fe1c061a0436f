// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/tool/cost/overview/overview.h"

namespace sinew::cost {

/// A further number of a point, for the table.
struct Value {
  std::string name;
  double value = 0.0;
  std::string unit;
};

/// One way to do the work of its group: its cost and its error.
struct Point {
  std::string name;
  double error = 0.0;          ///< the largest error that was found, in Group::error_unit
  double time_ns = 0.0;        ///< per Group::item, median
  double spread = 0.0;         ///< interquartile range of the repetitions divided by their median
  bool noisy = false;          ///< spread above kNoisySpread: the time is only a hint
  bool is_default = false;     ///< the way that sinew uses by default
  bool other_aim = false;      ///< intends another result, so its error is no fault; never on the front
  bool pareto = false;         ///< on the Pareto front (mark_pareto_front in measure.h)
  std::optional<double> size;  ///< in Group::size_unit, if the group has one
  std::vector<Value> values;   ///< further values, with the same names in all points of a group
  std::string note;
};

inline constexpr double kNoisySpread = 0.10;

/// Several ways to do the same work.
struct Group {
  std::string name, title;
  std::string question;               ///< the question that the chart answers
  std::string about;                  ///< what was measured, and what counts as truth
  std::string left_out;               ///< why there are no points for this file; else empty
  std::vector<std::string> findings;  ///< sentences that put the numbers into words
  std::string error_name, error_unit;
  double rounding = 0.0;  ///< errors below this differ only by rounding, and count as equal
  std::string item;       ///< the time is per item: "joint", "vertex", "frame"
  std::string size_unit;  ///< not empty: the chart shows the size instead of the time
  std::vector<Point> points;

  double error_or_rounding(const Point& point) const { return std::max(point.error, rounding); }
  /// The cost that the chart and the Pareto front use: the size where the group has one, else the time.
  double cost_of(const Point& point) const { return size_unit.empty() ? point.time_ns : point.size.value_or(0.0); }
};

struct Report {
  std::string subject;                                       ///< the file and its size
  std::vector<std::pair<std::string, std::string>> machine;  ///< processor, compiler, ...
  std::string command;                                       ///< the command that makes this report
  std::vector<Group> groups;
  std::optional<Overview> overview;  ///< empty for a geometry cache, whose page has one group
};

}  // namespace sinew::cost
