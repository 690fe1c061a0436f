// SPDX-License-Identifier: MIT
// Events and curves in `extras` of animations, read and written again.
#include "importer/read/annotations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "importer/clip_annotations.h"
#include "importer/export_glb.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A clip of 2 s with these extras.
TinyGltf noted(const char* extras) {
  TinyGltf file;
  file.root["nodes"] = Json::array({Json::object()});
  const std::size_t input = file.times({0, 2});
  file.animate("translation", input, file.vec3({0, 0, 0, 1, 0, 0}));
  file.root["animations"][0]["extras"] = Json::parse(extras);
  return file;
}

constexpr const char* kAll = R"({"mood": "calm",
  "events": [{"time": 1.5, "name": "left foot"}, {"time": 0.1, "name": "right foot"}],
  "curves": {"aim": {"type": "rotation", "keys": [{"time": 0, "value": [0, 0, 0, 1]}]},
             "open": {"keys": [{"time": 1, "value": true}]},
             "tint": {"blend": "heaviest", "keys": [{"time": 0, "value": [1, 0.5, 0]}]},
             "width": {"blend": "sum", "keys": [{"time": 0, "value": 1, "step": "cubic", "out": 2},
                                                {"time": 1, "value": 3, "in": 4, "step": "hold"}]}}})";

TEST(annotations, are_read_from_extras_and_compiled_into_the_clip) {
  const auto result = noted(kAll).import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_THAT(result->warnings, IsEmpty());
  const Annotations& notes = result->scene.clips.at(0).annotations();
  EXPECT_EQ(notes, result->scene.animations[0].annotations);
  EXPECT_THAT(notes.event_times_s, ElementsAre(0.1, 1.5));
  EXPECT_THAT(notes.event_names, ElementsAre("right foot", "left foot"));
  ASSERT_EQ(notes.curves.size(), 4u);
  const NamedCurve& width = *notes.find_curve("width");
  EXPECT_EQ(width.blend, CurveBlend::sum);
  EXPECT_THAT(width.keys_of<float>(), ElementsAre(CurveKey<float>{0.0f, CurveStep::cubic, 1.0f, 0.0f, 2.0f},
                                                  CurveKey<float>{1.0f, CurveStep::hold, 3.0f, 4.0f, 0.0f}));
  EXPECT_EQ(notes.find_curve("aim")->keys_of<glm::quat>().size(), 1u);
  EXPECT_EQ(notes.find_curve("tint")->keys_of<glm::vec3>()[0].value, glm::vec3(1, 0.5f, 0));
  EXPECT_TRUE(notes.find_curve("open")->keys_of<bool>()[0].value);
}

TEST(annotations, of_another_form_are_left_out_and_named) {
  const auto result = noted(R"({"events": [{"time": 2.5, "name": "late"}, {"time": "1", "name": "text"}, 7,
                                           {"time": 2, "name": "kept"}],
    "curves": {"a/b": {"keys": []}, "mixed": {"keys": [{"time": 0, "value": 1}, {"time": 1, "value": [1, 2]}]},
               "rule": {"blend": "max", "keys": [{"time": 0, "value": 1}]},
               "summed": {"blend": "sum", "keys": [{"time": 0, "value": true}]},
               "back": {"keys": [{"time": 1, "value": 1}, {"time": 0, "value": 1}]},
               "kept": {"keys": [{"time": 0, "value": 1}]}}})")
                          .import();
  ASSERT_EQ(outcome(result), "ok");
  const Annotations& notes = result->scene.clips.at(0).annotations();
  EXPECT_THAT(notes.event_names, ElementsAre("kept"));
  ASSERT_EQ(notes.curves.size(), 1u);
  std::vector<std::string> places;
  for (const ImportIssue& issue : result->warnings) {
    EXPECT_EQ(issue.rule, "animation-extras");
    places.push_back(issue.json_pointer);
  }
  EXPECT_THAT(places, testing::UnorderedElementsAre(
                          "/animations/0/extras/events/0/time", "/animations/0/extras/events/1",
                          "/animations/0/extras/events/2", "/animations/0/extras/curves/a~1b",
                          "/animations/0/extras/curves/mixed/keys/1", "/animations/0/extras/curves/rule/blend",
                          "/animations/0/extras/curves/summed", "/animations/0/extras/curves/back"));
}

TEST(annotations, extras_of_other_programs_are_no_fault) {
  for (const char* extras : {"7", "[1]", "{\"speed\": 2}", "null"}) {
    const auto result = noted(extras).import();
    ASSERT_EQ(outcome(result), "ok");
    EXPECT_THAT(result->warnings, IsEmpty()) << extras;
    EXPECT_TRUE(result->scene.clips.at(0).annotations().empty());
  }
}

