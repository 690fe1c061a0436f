// SPDX-License-Identifier: MIT
#include "importer/tool/cost/pareto_front.h"

#include <algorithm>

namespace sinew::cost {

void mark_pareto_front(Group& group) {
  const auto beats = [&](const Point& a, const Point& b) {
    const double cost_a = group.cost_of(a), cost_b = group.cost_of(b);
    const double error_a = group.telling_error_of(a), error_b = group.telling_error_of(b);
    return error_a <= error_b && cost_a <= cost_b && (error_a < error_b || cost_a < cost_b);
  };
  for (Point& point : group.points)
    point.pareto = !point.other_aim && std::none_of(group.points.begin(), group.points.end(), [&](const Point& other) {
      return !other.other_aim && beats(other, point);
    });
}

}  // namespace sinew::cost
