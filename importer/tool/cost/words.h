// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Share by which costs must differ to be worth a word: the same work at another place in memory differs by as much.
inline constexpr double kNoDifference = 0.05;

/// Three digits: "0.0123", "4.56", "1234", "3.4e-07".
std::string number(double value);

/// A length that a person can picture: "84.7 mm", "0.35 um".
std::string length(double mm);

/// A number of the group's errors with its unit, or "nothing" for 0; angles that nobody sees as their limit.
std::string error_of(const Group& group, const Point& point);

/// The text with a capital letter first.
std::string sentence(std::string text);

/// "4.1 ns a joint"
std::string time_of(const Group& group, const Point& point);

/// "saves 0.41 ns a joint", "costs 3.2 ns a joint more", "takes as long": the time of one beside another's. Differences
/// below the noise of both, or below kNoDifference, count as none.
std::string time_beside(const Group& group, const Point& point, const Point& other);

/// The group's default; the first point where none is marked.
const Point& default_of(const Group& group);

/// The point of that name, or null.
const Point* find(const Group& group, const std::string& name);

/// The cheapest point that aims at the same result and whose error is at most `most`; the default unless another is
/// clearly cheaper, by more than the noise of both. Null where there is none.
const Point* cheapest_within(const Group& group, double most);

}  // namespace sinew::cost
