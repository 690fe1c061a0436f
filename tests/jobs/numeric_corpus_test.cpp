// SPDX-License-Identifier: MIT
/// The reference data of the corpus through whole jobs: what a compiled clip and the SIMD kernels make of each case.
#include <gtest/gtest.h>

#include "runtime/jobs/morph_vertices.h"
#include "runtime/jobs/sample_clip.h"
#include "tests/support/corpus.h"
#include "tests/support/numeric_corpus.h"
#include "tests/support/numeric_read.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using test::Json;
using test::Outcome;

/// The pose of a one-joint clip that holds these tracks. Several equal joints, so that lanes are filled and a tail is left.
Transform sample(const QuatTrack& rotation, const Vec3Track& translation, double time_s) {
  constexpr std::uint32_t kJoints = 21;
  std::vector<BoneAnimation> bones(kJoints);
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    bones[j].joint = j;
    bones[j].rotation = rotation;
    bones[j].translation = translation;
  }
  const Clip clip = test::clip_of(test::animation_of(std::move(bones)), test::chain_skeleton(kJoints));
  test::PoseBuffer pose(kJoints);
  run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}});
  for (std::size_t j = 1; j < kJoints; ++j) EXPECT_EQ(pose.span().get(j), pose.span().get(0)) << "lane " << j;
  return pose.span().get(0);
}

Outcome slerp_of(const Json& in) {
  const QuatTrack track{Interpolation::linear, {0, 1}, {test::quat<float>(in["q"]), test::quat<float>(in["r"])}};
  return {{"q", test::numbers(sample(track, {}, test::scalar<double>(in["t"])).rotation)}};
}

Outcome hermite_of(const Json& in) {
  const std::vector<float> times{test::scalar<float>(in["t0"]), test::scalar<float>(in["t1"])};
  const double t = test::scalar<double>(in["t"]);
  const auto keys = [&](auto read) {
    using V = decltype(read(in["v0"]));
    return Track<V>{Interpolation::cubic_spline, times,
                    {V{} * 0.0f, read(in["v0"]), read(in["out_tangent0"]), read(in["in_tangent1"]), read(in["v1"]), V{} * 0.0f}};
  };
  if (in["op"] == "vec3") return {{"v", test::numbers(sample({}, keys(test::vec3<float>), t).translation)}};
  return {{"q", test::numbers(sample(keys(test::quat<float>), {}, t).rotation)}};
}

Outcome morph_of(const Json& in) {
  const std::size_t count = in["weights"].size();
  MorphSet morphs;
  std::vector<float> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const Json& d = in["deltas"];
    MorphTarget& target = morphs.targets.emplace_back();
    target.positions = {{0}, {{test::scalar<float>(d[3 * i]), test::scalar<float>(d[3 * i + 1]), test::scalar<float>(d[3 * i + 2])}}};
    weights.push_back(test::scalar<float>(in["weights"][i]));
  }
  const std::vector<glm::vec3> base{test::vec3<float>(in["base"])};
  std::vector<glm::vec3> out(1), scratch(1);
  run(MorphVerticesJob{&morphs, weights, {base, {}, {}}, {out, {}, {}}, scratch, false});
  return {{"p", test::numbers(out[0])}};
}

void expect_all_cases(const char* kind, const std::function<Outcome(const Json&)>& job) {
  if (!test::corpus()) GTEST_SKIP() << test::kNoCorpus;
  const auto cases = test::numeric_cases(kind);
  if (cases.empty()) GTEST_SKIP() << "the corpus has no cases of kind " << kind;
  const test::NumericReport report = test::run_numeric(cases, {"job", job});
  std::printf("  %s: %d cases, worst %.3f of the tolerance (%s)\n", kind, report.run, report.worst, report.worst_case.c_str());
  EXPECT_EQ(report.run, static_cast<int>(cases.size()));
  EXPECT_EQ(report.failed, 0) << report.failures;
}

TEST(jobs_numeric_corpus, N01_N02_N03_sampled_slerp_holds_every_case) { expect_all_cases("slerp", slerp_of); }
TEST(jobs_numeric_corpus, G03_G04_sampled_splines_hold_every_case) { expect_all_cases("hermite", hermite_of); }
TEST(jobs_numeric_corpus, G42_morphed_vertices_hold_every_case) { expect_all_cases("morph", morph_of); }

TEST(jobs_numeric_corpus, N07_N08_N09_sampled_squad_holds_every_case) {
  if (!test::corpus()) GTEST_SKIP() << test::kNoCorpus;
  // The job answers the rotation only: the control points are folded into the clip.
  auto cases = test::numeric_cases("squad");
  if (cases.empty()) GTEST_SKIP() << "the corpus has no cases of kind squad";
  for (Json& c : cases) c["accept"] = {{"metric", "rotation_angle"}, {"tol", c["accept"]["tol"]}, {"norm_tol", c["accept"]["norm_tol"]}};
  const test::NumericReport report = test::run_numeric(cases, {"job", [](const Json& in) {
    QuatTrack track{Interpolation::squad, {0, 1, 2, 3}, {}};
    for (const Json& key : in["keys"]) track.values.push_back(test::quat<float>(key));
    return Outcome{{"q", test::numbers(sample(track, {}, 1.0 + test::scalar<double>(in["t"])).rotation)}};
  }});
  std::printf("  squad: %d cases, worst %.3f of the tolerance (%s)\n", report.run, report.worst, report.worst_case.c_str());
  EXPECT_EQ(report.failed, 0) << report.failures;
}

}  // namespace
}  // namespace sinew
