// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Costs that differ by less than this share are called equal: the same work at another address differs by as much.
inline constexpr double kNoDifference = 0.05;

/// A number with three digits: "0.0123", "4.56", "1234", "3.4e-07".
std::string number(double value);

/// A length with a readable unit: "84.7 mm", "0.35 um".
std::string length(double mm);

/// The error of a point with its unit; "nothing" for 0. Angles too small to see are given as their limit.
std::string error_of(const Group& group, const Point& point);

/// The text with a capital first letter.
std::string sentence(std::string text);

/// "4.1 ns a joint"
std::string time_of(const Group& group, const Point& point);

/// The time of one point compared with another's: "saves 0.41 ns a joint", "costs 3.2 ns a joint more", "takes as
/// long". Differences below the noise of both, or below kNoDifference, count as none.
std::string time_beside(const Group& group, const Point& point, const Point& other);

/// The default point of the group; the first point if none is marked.
const Point& default_of(const Group& group);

/// The point with that name, or null.
const Point* find(const Group& group, const std::string& name);

/// The cheapest point that intends the same result and whose error is at most `most`. The default wins unless another
/// is cheaper by more than the noise of both. Null where no point qualifies.
const Point* cheapest_within(const Group& group, double most);

}  // namespace sinew::cost
