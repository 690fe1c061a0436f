// SPDX-License-Identifier: MIT
// Every option of `sinew plan` alone: the stages are those of a plan that the library compiles for the same needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "importer/import_gltf.h"
#include "runtime/lod/compile_skeleton_lod.h"
#include "runtime/plan/compile_plan.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using json = nlohmann::json;
using Strings = std::vector<std::string>;

/// The model, with a second skinned mesh in place of the face: two instances that may be skinned by different methods.
class PlanModel {
 public:
  PlanModel() {
    json file = json::parse(tool_model());
    file["nodes"][3] = {{"name", "second"}, {"mesh", 0}, {"skin", 0}};
    file["animations"].erase(1);
    json still = file["animations"][0];
    still["name"] = "still";
    still["channels"][0]["target"]["node"] = 0;
    file["animations"].push_back(still);
    std::ofstream(model_.path(), std::ios::binary) << file;
    auto read = import_gltf(model_.path());
    EXPECT_TRUE(read);
    scene = std::move(read->scene);
  }

  json report(Strings arguments) const {
    arguments.insert(arguments.begin(), {"plan", model_.path(), "--json"});
    return json::parse(run_tool(arguments).out);
  }

  Scene scene;

 private:
  ToolModelFile model_;
};

json stages_of(const Scene& scene, const Needs& needs) {
  json out = json::array();
  for (const PlanStage& stage : compile_plan(lend(scene), needs).stages())
    out.push_back({{"stage", stage.stage},
                   {"runs", stage.runs},
                   {"reason", stage.reason},
                   {"count", stage.count},
                   {"bytes", stage.bytes}});
  return out;
}

template <bool Outputs::*flag>
bool& out(Needs& needs) {
  return needs.out.*flag;
}

template <bool Inputs::*flag>
bool& in(Needs& needs) {
  return needs.in.*flag;
}

TEST(tool_plan, each_need_alone_is_that_need_of_the_library) {
  const PlanModel model;
  const std::pair<const char*, bool& (*)(Needs&)> flags[] = {
      {"joints", out<&Outputs::joints>},           {"weights", out<&Outputs::weights>},
      {"positions", out<&Outputs::positions>},     {"normals", out<&Outputs::normals>},
      {"tangents", out<&Outputs::tangents>},       {"palettes", out<&Outputs::palettes>},
      {"bounds", out<&Outputs::bounds>},           {"properties", out<&Outputs::properties>},
      {"additive", in<&Inputs::additive>},         {"hidden-meshes", out<&Outputs::hidden_meshes>},
      {"stage-times", out<&Outputs::stage_times>}, {"between-updates", in<&Inputs::between_updates>},
      {"local-pose", out<&Outputs::local_pose>}};
  for (const auto& [name, flag] : flags) {
    Needs needs;
    for (const auto& [other, member] : flags) member(needs) = false;
    flag(needs) = true;
    const json report = model.report({"--needs", name});
    EXPECT_EQ(report["stages"], stages_of(model.scene, needs)) << name;
    EXPECT_EQ(report["frame_bytes"], compile_plan(lend(model.scene), needs).frame_bytes()) << name;
  }
}

TEST(tool_plan, each_other_option_alone_is_that_of_the_library) {
  const PlanModel model;
  EXPECT_EQ(model.report({})["stages"], stages_of(model.scene, {}));
  const auto expect = [&](const Strings& arguments, const std::function<void(Needs&)>& change) {
    Needs needs;
    change(needs);
    EXPECT_EQ(model.report(arguments)["stages"], stages_of(model.scene, needs)) << testing::PrintToString(arguments);
  };
  expect({"--layers", "7"}, [](Needs& n) { n.in.max_layers = 7; });
  expect({"--normals", "cofactor"}, [](Needs& n) { n.skin.normal_rule = NormalRule::cofactor; });
  expect({"--skinning", "dual-quaternion"}, [](Needs& n) { n.skin.kind = Skinning::dual_quaternion; });
  expect({"--skinning", "linear,dual-quaternion"}, [](Needs& n) {
    n.skin.per_instance = {Skinning::linear, Skinning::dual_quaternion};
  });
  expect({"--skinning", "dual-quaternion,linear"}, [](Needs& n) {
    n.skin.kind = Skinning::dual_quaternion;
    n.skin.per_instance = {Skinning::dual_quaternion, Skinning::linear};
  });
}

TEST(tool_plan, joints_are_left_out_over_the_clip_that_is_named_or_over_all) {
  const PlanModel model;
  const auto left_out = [&](const std::vector<std::uint32_t>& clips) {
    return compile_skeleton_lod(model.scene, 1e-3, clips, {}).left_out;
  };
  ASSERT_NE(left_out({0}), left_out({1})) << "the tip moves in one clip alone";
  for (const std::uint32_t clip : {0u, 1u}) {
    const json report = model.report({"--joint-tolerance", "1mm", "--clip", std::to_string(clip)});
    EXPECT_EQ(report["left_out_joints"]["left_out"].size(), left_out({clip})) << clip;
  }
  EXPECT_EQ(model.report({"--joint-tolerance", "1mm"})["left_out_joints"]["left_out"].size(), left_out({}));
}

}  // namespace
}  // namespace sinew::test
