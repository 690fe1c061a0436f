// SPDX-License-Identifier: MIT
#include "importer/tool/cost/measure.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <random>
#include <vector>

namespace sinew::cost {
namespace {

/// Processor time of this thread, which does not count while other programs run.
double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Runs a work `count` times. Returns the seconds of one run.
double seconds_of_run(const Work& work, double count) {
  if (work.before) work.before();
  const double begin = thread_seconds();
  for (double i = 0.0; i < count; ++i) {
    work.run();
    std::atomic_signal_fence(std::memory_order_seq_cst);  // results count as read, so no run is optimised away
  }
  const double end = thread_seconds();
  if (work.after) work.after();
  return (end - begin) / count;
}

/// The number of runs that take about `seconds` in total.
double runs_within(double seconds, const Work& work) {
  constexpr double kMostRuns = 1e9;
  for (double count = 1.0;; count *= 10.0) {
    const double each = seconds_of_run(work, count);
    if (each * count >= 0.1 * seconds || count >= kMostRuns)
      return std::clamp(std::ceil(seconds / std::max(each, 1e-12)), 1.0, kMostRuns);
  }
}

/// One point of a study, with its measured times.
struct Measured {
  std::size_t study, point;
  double runs = 1.0;
  std::vector<double> seconds;
};

}  // namespace

Middle middle_of(std::span<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
  };
  const double median = at(0.5);
  return {median, median > 0.0 ? (at(0.75) - at(0.25)) / median : 0.0};
}

void mark_pareto_front(Group& group) {
  const auto beats = [&](const Point& a, const Point& b) {
    const double cost_a = group.cost_of(a), cost_b = group.cost_of(b);
    const double error_a = group.error_or_rounding(a), error_b = group.error_or_rounding(b);
    return error_a <= error_b && cost_a <= cost_b && (error_a < error_b || cost_a < cost_b);
  };
  for (Point& point : group.points)
    point.pareto = !point.other_aim && std::none_of(group.points.begin(), group.points.end(), [&](const Point& other) {
      return !other.other_aim && beats(other, point);
    });
}

void measure(std::span<Study> studies, const Effort& effort, const std::function<void(double)>& progress) {
  std::vector<Measured> all;
  for (std::size_t s = 0; s < studies.size(); ++s)
    for (std::size_t p = 0; p < studies[s].works.size(); ++p) all.push_back({s, p});
  const auto work_of = [&](const Measured& measured) -> const Work& {
    return studies[measured.study].works[measured.point];
  };
  const auto repetitions = static_cast<std::size_t>(effort.repetitions);
  std::size_t begun = 0;
  const auto begin = [&] {  // finding the number of runs takes about as long as a repetition
    if (progress) progress(static_cast<double>(begun++) / static_cast<double>(all.size() * (repetitions + 1)));
  };
  std::vector<Measured*> order;
  for (Measured& measured : all) {
    begin();
    measured.runs = runs_within(effort.seconds_per_repetition, work_of(measured));
    order.insert(order.end(), repetitions, &measured);
  }
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  for (Measured* measured : order) {
    begin();
    measured->seconds.push_back(seconds_of_run(work_of(*measured), measured->runs));
  }
  for (Measured& measured : all) {
    const Middle time_s = middle_of(measured.seconds);
    Point& point = studies[measured.study].group.points[measured.point];
    point.time_ns = 1e9 * time_s.median / static_cast<double>(work_of(measured).item_count);
    point.spread = time_s.spread;
    point.noisy = time_s.spread > kNoisySpread;
  }
  for (Study& study : studies) {
    mark_pareto_front(study.group);
    if (study.findings) study.group.findings = study.findings(study.group);
  }
}

}  // namespace sinew::cost
