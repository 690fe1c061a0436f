// SPDX-License-Identifier: MIT
// The report of `sinew cost` on results of sinew-shading-study, and the errors of interpolated normals.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "importer/tool/cost/shading_groups.h"
#include "tests/importer/cost_study.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/reference/quaternion_normal.h"

namespace sinew::test {
namespace {

/// Output of the measuring program: anisotropic filtering is slow and accurate; rip maps are more accurate and take
/// more memory.
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
  normals.push_back({{"name", "interpolated"}, {"milliseconds", {2.0, 2.0, 2.0}}, {"milliseconds_mapped", {4.0}}});
  normals.push_back({{"name", "quaternion"}, {"milliseconds", {3.0, 3.0, 3.0}}, {"milliseconds_mapped", {3.0}}});
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
                  "with mip levels; where the texture lies at 45 degrees it leaves 5.5 %."));
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

/// A triangle whose normals lean by these angles from +z towards +x.
Scene leaning(double a, double b, double c) {
  Primitive p;
  for (const double lean : {a, b, c}) {
    p.positions.emplace_back(static_cast<float>(lean), 0.0f, 0.0f);
    p.normals.emplace_back(static_cast<float>(std::sin(lean)), 0.0f, static_cast<float>(std::cos(lean)));
  }
  p.indices = {0, 1, 2};
  Scene scene;
  scene.meshes.resize(1);
  scene.meshes[0].primitives.push_back(std::move(p));
  return scene;
}

/// Largest angle, in degrees, between the great arc and the reference's interpolation of half-way vectors.
double angle_of_quaternions(double from, double to) {
  double largest = 0.0;
  const auto normal = [](double lean) { return Vec3<double>(std::sin(lean), 0.0, std::cos(lean)); };
  const auto h0 = reference::half_way_from_normal(normal(from)), h1 = reference::half_way_from_normal(normal(to));
  for (const double t : {0.25, 0.5, 0.75}) {
    const Vec3<double> n = reference::normal_between(h0, h1, t);
    largest = std::max(largest, std::abs(std::atan2(n.x, n.z) - (from + t * (to - from))));
  }
  return largest * 180.0 / std::numbers::pi;
}

TEST(cost_normals, angles_are_those_of_the_equations) {
  const double wide = std::numbers::pi / 3;  // 60 degrees
  const cost::NormalAngles angles = cost::normal_angles(leaning(-wide / 2, wide / 2, wide / 2));
  // The views along +x and -x see one of two normals, those along y and -y none, that along -z sees both from behind.
  EXPECT_EQ(angles.samples, 6u) << "two edges, one view, three places";
  const double at_quarter =
      15.0 - std::atan2(0.25 * std::sin(wide), 0.75 + 0.25 * std::cos(wide)) * 180 / std::numbers::pi;
  EXPECT_NEAR(angles.linear.largest, at_quarter, 1e-5);
  EXPECT_NEAR(angles.linear.mean, 2.0 / 3.0 * at_quarter, 1e-5) << "half way both are exact";
  EXPECT_NEAR(angles.quaternion.largest, angle_of_quaternions(-wide / 2, wide / 2), 1e-5);
  EXPECT_LT(angles.quaternion.largest, 0.3 * angles.linear.largest);
  EXPECT_NEAR(cost::normal_angles(leaning(0.1, 1.2, 0.4)).quaternion.largest, angle_of_quaternions(0.1, 1.2), 1e-5);
}

TEST(cost_normals, edges_without_an_arc_do_not_count) {
  EXPECT_EQ(cost::normal_angles(leaning(0.3, 0.3, 0.3)).samples, 0u) << "flat";
  EXPECT_EQ(cost::normal_angles(leaning(0.0, std::numbers::pi, 0.0)).samples, 0u) << "opposite";
  Scene without = leaning(0.1, 0.2, 0.3);
  without.meshes[0].primitives[0].normals.clear();
  EXPECT_EQ(cost::normal_angles(without).samples, 0u);
  Scene lines = leaning(0.1, 0.2, 0.3);
  lines.meshes[0].primitives[0].topology = Topology::lines;
  EXPECT_EQ(cost::normal_angles(lines).samples, 0u);
}

TEST(cost_normals, say_what_each_way_costs) {
  const cost::NormalAngles angles{{1.5, 0.25}, {0.375, 0.125}, 9};
  const Group group = cost::normal_interpolation_group(angles, answer().dump());
  ASSERT_EQ(group.points.size(), 2u) << group.left_out;
  EXPECT_EQ(group.points[0].name, "interpolated");
  EXPECT_TRUE(group.points[0].is_default);
  EXPECT_FALSE(group.points[1].is_default);
  EXPECT_EQ(group.points[0].error, 1.5);
  EXPECT_EQ(group.points[1].error, 0.375);
  EXPECT_EQ(group.points[0].time_ns, 2e6 / 5000.0);
  EXPECT_EQ(group.points[1].time_ns, 3e6 / 5000.0);
  EXPECT_EQ(group.points[1].values[0].value, 0.125);
  EXPECT_EQ(group.points[0].values[1].value, 4e6 / 5000.0);
  EXPECT_TRUE(group.points[1].pareto);
  EXPECT_THAT(group.findings[0], HasSubstr("by 1.50 degrees at most, 0.250 on average"));
  EXPECT_THAT(group.findings[1], HasSubstr("by 0.375 degrees, 0.125 on average, which costs 200 ns a pixel more"));
  EXPECT_THAT(cost::normal_interpolation_group({}, answer().dump()).left_out, HasSubstr("no two vertices"));
  EXPECT_THAT(cost::normal_interpolation_group(angles, "{").left_out, HasSubstr("did not finish"));
  Json without_clock = answer();
  without_clock["normals"][0]["milliseconds"] = Json::array();
  EXPECT_THAT(cost::normal_interpolation_group(angles, without_clock.dump()).left_out, HasSubstr("no clock"));
}

/// The reason that a report on a triangle gives for an empty group; "" if the group has points.
std::string left_out_of(bool textured, const char* name) {
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
    if (group["name"] == name) return group.value("left_out", "");
  return "no such group";
}

TEST(cost_filters, are_looked_at_for_files_with_textures) {
  EXPECT_THAT(left_out_of(false, "filters"), HasSubstr("no textures"));
  EXPECT_THAT(left_out_of(true, "filters"), testing::Not(HasSubstr("no such group")));
  EXPECT_THAT(left_out_of(true, "filters"), testing::Not(HasSubstr("no textures")));
  EXPECT_THAT(left_out_of(true, "normal_interpolation"), HasSubstr("no two vertices")) << "a flat triangle";
}

}  // namespace
}  // namespace sinew::test
