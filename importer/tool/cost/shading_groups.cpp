// SPDX-License-Identifier: MIT
#include "importer/tool/cost/shading_groups.h"

#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "importer/tool/cost/measure.h"
#include "importer/tool/cost/run_beside.h"
#include "importer/tool/cost/timed_trial.h"
#include "importer/tool/cost/words.h"

namespace sinew::cost {
namespace {

using Json = nlohmann::json;

constexpr const char* kUsual = "anisotropic=8";  // the viewer's choice if a file asks for mip levels

Group group_of_filters() {
  return {.name = "filters",
          .title = "Texture filters",
          .question = "How should a texture be read at a slant?",
          .error_name = "root mean square off supersampling",
          .error_unit = "% of full light",
          .item = "pixel"};
}

Group group_of_normals() {
  return {.name = "normal_interpolation",
          .title = "Normals between vertices",
          .question = "How should normals be interpolated?",
          .error_name = "largest angle off the great arc",
          .error_unit = "degrees",
          .item = "pixel"};
}

Point filter_point(const Json& trial, double pixels) {
  Point point = timed_point(trial, "milliseconds", pixels);
  point.note = "sinew-viewer --filter " + point.name;
  point.is_default = point.name == kUsual;
  point.error = 100.0 * trial.at("error").get<double>();
  point.values = {{"texture turned by 45 degrees", 100.0 * trial.at("error_turned").get<double>(), "%"},
                  {"texture of 256 x 256", trial.at("bytes").get<double>() / 1024.0, "KiB"}};
  return point;
}

std::string beside_usual(const Group& group, const char* name, const Point& usual) {
  const Point& other = *find(group, name);
  return fmt::format("{} leaves {:.1f} %, which {}", name, other.error, time_beside(group, other, usual));
}

std::vector<std::string> findings_of_filters(const Group& group) {
  const Point& usual = default_of(group);
  const Point& rip = *find(group, "ripmap");
  const std::string
      others = fmt::format("{}; {}.", beside_usual(group, "trilinear", usual), beside_usual(group, "bilinear", usual)),
      of_rip = fmt::format(
          "{}, with {} KiB for a texture that has {} with mip levels; where the texture lies at 45 degrees "
          "it leaves {:.1f} %.",
          beside_usual(group, "ripmap", usual), number(rip.values[1].value), number(usual.values[1].value),
          rip.values[0].value);
  return {fmt::format("Anisotropic filtering at up to 8 places leaves {:.1f} % of full light and takes {}.",
                      usual.error, time_of(group, usual)),
          sentence(others), sentence(of_rip)};
}

Group left_out(Group group, std::string why) {
  group.left_out = std::move(why);
  return group;
}

double pixels_of(const Json& read) { return read.at("width").get<double>() * read.at("height").get<double>(); }

/// The reason why there are no times; empty if there are times.
std::string find_document_error(const Json& read, const char* trials) {
  if (read.is_discarded()) return "the measuring program did not finish its answer";
  if (read.contains("left_out")) return read.at("left_out");
  for (const Json& trial : read.at(trials))
    if (trial.at("milliseconds").empty()) return "the Vulkan device has no clock";
  return "";
}

Point normal_point(const Json& trial, double pixels, const ArcError& angles) {
  const Point mapped = timed_point(trial, "milliseconds_mapped", pixels);
  Point point = timed_point(trial, "milliseconds", pixels);
  point.note = "sinew-viewer --normals " + point.name;
  point.is_default = point.name == "interpolated";
  point.error = angles.largest;
  point.values = {{"mean angle", angles.mean, "degrees"}, {"with a normal map", mapped.time_ns, "ns a pixel"}};
  return point;
}

}  // namespace

std::string measure_shading(bool quick) {
  std::vector<std::string> arguments{"--json"};
  if (quick) arguments.emplace_back("--quick");
  const auto answer = output_of_program_beside("sinew-shading-study", arguments);
  return answer ? *answer : Json{{"left_out", answer.error()}}.dump();
}

Group filter_group(const std::string& measured) {
  const Json read = Json::parse(measured, nullptr, false);
  if (std::string why = find_document_error(read, "filters"); !why.empty())
    return left_out(group_of_filters(), std::move(why));
  Group group = group_of_filters();
  for (const Json& trial : read.at("filters")) group.points.push_back(filter_point(trial, pixels_of(read)));
  group.about = fmt::format(
      "A plane that reaches the horizon, {} x {} pixels on {}, beside {} x {} samples of each pixel; it does not "
      "depend "
      "on the file. Times are those of the device for the whole pass that shades the plane. The device reads at up to "
      "{:.0f} places; filters that ask for more got these.",
      read.at("width").get<int>(), read.at("height").get<int>(), read.at("device").get<std::string>(),
      read.at("samples").get<int>(), read.at("samples").get<int>(), read.at("max_anisotropy").get<double>());
  mark_pareto_front(group);
  group.findings = findings_of_filters(group);
  return group;
}

Group no_filters() { return left_out(group_of_filters(), "the file has no textures"); }

Group normal_interpolation_group(const NormalAngles& angles, const std::string& measured) {
  if (angles.samples == 0)
    return left_out(group_of_normals(), "no two vertices of a triangle have normals that differ");
  const Json read = Json::parse(measured, nullptr, false);
  if (std::string why = find_document_error(read, "normals"); !why.empty())
    return left_out(group_of_normals(), std::move(why));
  Group group = group_of_normals();
  group.points = {normal_point(read.at("normals").at(0), pixels_of(read), angles.linear),
                  normal_point(read.at("normals").at(1), pixels_of(read), angles.quaternion)};
  group.about = fmt::format(
      "Angles between interpolated normals and the great arc, a quarter, a half and three quarters along the edges of "
      "the file, seen along six axes. Times are those of {} for the whole pass that shades a sphere.",
      read.at("device").get<std::string>());
  mark_pareto_front(group);
  const Point &linear = group.points[0], &quaternion = group.points[1];
  group.findings = {
      fmt::format("Linear normals leave the great arc by {} degrees at most, {} on average.",
                  number(angles.linear.largest), number(angles.linear.mean)),
      fmt::format("Quaternions leave it by {} degrees, {} on average, which {}.", number(angles.quaternion.largest),
                  number(angles.quaternion.mean), time_beside(group, quaternion, linear))};
  return group;
}

}  // namespace sinew::cost
