// SPDX-License-Identifier: MIT
#include "importer/tool/cost/occlusion_group.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/tool/cost/measure.h"
#include "importer/tool/cost/run_beside.h"
#include "importer/tool/cost/timed_trial.h"
#include "importer/tool/cost/words.h"
#include "runtime/base/index.h"

namespace sinew::cost {
namespace {

using Json = nlohmann::json;

constexpr double kHardlyBetter = 1.05;  // times the least error; variants within it count as equally good

Group empty_group() {
  return {.name = "occlusion",
          .title = "Ambient occlusion",
          .question = "How many samples of ambient occlusion are worth it?",
          .error_name = "root mean square off ray casting",
          .error_unit = "% of full light",
          .item = "pixel"};
}

Point occlusion_point(const Json& trial, double pixels) {
  Point point = timed_point(trial, "milliseconds", pixels);
  point.note = trial.at("note");
  point.is_default = trial.at("default");
  point.error = 100.0 * trial.at("error").get<double>();
  point.values = {{"whole picture", 1e-6 * point.time_ns * pixels, "ms"}};
  return point;
}

/// The variants that have the default's method, half size and its blur, sorted by their number of samples.
std::vector<std::pair<int, const Point*>> by_samples(const Group& group, const Json& trials) {
  const auto standard =
      std::find_if(trials.begin(), trials.end(), [](const Json& t) { return t.at("default").get<bool>(); });
  std::vector<std::pair<int, const Point*>> rising;
  for (std::size_t i = 0; i < group.points.size(); ++i)
    if (trials[i].at("method") == standard->at("method") && trials[i].at("full_size") == standard->at("full_size") &&
        trials[i].at("blur") == standard->at("blur"))
      rising.emplace_back(trials[i].at("samples"), &group.points[i]);
  std::sort(rising.begin(), rising.end());
  return rising;
}

std::string worth_it(const Group& group, const Json& trials) {
  const auto rising = by_samples(group, trials);
  const auto least = std::min_element(rising.begin(), rising.end(),
                                      [](const auto& a, const auto& b) { return a.second->error < b.second->error; });
  const auto fewest = std::find_if(rising.begin(), rising.end(), [&](const auto& r) {
    return r.second->error <= kHardlyBetter * least->second->error;
  });
  const auto& [most, dearest] = rising.back();
  if (fewest->first == most)
    return fmt::format("All {} samples are worth it here: fewer leave more than a twentieth more error.", most);
  return fmt::format(
      "{} samples are worth it here: they leave {:.1f} %, any number up to {} leaves at least {:.1f} %, and {} take {} "
      "times as long.",
      fewest->first, fewest->second->error, most, least->second->error, most,
      number(dearest->time_ns / fewest->second->time_ns));
}

std::vector<std::string> findings_of_occlusion(const Group& group, const Json& answer) {
  const Point& standard = default_of(group);
  std::vector<std::string> out{fmt::format(
      "A picture without ambient occlusion is off by {:.1f} % of full light on average; {} at half size, blurred, "
      "leave {:.1f} % and take {:.2g} ms for {} x {} on {}.",
      100.0 * answer.at("error_without").get<double>(), standard.name, standard.error, standard.values[0].value,
      answer.at("width").get<int>(), answer.at("height").get<int>(), answer.at("device").get<std::string>())};
  if (const Point* points = find(group, "14 samples"); points && points != &standard)
    out.push_back(fmt::format("Points around the surface instead of horizons, 14 of them, leave {:.1f} %, which {}.",
                              points->error, time_beside(group, *points, standard)));
  if (const Point* full = find(group, standard.name + " full size"))
    out.push_back(
        fmt::format("At full size they leave {:.1f} %, which {}. What is left is what a picture of depths cannot know.",
                    full->error, time_beside(group, *full, standard)));
  if (const Point* raw = find(group, standard.name + " no blur"))
    out.push_back(fmt::format("Without the blur they leave {:.1f} %, as noise, which {}.", raw->error,
                              time_beside(group, *raw, standard)));
  out.push_back(worth_it(group, answer.at("trials")));
  return out;
}

/// Adds a sentence for each number of rays at vertices. They are baked, so they take no time in a frame.
void add_rays_at_vertices(const Json& answer, std::vector<std::string>& findings) {
  for (const Json& trial : answer.value("at_vertices", Json::array()))
    findings.push_back(fmt::format(
        "{} rays a vertex, baked in {:.2g} s before the first frame, leave {:.1f} % and take no time in a frame; "
        "at the vertices they are {:.2g} % off 4096 rays, the rest is what triangles interpolate.",
        trial.at("rays").get<int>(), trial.at("seconds").get<double>(), 100.0 * trial.at("error").get<double>(),
        100.0 * trial.at("vertex_error").get<double>()));
}

}  // namespace

Group occlusion_group(const std::string& answer) {
  Group group = empty_group();
  const auto left_out = [&](std::string why) {
    group.points.clear();
    group.left_out = std::move(why);
    return group;
  };
  const Json read = Json::parse(answer, nullptr, false);
  if (read.is_discarded()) return left_out("the measuring program did not finish its answer");
  if (read.contains("left_out")) return left_out(read.at("left_out"));
  const double pixels = read.at("width").get<double>() * read.at("height").get<double>();
  for (const Json& trial : read.at("trials")) {
    if (trial.at("milliseconds").empty()) return left_out("the Vulkan device has no clock");
    group.points.push_back(occlusion_point(trial, pixels));
  }
  group.about = fmt::format(
      "One picture of {} x {}, {} pixels of which show a surface, on {}; times are those of the device for the passes "
      "that make ambient visibility. The error is over "
      "these pixels, against rays (Embree) from the same points that reach {:.3g} m, shown as the share of light that "
      "they leave open. Devices differ in the ratios of "
      "these times: a software device pays for each look-up what a graphics processor hides.",
      read.at("width").get<int>(), read.at("height").get<int>(), read.at("pixels").get<std::uint64_t>(),
      read.at("device").get<std::string>(), read.at("radius_m").get<double>());
  mark_pareto_front(group);
  group.findings = findings_of_occlusion(group, read);
  add_rays_at_vertices(read, group.findings);
  return group;
}

std::vector<std::string> occlusion_arguments(const std::string& file, std::uint32_t clip, bool quick) {
  std::vector<std::string> arguments;
  if (quick) arguments.emplace_back("--quick");
  if (file.empty()) return arguments;
  arguments.insert(arguments.end(), {"--clip", clip == kNone ? "none" : std::to_string(clip), "--", file});
  return arguments;
}

Group look_at_occlusion(const std::vector<std::string>& arguments) {
  const auto answer = output_of_program_beside("sinew-occlusion-study", arguments);
  if (answer) return occlusion_group(*answer);
  Group group = empty_group();
  group.left_out = answer.error();
  return group;
}

}  // namespace sinew::cost
