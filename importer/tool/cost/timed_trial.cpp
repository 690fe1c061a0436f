// SPDX-License-Identifier: MIT
#include "importer/tool/cost/timed_trial.h"

#include <vector>

#include "importer/tool/cost/measure.h"

namespace sinew::cost {

Point timed_point(const nlohmann::json& trial, const char* key, double pixels) {
  std::vector<double> ms = trial.at(key).get<std::vector<double>>();
  const Middle middle = middle_of(ms);
  Point point;
  point.name = trial.at("name");
  point.time_ns = 1e6 * middle.median / pixels;
  point.spread = middle.spread;
  point.noisy = middle.spread > kNoisySpread;
  return point;
}

}  // namespace sinew::cost
