// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sinew::cost {

/// A further number of a point, for the table and the details.
struct Value {
  std::string name;
  double value = 0.0;
  std::string unit;
};

/// One way of doing the work of its group: what it costs and how far it is from the truth.
struct Point {
  std::string name;
  double error = 0.0;       ///< in Group::error_unit, the largest over everything looked at
  double time_ns = 0.0;     ///< per Group::item, median
  double spread = 0.0;      ///< interquartile range of the repetitions over their median
  bool noisy = false;       ///< spread above kNoisySpread: the time is a hint only
  bool is_default = false;  ///< what sinew does unless it is told otherwise
  bool other_aim = false;   ///< means to give another result: its error is a difference in kind, so it is on no front
  bool pareto = false;      ///< no other point is better in one of error and cost and as good in the other
  std::optional<double> size;  ///< in Group::size_unit, of groups that have one
  std::vector<Value> values;   ///< the same names in all points of a group
  std::string note;
};

inline constexpr double kNoisySpread = 0.10;

/// Ways of doing the same work.
struct Group {
  std::string name, title;
  std::string question;               ///< the one that the chart answers
  std::string about;                  ///< what was done, and what counts as truth
  std::string left_out;               ///< why the group says nothing about this file; then there are no points
  std::vector<std::string> findings;  ///< sentences that say what the numbers say
  std::string error_name, error_unit;
  double rounding = 0.0;  ///< errors below this are chance: none of them is better than another
  std::string item;       ///< what the time is per: "joint", "vertex", "frame"
  std::string size_unit;  ///< not empty: the chart shows the size, and the time is in the table
  std::vector<Point> points;

  double telling_error_of(const Point& point) const { return std::max(point.error, rounding); }
  /// What the chart's other axis shows, and the front is about.
  double cost_of(const Point& point) const { return size_unit.empty() ? point.time_ns : point.size.value_or(0.0); }
};

struct Report {
  std::string subject;                                       ///< the file, and how large it is
  std::vector<std::pair<std::string, std::string>> machine;  ///< processor, compiler, ...
  std::string command;                                       ///< that gives this report again
  std::vector<Group> groups;
};

}  // namespace sinew::cost
