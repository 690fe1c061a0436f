// SPDX-License-Identifier: MIT
// The page of `sinew verify`: what it says about files that moved, kept still or could not be read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "importer/file/base64.h"
#include "importer/tool/verify/pose_history.h"
#include "importer/tool/verify/verify_report.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {
using json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr double kMoved_m = 0.25;
constexpr std::size_t kMovedSample = 3;

/// The findings inside a page.
json findings_of(const std::string& page) {
  const std::string text = text_of_file(page), begin = "<script type=\"application/json\" id=\"report\">";
  const std::size_t at = text.find(begin) + begin.size();
  return json::parse(text.substr(at, text.find("</script>", at) - at));
}

/// A model with golden poses of which one joint is elsewhere in one sample.
class VerifyPage : public testing::Test {
 protected:
  VerifyPage() {
    EXPECT_EQ(run_tool({"sample", model_.path(), "--clip", "bend", "--fps", "10", "-o", golden_}).status, 0);
    json poses = json::parse(text_of_file(golden_));
    json& x = poses["clips"][0]["samples"][kMovedSample]["nodes"][2]["world"][12];
    x = x.get<double>() + kMoved_m;
    std::ofstream(moved_) << poses;
  }

  CommandOutcome verify(const std::string& golden, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"verify", model_.path(), golden, "--html", page_});
    return run_tool(more);
  }

  ToolModelFile model_;
  std::string golden_ = model_.beside("golden.json"), moved_ = model_.beside("moved.json"),
              page_ = model_.beside("page.html");
};

TEST_F(VerifyPage, curves_show_golden_and_current_poses) {
  EXPECT_EQ(verify(moved_).status, 1);
  const json file = findings_of(page_)["files"][0];
  EXPECT_EQ(file["verdict"], "moved");
  EXPECT_EQ(file["failed"], 1);
  EXPECT_NEAR(file["worst"][0]["amount"].get<double>(), kMoved_m, 1e-6);
  EXPECT_THAT(file["worst"][0]["where"].get<std::string>(), HasSubstr("\"tip\", translation"));
  EXPECT_EQ(file["starts"], json::array({"\"tip\""}));

  const json& joint = file["joints"][0];
  ASSERT_EQ(joint["times"].size(), 11u);
  for (std::size_t i = 0; i < joint["times"].size(); ++i) {
    const double off = joint["golden"][i][0].get<double>() - joint["now"][i][0].get<double>();
    EXPECT_NEAR(off, i == kMovedSample ? kMoved_m : 0.0, 1e-6) << i;
    EXPECT_EQ(joint["turned_deg"][i], 0.0) << i;
    EXPECT_EQ(file["over_time"][0]["ratios"][i].get<double>() > 1.0, i == kMovedSample) << i;
  }
  EXPECT_EQ(joint["worst_s"], joint["times"][kMovedSample]);
  EXPECT_EQ(file["figure"]["time_s"], joint["worst_s"]);
  EXPECT_EQ(file["figure"]["golden"].size(), file["figure"]["now"].size());
  EXPECT_EQ(file["figure"]["bones"], json::array({json::array({1, 2})}));
  EXPECT_GT(file["figure"]["vertices"].size(), 3u);
}

TEST_F(VerifyPage, failures_come_first_and_the_worst_of_them_on_top) {
  const std::filesystem::path models = model_.beside("models"), goldens = model_.beside("goldens");
  for (const auto& folder : {models, goldens}) std::filesystem::create_directory(folder);
  json far = json::parse(text_of_file(moved_));
  far["clips"][0]["samples"][0]["nodes"][2]["world"][13] = 7.0;
  for (const char* name : {"a_same", "b_moved", "c_far", "d_without_golden"}) {
    std::filesystem::copy(model_.path(), models / (std::string(name) + ".gltf"));
    if (std::string(name) == "c_far")
      std::ofstream(goldens / "c_far.json") << far;
    else if (std::string(name) != "d_without_golden")
      std::filesystem::copy(std::string(name) == "a_same" ? golden_ : moved_, goldens / (std::string(name) + ".json"));
  }
  EXPECT_EQ(run_tool({"verify", models.string(), goldens.string(), "--html", page_}).status, 4);
  std::vector<std::string> order;
  const json findings = findings_of(page_);
  for (const json& file : findings["files"])
    order.push_back(std::filesystem::path(file["file"].get<std::string>()).stem().string() + " " +
                    file["verdict"].get<std::string>());
  EXPECT_EQ(order,
            (std::vector<std::string>{"d_without_golden unread", "c_far moved", "b_moved moved", "a_same same"}));
}

TEST_F(VerifyPage, says_when_golden_poses_were_written_again) {
  EXPECT_EQ(verify(moved_, {"--update"}).status, 0);
  EXPECT_EQ(findings_of(page_)["files"][0]["verdict"], "updated");
  EXPECT_EQ(verify(moved_).status, 0);
  EXPECT_EQ(findings_of(page_)["files"][0]["verdict"], "same");
}

