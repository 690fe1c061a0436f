// SPDX-License-Identifier: MIT
#include "tests/study/occlusion_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace sinew::viewer {
namespace {

using Json = nlohmann::ordered_json;

OcclusionTrial trial(const char* name, OcclusionMethod method, const OcclusionShape& shape) {
  OcclusionTrial of;
  of.name = name;
  of.note = std::string("of ") + name;
  of.method = method;
  of.shape = shape;
  of.error = 0.125;
  of.milliseconds = {3.5, 2.25};
  return of;
}

OcclusionStudy study() {
  OcclusionStudy of;
  of.device = "a device";
  of.width = 640;
  of.height = 400;
  of.pixels = 1234;
  of.error_without = 0.25;
  of.radius_m = 1.5;
  OcclusionShape points, slices;
  points.samples = 24;
  points.step = 1;
  slices.samples = 99;
  slices.slices = 3;
  slices.steps = 5;
  slices.step = 2;
  of.trials = {trial("points", OcclusionMethod::ssao, points), trial("slices", OcclusionMethod::gtao, slices)};
  of.trials[1].is_default = true;
  of.exhaustive = {{0.0, 0.5}, {0.25, 0.75}};
  of.at_vertices = {{64, 0.0625, 0.375, 2.5}};
  return of;
}

TEST(occlusion_json, has_every_number_of_the_study) {
  EXPECT_EQ(json_of(study()), Json::parse(R"({
    "device": "a device", "width": 640, "height": 400, "pixels": 1234, "radius_m": 1.5, "error_without": 0.25,
    "trials": [
      {"name": "points", "note": "of points", "method": "ssao", "samples": 24, "full_size": true, "blur": true,
       "default": false, "error": 0.125, "milliseconds": [3.5, 2.25]},
      {"name": "slices", "note": "of slices", "method": "gtao", "samples": 30, "full_size": false, "blur": true,
       "default": true, "error": 0.125, "milliseconds": [3.5, 2.25]}],
    "exhaustive_horizons": [{"thickness": 0.0, "error": 0.5}, {"thickness": 0.25, "error": 0.75}],
    "at_vertices": [{"rays": 64, "vertex_error": 0.0625, "error": 0.375, "seconds": 2.5}]})"));
}

TEST(occlusion_json, calls_blurred_what_keeps_edges_and_reaches_as_far_as_pictures_do) {
  OcclusionStudy of = study();
  OcclusionTrial& trial = of.trials[0];
  const auto blur = [&] { return json_of(of)["trials"][0]["blur"].get<bool>(); };
  trial.blur = false;
  EXPECT_FALSE(blur());
  trial.blur = true;
  trial.shape.keep_edges = false;
  EXPECT_FALSE(blur());
  trial.shape.keep_edges = true;
  EXPECT_TRUE(blur());
  trial.shape.blur_reach += 1;
  EXPECT_FALSE(blur());
}

}  // namespace
}  // namespace sinew::viewer
