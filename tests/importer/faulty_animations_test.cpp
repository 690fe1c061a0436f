// SPDX-License-Identifier: MIT
// A file in which only animation channels are broken is imported without these channels. The fault stands among the
// warnings of the import, with the severity of an error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "runtime/animation/track_sample.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A triangle whose node 0 has a translation channel (sampler 0) and a scale channel (sampler 1). Accessors: 0 is the
/// mesh, 1 and 2 are times and values of sampler 0, 3 and 4 those of sampler 1; each has the view of its number.
TinyGltf two_channels() {
  TinyGltf file;
  file.add_triangle();
  file.animate("translation", file.times({0, 1}), file.vec3({0, 0, 0, 1, 2, 3}));
  file.root["animations"][0]["samplers"].push_back(
      {{"input", file.times({0, 2})}, {"output", file.vec3({1, 1, 1, 2, 2, 2})}});
  file.root["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "scale"}}}});
  return file;
}

struct ChannelFault {
  const char* expected;
  std::function<void(Json&)> make;
};

const std::vector<ChannelFault>& faults_of_the_first_channel() {
  static const std::vector<ChannelFault> faults{
      {"reference at /animations/0/channels/0/sampler",
       [](Json& j) { j["animations"][0]["channels"][0]["sampler"] = 9; }},
      {"reference at /animations/0/channels/0/target/node",
       [](Json& j) { j["animations"][0]["channels"][0]["target"]["node"] = 9; }},
      {"reference at /animations/0/channels/0/target",
       [](Json& j) {
         j["animations"][0]["channels"][0]["target"] = {
             {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/9/scale"}}}}}};
       }},
      {"reference at /animations/0/samplers/0/input", [](Json& j) { j["animations"][0]["samplers"][0]["input"] = 99; }},
      {"json-type at /animations/0/samplers/0/output",
       [](Json& j) { j["animations"][0]["samplers"][0]["output"] = "two"; }},
      {"json-missing at /animations/0/samplers/0", [](Json& j) { j["animations"][0]["samplers"][0].erase("input"); }},
      {"json-missing at /animations/0/channels/0", [](Json& j) { j["animations"][0]["channels"][0].erase("target"); }},
      {"json-missing at /animations/0/channels/0/target",
       [](Json& j) { j["animations"][0]["channels"][0]["target"].erase("path"); }},
      {"json-type at /animations/0/channels/0", [](Json& j) { j["animations"][0]["channels"][0] = 7; }},
      {"accessor-fit at /accessors/2", [](Json& j) { j["accessors"][2]["count"] = 50; }},
      {"json-type at /accessors/1/componentType", [](Json& j) { j["accessors"][1]["componentType"] = 9999; }},
      {"json-type at /accessors/2/type", [](Json& j) { j["accessors"][2]["type"] = "VEC9"; }},
      {"reference at /accessors/2/bufferView", [](Json& j) { j["accessors"][2]["bufferView"] = 77; }},
      {"buffer-view-range at /bufferViews/2/byteLength", [](Json& j) { j["bufferViews"][2]["byteLength"] = 9999; }},
      {"buffer-missing at /buffers/1/uri",
       [](Json& j) {
         j["buffers"].push_back({{"byteLength", 24}, {"uri", "data:application/octet-stream;base64,?"}});
         j["bufferViews"][2] = {{"buffer", 1}, {"byteLength", 24}};
       }},
      {"animation-input at /animations/0/samplers/0/input",
       [](Json& j) { j["animations"][0]["samplers"][0]["input"] = j["animations"][0]["samplers"][0]["output"]; }},
      {"animation-output at /animations/0/samplers/0/output",
       [](Json& j) { j["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE"; }},
  };
  return faults;
}

TEST(faulty_animations, one_broken_channel_is_left_out_and_the_rest_is_imported) {
  ImportOptions thorough;
  thorough.thorough = thorough.collect_all_errors = true;
  for (const ChannelFault& fault : faults_of_the_first_channel()) {
    SCOPED_TRACE(fault.expected);
    TinyGltf file = two_channels();
    file.root = Json::parse(file.text());  // with its buffers
    fault.make(file.root);
    for (const ImportOptions& options : {ImportOptions(), thorough}) {
      const auto result = file.import(options);
      ASSERT_EQ(survived(result), fault.expected);
      EXPECT_THAT(result->scene.meshes, SizeIs(1));
      ASSERT_THAT(result->scene.animations, SizeIs(1));
      ASSERT_THAT(result->scene.animations[0].bones, SizeIs(1));
      EXPECT_TRUE(result->scene.animations[0].bones[0].translation.empty());
      EXPECT_THAT(result->scene.animations[0].bones[0].scale.times_s, ElementsAre(0, 2));
      EXPECT_THAT(result->scene.clips, SizeIs(1));
      for (const ImportIssue& issue : result->warnings)
        if (issue.severity == Severity::error) {
          EXPECT_THAT(issue.detail, HasSubstr("left out"));
        }
    }
  }
}

TEST(faulty_animations, a_clip_that_is_broken_as_a_whole_stays_empty_in_its_place) {
  for (const char* part : {"channels", "samplers"}) {
    TinyGltf file = two_channels();
    file.root["animations"].push_back(file.root["animations"][0]);
    file.root["animations"][0][part] = 7;
    const auto result = file.import();
    ASSERT_EQ(survived(result), "json-type at /animations/0/" + std::string(part));
    ASSERT_THAT(result->scene.animations, SizeIs(2)) << "indices of clips do not move";
    EXPECT_THAT(result->scene.animations[0].bones, IsEmpty());
    EXPECT_THAT(result->scene.animations[1].bones, SizeIs(1));
  }
}

TEST(faulty_animations, data_that_anything_else_reads_refuse_the_file) {
  const auto shared_with = [](const std::function<void(Json&)>& use) {
    TinyGltf file = two_channels();
    file.root = Json::parse(file.text());
    use(file.root);
    file.root["accessors"][2]["count"] = 50;
    return outcome(file.import());
  };
  const std::string refused = "accessor-fit at /accessors/2";
  EXPECT_EQ(shared_with([](Json&) {}), "ok");
  EXPECT_EQ(shared_with([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 2; }), refused);
  EXPECT_EQ(shared_with([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["_OWN"] = 2; }), refused);
  EXPECT_EQ(shared_with([](Json& j) { j["meshes"][0]["primitives"][0]["indices"] = 2; }), refused);
  EXPECT_EQ(shared_with([](Json& j) { j["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 2}}}; }), refused);
  EXPECT_EQ(shared_with([](Json& j) { j["skins"] = {{{"joints", {0}}, {"inverseBindMatrices", 2}}}; }), refused);
  EXPECT_EQ(shared_with([](Json& j) {
              j["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 2;
            }),
            refused);
}

TEST(faulty_animations, data_that_nothing_reads_refuse_the_file_as_they_did) {
  for (const char* place : {"/accessors/5", "/bufferViews/5/byteLength"}) {
    TinyGltf file = two_channels();
    const std::size_t spare = file.vec3({1, 2, 3});
    ASSERT_EQ(spare, 5u);
    file.root = Json::parse(file.text());
    if (std::string_view(place) == "/accessors/5")
      file.root["accessors"][spare]["count"] = 50;
    else
      file.root["bufferViews"][spare]["byteLength"] = 9999;
    EXPECT_THAT(outcome(file.import()), testing::EndsWith(place));
  }
}

TEST(faulty_animations, a_missing_buffer_takes_its_channels_and_spares_with_it) {
  TinyGltf file = two_channels();
  file.root = Json::parse(file.text());
  file.root["buffers"].push_back({{"byteLength", 24}, {"uri", "data:application/octet-stream;base64,?"}});
  file.root["bufferViews"][2] = {{"buffer", 1}, {"byteLength", 24}};
  file.root["accessors"].push_back({{"bufferView", 2}, {"componentType", 5126}, {"count", 6}, {"type", "SCALAR"}});
  EXPECT_EQ(survived(file.import()), "buffer-missing at /buffers/1/uri");
}

TEST(faulty_animations, a_broken_view_that_an_image_or_a_compressed_mesh_reads_refuses_the_file) {
  const auto shared_with = [](const std::function<void(Json&)>& use) {
    TinyGltf file = two_channels();
    file.root = Json::parse(file.text());
    use(file.root);
    file.root["bufferViews"][2]["byteLength"] = 9999;
    return outcome(file.import());
  };
  EXPECT_EQ(shared_with([](Json&) {}), "ok");
  EXPECT_EQ(shared_with([](Json& j) {
              j["images"] = {{{"bufferView", 2}, {"mimeType", "image/png"}}};
            }),
            "buffer-view-range at /bufferViews/2/byteLength");
  EXPECT_EQ(shared_with([](Json& j) {
              j["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
                  {"bufferView", 2}, {"attributes", {{"POSITION", 0}}}};
            }),
            "buffer-view-range at /bufferViews/2/byteLength");
}

TEST(faulty_animations, a_document_that_is_carried_along_must_be_whole) {
  TinyGltf file = two_channels();
  file.root["accessors"][2]["count"] = 50;
  EXPECT_EQ(outcome(file.import({.carry_document = true})), "accessor-fit at /accessors/2");
  TinyGltf counts = two_channels();
  counts.root["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
  EXPECT_EQ(outcome(counts.import({.carry_document = true})), "ok") << "the document can be read, only not played";
}

TEST(faulty_animations, errors_elsewhere_still_refuse_and_come_first) {
  TinyGltf file = two_channels();
  file.root["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
  file.root["nodes"][0]["mesh"] = 9;
  const auto result = file.import({.collect_all_errors = true});
  ASSERT_EQ(outcome(result), "reference at /nodes/0/mesh");
  ASSERT_THAT(result.error().more_errors, SizeIs(1));
  EXPECT_EQ(result.error().more_errors[0].rule, "animation-output");
}

/// Weights of two targets at these times.
TinyGltf file_with_weights(const std::vector<float>& times, const std::vector<float>& values,
                           const char* interpolation) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t delta = file.vec3(std::vector<float>(9, 1.0f));
  primitive["targets"] = Json::array({{{"POSITION", delta}}, {{"POSITION", delta}}});
  const std::size_t input = file.times(times);
  file.animate("weights", input, file.scalars(values), interpolation);
  return file;
}

TEST(faulty_animations, old_exporters_that_write_too_few_weights_for_cubic_keys_lose_that_channel_only) {
  const auto result = file_with_weights({0, 1, 2}, std::vector<float>(12, 0.5f), "CUBICSPLINE").import();
  ASSERT_EQ(survived(result), "animation-output at /animations/0/samplers/0/output");
  EXPECT_THAT(result->scene.animations[0].weights, IsEmpty());
  EXPECT_THAT(result->warnings[0].detail,
              HasSubstr("12 values for 3 keys that need 6 each; channels that use it are left out"));
}

constexpr const char* kCutTimes = "animation-times at /animations/0/samplers/0/input";
constexpr float kTimesFromZero[] = {0.0f, 0.01f, 0.3f, 0.5f, 0.75f, 1.0f, 1.6f, 2.0f, 3.0f};

/// Largest difference that a key of unit length makes between cubic rotation keys that are 137 degrees apart.
constexpr double kUnitKey = 4e-3;

/// The truth of cut tracks: the whole track, which sample_track() also evaluates where keys are before 0.
template <class Track>
void expect_the_same_from_zero(const Track& cut, const Track& whole, double tolerance) {
  ASSERT_FALSE(cut.empty());
  EXPECT_EQ(cut.times_s.front(), 0.0f);
  for (const float t : kTimesFromZero) {
    const auto a = sample_track<double>(cut, t), b = sample_track<double>(whole, t);
    for (int c = 0; c < static_cast<int>(a.length()); ++c)
      EXPECT_NEAR(a[c], b[c], tolerance) << "at " << t << ", " << c;
  }
}

TEST(faulty_animations, a_curve_with_keys_before_zero_is_the_same_from_zero_on) {
  const std::vector<float> times{-2.0f, -0.5f, 1.0f, 2.0f};
  for (const char* interpolation : {"LINEAR", "STEP", "CUBICSPLINE"}) {
    SCOPED_TRACE(interpolation);
    const bool cubic = std::string_view(interpolation) == "CUBICSPLINE";
    const std::size_t rows = times.size() * (cubic ? 3 : 1);
    Vec3Track moves{
        cubic ? Interpolation::cubic_spline : (interpolation[0] == 'S' ? Interpolation::step : Interpolation::linear),
        times,
        {}};
    QuatTrack turns{moves.interpolation, times, {}};
    std::vector<float> moved, turned;
    for (std::size_t r = 0; r < rows; ++r) {
      const auto x = static_cast<float>(r);
      moves.values.emplace_back(std::sin(x), x * x / 10.0f, 3.0f - x);
      for (int c = 0; c < 3; ++c) moved.push_back(moves.values.back()[c]);
      const float angle = 0.4f * x;
      turns.values.push_back(glm::quat(std::cos(angle), 0.6f * std::sin(angle), 0.0f, 0.8f * std::sin(angle)));
      for (int c = 0; c < 4; ++c) turned.push_back((&turns.values.back().x)[c]);
    }
    TinyGltf file;
    file.root["nodes"] = Json::array({Json::object()});
    const std::size_t input = file.times(times);
    file.animate("translation", input, file.vec3(moved), interpolation);
    const auto moving = file.import();
    ASSERT_EQ(survived(moving), kCutTimes);
    expect_the_same_from_zero(moving->scene.animations[0].bones[0].translation, moves, 1e-5);
    file.animate("rotation", input, file.vec4(turned), interpolation);
    const auto turning = file.import();
    ASSERT_EQ(survived(turning), kCutTimes);
    expect_the_same_from_zero(turning->scene.animations[0].bones[0].rotation, turns, cubic ? kUnitKey : 1e-5);
    const auto first = sample_track<double>(turning->scene.animations[0].bones[0].rotation, 0.0);
    EXPECT_NEAR(quat_dot(first, first), 1.0, 1e-6) << "no key scales what it turns";
    EXPECT_EQ(turning->scene.animations[0].duration_s, 2.0);
    EXPECT_THAT(turning->scene.animations[0].bones[0].rotation.times_s, ElementsAre(0, 1, 2));
    EXPECT_THAT(turning->warnings[0].detail, HasSubstr("2 keys lie before time 0"));
  }
}

TEST(faulty_animations, weights_with_keys_before_zero_start_at_zero) {
  const auto result = file_with_weights({-1, 1}, {0, 1, 1, 0}, "LINEAR").import();
  ASSERT_EQ(survived(result), kCutTimes);
  const WeightTrack& track = result->scene.animations[0].weights[0].weights;
  EXPECT_THAT(track.times_s, ElementsAre(0, 1));
  EXPECT_THAT(track.values, ElementsAre(0.5f, 0.5f, 1, 0));
}

TEST(faulty_animations, keys_at_zero_stay_as_they_are) {
  const auto result = file_with_weights({-1, 0, 0, 1}, {9, 9, 1, 2, 3, 4, 5, 6}, "LINEAR").import();
  ASSERT_EQ(survived(result), kCutTimes);
  const WeightTrack& track = result->scene.animations[0].weights[0].weights;
  EXPECT_THAT(track.times_s, ElementsAre(0, 0, 1)) << "with the jump at 0";
  EXPECT_THAT(track.values, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(faulty_animations, a_curve_that_ends_before_zero_holds_its_last_value) {
  for (const char* interpolation : {"LINEAR", "STEP"}) {
    const auto result = file_with_weights({-2, -1}, {0, 1, 0.25f, 0.75f}, interpolation).import();
    ASSERT_EQ(survived(result), kCutTimes) << interpolation;
    const WeightTrack& track = result->scene.animations[0].weights[0].weights;
    EXPECT_THAT(track.times_s, ElementsAre(0));
    EXPECT_THAT(track.values, ElementsAre(0.25f, 0.75f));
    EXPECT_EQ(result->scene.animations[0].duration_s, 0.0);
  }
  const auto cubic = file_with_weights({-2, -1}, {0, 0, 1, 1, 0, 0, 0, 0, 0.25f, 0.75f, 0, 0}, "CUBICSPLINE").import();
  ASSERT_EQ(survived(cubic), kCutTimes);
  EXPECT_THAT(cubic->scene.animations[0].weights[0].weights.values, ElementsAre(0.25f, 0.75f));
}

TEST(faulty_animations, values_that_are_no_numbers_are_not_hidden_by_the_cut) {
  EXPECT_EQ(survived(file_with_weights({-2, -1, 1}, {NAN, 0, 0, 0, 1, 1}, "LINEAR").import()),
            "animation-values at /animations/0/samplers/0/output");
}

/// The warnings of a thorough import about samplers.
std::vector<std::string> about_samplers(const TinyGltf& file) {
  const auto result = file.import({.thorough = true});
  EXPECT_EQ(outcome(result), "ok");
  std::vector<std::string> out;
  for (const ImportIssue& issue : result->warnings)
    if (issue.json_pointer.starts_with("/animations/0/samplers")) {
      EXPECT_EQ(issue.severity, Severity::warning);
      EXPECT_THAT(issue.detail, HasSubstr("no channel uses the sampler"));
      out.push_back(issue.rule + " at " + issue.json_pointer);
    }
  return out;
}

TEST(faulty_animations, broken_samplers_that_no_channel_uses_are_named) {
  const auto with_sampler = [](const std::function<Json(TinyGltf&)>& make) {
    TinyGltf file = two_channels();
    const Json sampler = make(file);
    file.root["animations"][0]["samplers"].push_back(sampler);
    return about_samplers(file);
  };
  const auto sampler = [](std::size_t input, std::size_t output) { return Json{{"input", input}, {"output", output}}; };
  EXPECT_THAT(with_sampler([&](TinyGltf& f) {
                return sampler(f.times({0, 1}), f.scalars({1, 2, 3, 4}));
              }),
              IsEmpty())
      << "two weights a key, for instance";
  EXPECT_THAT(with_sampler([&](TinyGltf& f) {
                return sampler(f.vec3({0, 0, 0}), f.vec3({0, 0, 0}));
              }),
              ElementsAre("animation-input at /animations/0/samplers/2/input"));
  EXPECT_THAT(with_sampler([&](TinyGltf& f) {
                return sampler(f.times({1, 0}), f.vec3({0, 0, 0, 0, 0, 0}));
              }),
              ElementsAre("animation-times at /animations/0/samplers/2/input"));
  EXPECT_THAT(with_sampler([&](TinyGltf& f) {
                return sampler(f.times({-1, 0}), f.vec3({0, 0, 0, 0, 0, 0}));
              }),
              ElementsAre("animation-times at /animations/0/samplers/2/input"));
  EXPECT_THAT(with_sampler([&](TinyGltf& f) {
                return sampler(f.times({0, 1}), f.vec3({0, 0, 0}));
              }),
              ElementsAre("animation-output at /animations/0/samplers/2/output"));
  EXPECT_THAT(with_sampler([&](TinyGltf& f) {
                return sampler(f.times({0, 1}), f.scalars({0, NAN}));
              }),
              ElementsAre("animation-values at /animations/0/samplers/2/output"));
  EXPECT_THAT(with_sampler([&](TinyGltf& f) {
                Json cubic = sampler(f.times({0, 1}), f.scalars({0, 1, 2, 3}));
                cubic["interpolation"] = "CUBICSPLINE";
                return cubic;
              }),
              ElementsAre("animation-output at /animations/0/samplers/2/output"));
}

}  // namespace
}  // namespace sinew::test