TEST_F(VerifyPage, names_in_files_cannot_end_the_script) {
  json scene = json::parse(text_of_file(model_.path()));
  scene["nodes"][2]["name"] = "</script><b>";
  std::ofstream(model_.path()) << scene;
  EXPECT_EQ(verify(moved_).status, 1);
  EXPECT_THAT(text_of_file(page_), Not(HasSubstr("</script><b>")));
  EXPECT_EQ(findings_of(page_)["files"][0]["starts"], json::array({"\"</script><b>\""}));
}

TEST_F(VerifyPage, bad_outputs_and_options_are_refused_before_any_work) {
  EXPECT_EQ(run_tool({"verify", model_.path(), golden_, "--html", model_.beside("no/page.html")}).status, 2);
  EXPECT_EQ(run_tool({"verify", model_.path(), golden_, "--viewer", "sinew-viewer"}).status, 2) << "no page";
}

TEST_F(VerifyPage, a_viewer_that_is_missing_costs_the_picture_alone) {
  const CommandOutcome outcome = verify(moved_, {"--viewer", model_.beside("no-viewer")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("warning: " + model_.beside("no-viewer") + ": no picture of"));
  EXPECT_FALSE(findings_of(page_)["files"][0].contains("picture"));
}

#ifndef _WIN32
TEST_F(VerifyPage, the_picture_of_a_viewer_is_on_the_page) {
  const std::string viewer = model_.beside("viewer");
  std::ofstream(viewer) << "#!/bin/sh\nprintf '%s ' \"$@\" > \"$3\"\n";  // its words in place of a picture
  std::filesystem::permissions(viewer, std::filesystem::perms::owner_all);
  EXPECT_EQ(verify(moved_, {"--viewer", viewer}).status, 1);
  const auto picture = findings_of(page_)["files"][0]["picture"].get<std::string>();
  const std::string begin = "data:image/png;base64,";
  ASSERT_EQ(picture.substr(0, begin.size()), begin);
  const auto bytes = decode_base64(picture.substr(begin.size()));
  ASSERT_TRUE(bytes);
  const std::string words(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  EXPECT_EQ(words.find(model_.path() + " --headless "), 0u);
  EXPECT_THAT(words, HasSubstr("--clip 0 --time 0.3"));
  EXPECT_EQ(words.back(), ' ') << "no byte is lost at the end";
}
#endif

TEST(pose_history, the_change_starts_at_moved_joints_without_a_moved_joint_above) {
  Skeleton skeleton;  // 0 -> 1 -> 2, 0 -> 3
  skeleton.parents = {kNone, 0, 0, 1};
  skeleton.node_of_joint = {0, 1, 3, 2};
  skeleton.joint_of_node = {0, 1, 3, 2};
  const auto moved = [](std::uint32_t node, double amount) {
    return tool::Deviation{.amount = amount, .tolerance = 0.1, .kind = "translation", .clip = 0, .node = node};
  };
  const auto history =
      tool::PoseHistory::of({moved(2, 0.9), moved(3, 0.8), moved(1, 0.7)}, skeleton, {{}, {"", "\"arm\"", "\"hand\""}});
  EXPECT_EQ(history.starts, (std::vector<std::string>{"node 3", "\"arm\""}));
  ASSERT_EQ(history.joints.size(), 3u);
  EXPECT_EQ(history.joints[0].node, 3u) << "the worst of those where it starts";
  EXPECT_EQ(history.joints[1].node, 2u) << "then by difference";
}

TEST(verify_page, traces_of_graphs_follow_what_was_measured_and_show_their_differences_in_words) {
  tool::VerifiedFile trace{.file = "walk.glb", .golden = "walk.trace", .code = tool::ExitCode::input_at_fault};
  trace.compared = 90;
  trace.failed = 2;
  trace.lines = {"frame 3: <run> in place of walk"};
  tool::VerifiedFile poses = trace;
  poses.file = "poses.glb";
  poses.lines.clear();
  poses.worst.emplace_back();
  const std::string page = tool::verify_page(std::vector{trace, trace, poses});
  EXPECT_THAT(page, Not(HasSubstr("<run>")));
  const std::string begin = "<script type=\"application/json\" id=\"report\">";
  const std::size_t at = page.find(begin) + begin.size();
  const json files = json::parse(page.substr(at, page.find("</script>", at) - at))["files"];
  EXPECT_EQ(files[0]["file"], "poses.glb");
  EXPECT_FALSE(files[0].contains("lines"));
  EXPECT_EQ(files[1]["lines"], json::array({trace.lines[0]}));
  EXPECT_FALSE(files[1].contains("figure"));
}

}  // namespace
}  // namespace sinew::test
