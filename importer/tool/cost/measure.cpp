// SPDX-License-Identifier: MIT
#include "importer/tool/cost/measure.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace sinew::cost {
namespace {

/// Keeps the time of every repetition, by the name of its benchmark.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        times_s[run.run_name.function_name].push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
  }

  std::map<std::string, std::vector<double>> times_s;
};

std::string name_of(std::size_t study, std::size_t point) {
  return std::to_string(study) + ":" + std::to_string(point);
}

void set_random_order() {
  std::string arguments[] = {"sinew cost", "--benchmark_enable_random_interleaving=true"};
  char* pointers[] = {arguments[0].data(), arguments[1].data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, pointers);
}

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
    const double error_a = group.telling_error_of(a), error_b = group.telling_error_of(b);
    return error_a <= error_b && cost_a <= cost_b && (error_a < error_b || cost_a < cost_b);
  };
  for (Point& point : group.points)
    point.pareto = !point.other_aim && std::none_of(group.points.begin(), group.points.end(), [&](const Point& other) {
      return !other.other_aim && beats(other, point);
    });
}

void measure(std::span<Study> studies, const Effort& effort, const std::function<void(double)>& progress) {
  std::size_t works = 0, begun = 0;
  for (const Study& study : studies) works += study.works.size();
  const double all_runs = static_cast<double>(works) *
                          static_cast<double>(effort.repetitions + 2);  // 2 more to find the number of iterations
  const auto begin = [&] {
    if (progress) progress(std::min(1.0, static_cast<double>(begun++) / all_runs));
  };
  set_random_order();
  benchmark::ClearRegisteredBenchmarks();
  for (std::size_t s = 0; s < studies.size(); ++s)
    for (std::size_t p = 0; p < studies[s].works.size(); ++p)
      benchmark::RegisterBenchmark(name_of(s, p).c_str(),
                                   [&, s, p](benchmark::State& state) {
                                     begin();
                                     const Work& work = studies[s].works[p];
                                     if (work.before) work.before();
                                     for (auto _ : state) {
                                       work.run();
                                       benchmark::ClobberMemory();
                                     }
                                     if (work.after) work.after();
                                   })
          ->Repetitions(effort.repetitions)
          ->MinTime(effort.seconds_per_repetition);
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  for (std::size_t s = 0; s < studies.size(); ++s) {
    Group& group = studies[s].group;
    for (std::size_t p = 0; p < studies[s].works.size(); ++p) {
      const Middle time_s = middle_of(collector.times_s[name_of(s, p)]);
      group.points[p].time_ns = 1e9 * time_s.median / static_cast<double>(studies[s].works[p].item_count);
      group.points[p].spread = time_s.spread;
      group.points[p].noisy = time_s.spread > kNoisySpread;
    }
    mark_pareto_front(group);
    if (studies[s].findings) group.findings = studies[s].findings(group);
  }
}

}  // namespace sinew::cost
