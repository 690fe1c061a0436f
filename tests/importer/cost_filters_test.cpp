// SPDX-License-Identifier: MIT
// What `sinew cost` makes of the numbers of sinew-shading-study.
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "importer/tool/cost/filter_group.h"
#include "tests/importer/cost_study.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

/// Output of the measuring program: anisotropic filtering is dear and good, rip maps are better and take more memory.
Json answer() {
  Json filters = Json::array();
  const auto add = [&](const char* name, double error, double turned, double ms, double kib) {
    filters.push_back({{"name", name},
                       {"error", error},
                       {"error_turned", turned},
                       {"milliseconds", {ms, 1.01 * ms, 0.99 * ms}},
                       {"bytes", 1024.0 * kib}});
  };
  add("nearest", 0.25, 0.24, 0.25, 256);
  add("bilinear", 0.2, 0.21, 0.5, 256);
  add("trilinear", 0.0625, 0.06, 0.75, 341);
  add("anisotropic=2", 0.055, 0.05, 1.0, 341);
  add("anisotropic=8", 0.05, 0.045, 2.0, 341);
  add("ripmap", 0.04, 0.055, 1.5, 1024);
  Json normals = Json::array();
  normals.push_back({{"name", "interpolated"}, {"milliseconds", {1.0, 2.0, 3.0}}, {"milliseconds_mapped", {4.0}}});
  normals.push_back({{"name", "quaternion"}, {"milliseconds", {3.0, 1.0, 9.0}}, {"milliseconds_mapped", {3.0}}});
  return {{"device", "a device"},   {"width", 100},       {"height", 50},      {"samples", 16},
          {"max_anisotropy", 16.0}, {"filters", filters}, {"normals", normals}};
}

TEST(cost_filters, say_what_each_costs_beside_the_usual_one) {
  const Group group = cost::filter_group(answer().dump());
  ASSERT_EQ(group.points.size(), 6u) << group.left_out;
  EXPECT_EQ(group.points[4].name, "anisotropic=8");
  for (const Point& point : group.points) EXPECT_EQ(point.is_default, &point == &group.points[4]) << point.name;
  EXPECT_DOUBLE_EQ(group.points[4].error, 5.0);
  EXPECT_DOUBLE_EQ(group.points[4].time_ns, 2e6 / 5000.0);
  EXPECT_FALSE(group.points[4].noisy);
  EXPECT_EQ(group.points[5].values[0].value, 5.5);
  EXPECT_EQ(group.points[5].values[1].value, 1024.0);
  EXPECT_TRUE(group.points[5].pareto);
  EXPECT_FALSE(group.points[4].pareto) << "the rip map is nearer and cheaper";
  EXPECT_THAT(group.about, HasSubstr("100 x 50 pixels on a device, beside 16 x 16 samples"));
  EXPECT_THAT(
      group.findings,
      ElementsAre("Anisotropic filtering at up to 8 places leaves 5.0 % of full light and takes 400 ns a pixel.",
                  "Trilinear leaves 6.2 %, which saves 250 ns a pixel; bilinear leaves 20.0 %, which saves 300 "
                  "ns a pixel.",
                  "Ripmap leaves 4.0 %, which saves 100 ns a pixel, with 1024 KiB for a texture that has 341 "
                  "with mip levels; where the texture lies at 45 degrees it leaves 5.5 %.",
                  "Normals interpolated as quaternions take 1.50 times as long as linear ones on a sphere, and "
                  "0.750 times with a normal map."));
}

TEST(cost_filters, say_why_there_are_none) {
  EXPECT_EQ(cost::filter_group(R"({"left_out": "there is no Vulkan device: none fits"})").left_out,
            "there is no Vulkan device: none fits");
  EXPECT_THAT(cost::filter_group("{").left_out, HasSubstr("did not finish"));
  Json without_clock = answer();
  without_clock["filters"].back()["milliseconds"] = Json::array();
  EXPECT_THAT(cost::filter_group(without_clock.dump()).left_out, HasSubstr("no clock"));
  EXPECT_TRUE(cost::filter_group(without_clock.dump()).points.empty());
  EXPECT_THAT(cost::no_filters().left_out, HasSubstr("no textures"));
}

/// Why a report on a triangle has no points about filters; empty = it has some.
std::string left_out_of(bool textured) {
  const ToolModelFile folder;
  TinyGltf file;
  file.add_triangle();
  if (textured) {
    file.root["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgo="}}};
    file.root["textures"] = {{{"source", 0}}};
  }
  const std::string path = folder.beside("triangle.gltf"), out = folder.beside("costs");
  std::ofstream(path) << file.text();
  const CommandOutcome outcome = run_tool({"cost", path, "--quick", "-o", out});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::ifstream stream(out + "/report.json");
  const Json report = Json::parse(stream);
  for (const Json& group : report["groups"])
    if (group["name"] == "filters") return group.value("left_out", "");
  return "no such group";
}

TEST(cost_filters, are_looked_at_for_files_with_textures) {
  EXPECT_THAT(left_out_of(false), HasSubstr("no textures"));
  EXPECT_THAT(left_out_of(true), testing::Not(HasSubstr("no textures")));
}

}  // namespace
}  // namespace sinew::test
