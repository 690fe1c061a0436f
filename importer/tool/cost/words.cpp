// SPDX-License-Identifier: MIT
#include "importer/tool/cost/words.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "importer/tool/length_text.h"

namespace sinew::cost {
namespace {

/// The fraction by which a time may be wrong.
double noise_of(const Point& point) { return std::max(kNoDifference, point.spread); }

}  // namespace

std::string number(double value) {
  const double size = std::abs(value);
  if (size > 0.0 && (size < 1e-5 || size >= 1e6)) return fmt::format("{:.1e}", value);
  const int decimals = size == 0.0 || size >= 100.0 ? 0 : 2 - static_cast<int>(std::floor(std::log10(size)));
  return fmt::format("{:.{}f}", value, decimals);
}

std::string length(double mm) { return tool::length_text(1e-3 * mm); }

std::string sentence(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string error_of(const Group& group, const Point& point) {
  if (group.error_unit == "mm" && point.error > 0.0) return length(point.error);
  if (group.error_unit == "degrees" && point.error > 0.0 && point.error < 1e-4) return "0.0001 degrees";
  return point.error == 0.0 ? "nothing" : fmt::format("{} {}", number(point.error), group.error_unit);
}

std::string time_of(const Group& group, const Point& point) {
  return fmt::format("{} ns a {}", number(point.time_ns), group.item);
}

std::string time_beside(const Group& group, const Point& point, const Point& other) {
  const double difference = point.time_ns - other.time_ns;
  if (std::abs(difference) <= std::max(noise_of(point), noise_of(other)) * std::max(point.time_ns, other.time_ns))
    return "takes as long";
  return difference < 0.0 ? fmt::format("saves {} ns a {}", number(-difference), group.item)
                          : fmt::format("costs {} ns a {} more", number(difference), group.item);
}

const Point& default_of(const Group& group) {
  for (const Point& point : group.points)
    if (point.is_default) return point;
  return group.points.front();
}

const Point* find(const Group& group, const std::string& name) {
  for (const Point& point : group.points)
    if (point.name == name) return &point;
  return nullptr;
}

const Point* cheapest_within(const Group& group, double most) {
  const Point& standard = default_of(group);
  const bool standard_will_do = standard.error <= most;
  const Point* best = standard_will_do ? &standard : nullptr;
  for (const Point& point : group.points) {
    if (point.other_aim || !(point.error <= most)) continue;
    const double noise = group.size_unit.empty() ? std::max(noise_of(point), noise_of(standard)) : 0.0;
    const bool clearly = !standard_will_do || group.cost_of(point) < (1.0 - noise) * group.cost_of(standard);
    if (clearly && (best == nullptr || group.cost_of(point) < group.cost_of(*best))) best = &point;
  }
  return best;
}

}  // namespace sinew::cost