TEST(annotations, are_written_back_beside_other_extras) {
  const auto result = noted(kAll).import();
  ASSERT_EQ(outcome(result), "ok");
  Json animation = Json::parse(R"({"name": "walk", "extras": {"mood": "calm", "events": 7}})");
  set_annotations(result->scene.animations[0].annotations, animation);
  EXPECT_EQ(animation["extras"]["mood"], "calm");
  IssueLog log;
  EXPECT_EQ(read_annotations(animation["extras"], "/extras", 2.0, log), result->scene.animations[0].annotations);
  set_annotations({}, animation);
  EXPECT_EQ(animation["extras"], Json({{"mood", "calm"}}));
}

TEST(annotations, go_with_the_clip_through_every_command) {
  const ToolModelFile folder;
  TinyGltf file = noted(kAll);
  file.root["animations"][0]["name"] = "walk";
  const std::string source = folder.beside("walk.gltf");
  std::ofstream(source) << file.text();
  const auto notes_of = [](const std::string& path) {
    const auto read = import_gltf(path);
    EXPECT_EQ(outcome(read), "ok") << path;
    return read ? read->scene.animations.at(0).annotations : Annotations();
  };
  const Annotations before = notes_of(source);
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(run_tool({"convert", source, folder.beside("budget.glb"), "--budget", "1mm"}).status, 0);
  EXPECT_EQ(notes_of(folder.beside("budget.glb")), before);
  EXPECT_EQ(run_tool({"convert", source, folder.beside("mirrored.glb"), "--mirror"}).status, 0);
  EXPECT_THAT(notes_of(folder.beside("mirrored.glb")).event_names, ElementsAre("left foot", "right foot"));
  EXPECT_EQ(run_tool({"compile", source, "-o", folder.beside("walk.sinew")}).status, 0);
  for (const std::string& told :
       {run_tool({"info", source}).out, run_tool({"info", folder.beside("walk.sinew")}).out}) {
    EXPECT_THAT(told, HasSubstr("\"left foot\" at 1.5 s"));
    EXPECT_THAT(told, HasSubstr("(float, 2 keys)"));
  }
  const auto again = import_gltf(source);
  ASSERT_TRUE(export_glb(again->scene, folder.beside("exported.glb")));
  EXPECT_EQ(notes_of(folder.beside("exported.glb")), before);
}

TEST(annotations, from_a_file_beside_the_model_go_into_what_is_written) {
  const ToolModelFile folder;
  TinyGltf file = noted("{\"mood\": \"calm\"}");
  file.root["animations"][0]["name"] = "walk/fast";
  const std::string source = folder.beside("walk.gltf"), notes = folder.beside("notes.json");
  std::ofstream(source) << file.text();
  std::ofstream(notes) << R"({"walk/fast": {"events": [{"time": 0.5, "name": "step"}]}})";
  EXPECT_EQ(run_tool({"convert", source, folder.beside("a.glb"), "--annotations", notes}).status, 0);
  EXPECT_EQ(run_tool({"convert", source, folder.beside("b.glb"), "--annotations", notes, "--budget", "1mm"}).status, 0);
  for (const char* written : {"a.glb", "b.glb"}) {
    const auto read = import_gltf(folder.beside(written));
    ASSERT_EQ(outcome(read), "ok");
    EXPECT_THAT(read->scene.animations.at(0).annotations.event_names, ElementsAre("step")) << written;
  }
  EXPECT_EQ(run_tool({"compile", source, "-o", folder.beside("walk.sinew"), "--annotations", notes}).status, 0);
  EXPECT_THAT(run_tool({"info", folder.beside("walk.sinew")}).out, HasSubstr("\"step\" at 0.5 s"));

  auto again = import_gltf(source);
  EXPECT_THAT(annotate_clips(again->scene, R"({"walk/fast": {"curves": {"w": {"keys": [{"time": 0, "value": 1}]}}}})"),
              IsEmpty());
  EXPECT_EQ(again->scene.clips[0].annotations(), again->scene.animations[0].annotations);
  const auto refused = [&](const std::string& text) {
    std::ofstream(notes) << text;
    const CommandOutcome outcome = run_tool({"convert", source, folder.beside("c.glb"), "--annotations", notes});
    EXPECT_EQ(outcome.status, 1) << text;
    EXPECT_FALSE(std::ifstream(folder.beside("c.glb")).good());
    return outcome.err;
  };
  EXPECT_THAT(refused("[1"), HasSubstr("notes.json: error: json-syntax: is no JSON object"));
  EXPECT_THAT(refused(R"({"run": {}})"), HasSubstr("notes.json: /run: error: animation-extras: the model has no clip"));
  EXPECT_THAT(refused(R"({"walk/fast": 3})"), HasSubstr("/walk~1fast: error: animation-extras: is no object"));
  EXPECT_THAT(refused(R"({"walk/fast": {"mood": 1}})"), HasSubstr("/walk~1fast/mood: error: animation-extras"));
  EXPECT_THAT(refused(R"({"walk/fast": {"events": [{"time": 3, "name": "late"}]}})"),
              HasSubstr("/walk~1fast/events/0/time: error: animation-extras: is not within the animation"));
}

}  // namespace
}  // namespace sinew::test
