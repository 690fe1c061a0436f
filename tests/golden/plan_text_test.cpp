// SPDX-License-Identifier: MIT
// `sinew plan` on the project's samples prints the texts stored in plans/: which stages run, and why. After a
// deliberate change:
//     SINEW_RECORD=1 build/release/bin/sinew-test-plan-text     writes the new texts
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "importer/export_glb.h"
#include "samples/showcase/showcase.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

const fs::path kPlans = SINEW_SOURCE_DIR "/tests/golden/plans";

/// The samples as files in a folder of this process; the destructor removes the folder.
class Samples {
 public:
  Samples() : folder_(fs::path(::testing::TempDir()) / ("sinew-plan-texts-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    add("skull.glb", showcase::skull_flight().scene);
    add("arms.glb", showcase::twisted_arms().scene);
    add("face.glb", showcase::morphed_face().scene);
    fs::copy_file(SINEW_SOURCE_DIR "/samples/link_from_an_engine/lift.gltf", file("lift.gltf"),
                  fs::copy_options::overwrite_existing);
  }
  ~Samples() { fs::remove_all(folder_); }
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  void add(const std::string& name, const Scene& scene) const {
    ASSERT_TRUE(export_glb(scene, file(name)).has_value()) << name;
  }

  fs::path folder_;
};

/// Runs `sinew plan SAMPLE ARGUMENTS...` and compares its output with the stored text.
void expect_plan(const Samples& samples, const std::string& name, const std::string& sample,
                 std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"plan", samples.file(sample)});
  const CommandOutcome outcome = run_tool(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  if (std::getenv("SINEW_RECORD")) std::ofstream(kPlans / name, std::ios::binary) << outcome.out;
  EXPECT_EQ(outcome.out, text_of_file(kPlans / name))
      << name << "; if that was meant: SINEW_RECORD=1 sinew-test-plan-text";
}

TEST(plan_text, of_the_samples_equals_the_stored_text) {
  const Samples samples;
  expect_plan(samples, "skull.txt", "skull.glb", {});
  expect_plan(samples, "skull_by_joints.txt", "skull.glb",
              {"--needs", "joints,bounds", "--layers", "1", "--clip", "0"});
  expect_plan(samples, "arms.txt", "arms.glb",
              {"--clip", "0", "--needs", "positions,normals,bounds", "--normals", "cofactor"});
  expect_plan(samples, "arms_three_ways.txt", "arms.glb",
              {"--skinning", "linear,dual-quaternion,center-of-rotation,linear", "--clip", "0"});
  expect_plan(samples, "arms_by_palettes.txt", "arms.glb", {"--needs", "palettes,weights", "--clip", "0"});
  expect_plan(samples, "face.txt", "face.glb", {"--clip", "0"});
  expect_plan(samples, "face_at_rest.txt", "face.glb", {"--clip", "none"});
  expect_plan(samples, "face_layered.txt", "face.glb",
              {"--needs", "weights,additive,masks,properties,hidden-meshes,stage-times"});
  expect_plan(samples, "lift.txt", "lift.gltf", {});
  expect_plan(samples, "skull_in_less_detail.txt", "skull.glb",
              {"--clip", "0", "--joint-tolerance", "20", "--needs", "joints,positions,between-updates"});
  expect_plan(samples, "arms_in_less_detail.txt", "arms.glb", {"--clip", "0", "--joint-tolerance", "3 m"});
}

TEST(plan_text, is_the_same_as_json) {
  const Samples samples;
  expect_plan(samples, "skull.json", "skull.glb", {"--json", "--clip", "0"});
  expect_plan(samples, "arms.json", "arms.glb", {"--json", "--skinning", "dual-quaternion", "--clip", "0"});
  expect_plan(samples, "face.json", "face.glb", {"--json", "--layers", "2"});
  expect_plan(samples, "arms_in_less_detail.json", "arms.glb", {"--json", "--clip", "0", "--joint-tolerance", "3 m"});
}

}  // namespace
}  // namespace sinew::test
