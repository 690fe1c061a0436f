// SPDX-License-Identifier: MIT
#include "importer/tool/cost/filter_group.h"

#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/tool/cost/measure.h"
#include "importer/tool/cost/run_beside.h"
#include "importer/tool/cost/words.h"

namespace sinew::cost {
namespace {

using Json = nlohmann::json;

constexpr const char* kUsual = "anisotropic=8";  // what the viewer does where a file asks for mip levels

Group empty_group() {
  Group group;
  group.name = "filters";
  group.title = "Texture filters";
  group.question = "How should a texture be read at a slant?";
  group.error_name = "root mean square off supersampling";
  group.error_unit = "% of full light";
  group.item = "pixel";
  return group;
}

double median(const Json& milliseconds) {
  std::vector<double> all = milliseconds.get<std::vector<double>>();
  return middle_of(all).median;
}

Point point_of(const Json& trial, double pixels) {
  std::vector<double> ms = trial.at("milliseconds").get<std::vector<double>>();
  const Middle middle = middle_of(ms);
  Point point;
  point.name = trial.at("name");
  point.note = "sinew-viewer --filter " + point.name;
  point.is_default = point.name == kUsual;
  point.error = 100.0 * trial.at("error").get<double>();
  point.time_ns = 1e6 * middle.median / pixels;
  point.spread = middle.spread;
  point.noisy = middle.spread > kNoisySpread;
  point.values = {{"texture turned by 45 degrees", 100.0 * trial.at("error_turned").get<double>(), "%"},
                  {"texture of 256 x 256", trial.at("bytes").get<double>() / 1024.0, "KiB"}};
  return point;
}

std::string beside(const Group& group, const char* name, const Point& usual) {
  const Point& other = *find(group, name);
  return fmt::format("{} leaves {:.1f} %, which {}", name, other.error, time_beside(group, other, usual));
}

std::string of_normals(const Json& normals) {
  const auto times = [&](const char* key) { return median(normals.at(1).at(key)) / median(normals.at(0).at(key)); };
  return fmt::format(
      "Normals interpolated as quaternions take {} times as long as linear ones on a sphere, and {} times with a "
      "normal map.",
      number(times("milliseconds")), number(times("milliseconds_mapped")));
}

std::vector<std::string> findings(const Group& group, const Json& answer) {
  const Point& usual = default_of(group);
  const Point& rip = *find(group, "ripmap");
  const std::string
      others = fmt::format("{}; {}.", beside(group, "trilinear", usual), beside(group, "bilinear", usual)),
      of_rip = fmt::format(
          "{}, with {} KiB for a texture that has {} with mip levels; where the texture lies at 45 degrees "
          "it leaves {:.1f} %.",
          beside(group, "ripmap", usual), number(rip.values[1].value), number(usual.values[1].value),
          rip.values[0].value);
  return {fmt::format("Anisotropic filtering at up to 8 places leaves {:.1f} % of full light and takes {}.",
                      usual.error, time_of(group, usual)),
          sentence(others), sentence(of_rip), of_normals(answer.at("normals"))};
}

Group left_out(std::string why) {
  Group group = empty_group();
  group.left_out = std::move(why);
  return group;
}

}  // namespace

Group filter_group(const std::string& answer) {
  const Json read = Json::parse(answer, nullptr, false);
  if (read.is_discarded()) return left_out("the measuring program did not finish its answer");
  if (read.contains("left_out")) return left_out(read.at("left_out"));
  Group group = empty_group();
  const double pixels = read.at("width").get<double>() * read.at("height").get<double>();
  for (const Json& trial : read.at("filters")) {
    if (trial.at("milliseconds").empty()) return left_out("the Vulkan device has no clock");
    group.points.push_back(point_of(trial, pixels));
  }
  group.about = fmt::format(
      "A plane that reaches the horizon, {} x {} pixels on {}, beside {} x {} samples of each pixel; it does not "
      "depend "
      "on the file. Times are those of the device for the whole pass that shades the plane. The device reads at up to "
      "{:.0f} places; "
      "filters that ask for more got these.",
      read.at("width").get<int>(), read.at("height").get<int>(), read.at("device").get<std::string>(),
      read.at("samples").get<int>(), read.at("samples").get<int>(), read.at("max_anisotropy").get<double>());
  mark_pareto_front(group);
  group.findings = findings(group, read);
  return group;
}

Group look_at_filters(bool quick) {
  std::vector<std::string> arguments{"--json"};
  if (quick) arguments.emplace_back("--quick");
  const auto answer = output_of_program_beside("sinew-shading-study", arguments);
  return answer ? filter_group(*answer) : left_out(answer.error());
}

Group no_filters() { return left_out("the file has no textures"); }

}  // namespace sinew::cost
