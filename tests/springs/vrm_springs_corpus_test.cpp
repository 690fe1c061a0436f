// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "importer/import_gltf.h"
#include "importer/vrm_springs.h"
#include "tests/springs/spring_stage.h"
#include "tests/support/corpus.h"
#include "tests/support/file_text.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

Vec3<double> vector_from(const Json& v) { return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()}; }

struct Worst {
  double rad = 0.0, metres = 0.0;
};

/// Replays a stored run, and compares rotations and tails of every frame.
Worst replay(const std::filesystem::path& stored, const Json& run) {
  const auto model = stored.parent_path().parent_path() / "vrm" / run["file"].get<std::string>();
  const auto file = import_gltf(model);
  EXPECT_TRUE(file && file->vrm) << model;
  if (!file || !file->vrm) return {};
  const Skeleton& skeleton = file->scene.skeleton;
  const VrmSprings springs = spring_setup_of(*file->vrm, skeleton);
  EXPECT_TRUE(springs.left_out.empty());
  EXPECT_EQ(springs.setup.joints.size(), run["joints"].size());
  SpringStage stage(skeleton, springs.setup);
  stage.move_root(figure_of_eight(0.0));
  stage.frame(0.0);
  Worst worst;
  double before_s = 0.0;
  for (const Json& frame : run["frames"]) {
    const double t_s = frame["t"].get<double>();
    stage.move_root(figure_of_eight(t_s));
    stage.frame(t_s - before_s);
    before_s = t_s;
    for (std::size_t s = 0; s < stage.tails.size(); ++s) {
      const Json& q = frame["q"][s];
      const auto rotation = quat_xyzw(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(), q[3].get<double>());
      worst.rad = std::max(worst.rad, angle_between(stage.rotation(springs.setup.joints[s].joint), rotation));
      worst.metres = std::max(worst.metres, distance(stage.tails[s], vector_from(frame["tail"][s])));
    }
  }
  return worst;
}

TEST(vrm_springs_corpus, agree_with_stored_runs_at_60_hz) {
  const auto root = corpus();
  if (!root) GTEST_SKIP() << "no corpus";
  int runs = 0;
  for (const auto& stored : corpus_files("motion", {".json"})) {
    const Json run = Json::parse(text_of_file(stored));
    if (!run.is_object() || !run.contains("fps") || run["fps"] != 60 || !run.contains("frames")) continue;
    const Worst worst = replay(stored, run);
    EXPECT_LE(worst.rad, 1e-4) << stored;
    EXPECT_LE(worst.metres, 1e-5) << stored;
    RecordProperty(stored.stem().string() + "_rad", std::to_string(worst.rad * 1e9) + "e-9");
    ++runs;
  }
  if (runs == 0) GTEST_SKIP() << "no stored runs";
}

}  // namespace
}  // namespace sinew::test
