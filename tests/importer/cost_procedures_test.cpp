// SPDX-License-Identifier: MIT
// Errors of the groups of `sinew cost` about procedures.
#include <string>

#include "importer/tool/cost/words.h"
#include "tests/importer/cost_study.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

Study studied(Study (*study)(const Subject&)) {
  Scene scene;
  scene.skeleton = skeleton_of({kNone});
  finish_scene(scene);
  return study(Subject(scene, kNone, Effort::quick()));
}

double error_in(const Group& group, const char* name) {
  const Point* point = cost::find(group, name);
  EXPECT_NE(point, nullptr) << name;
  return point ? point->error : -1.0;
}

TEST(cost_procedures, solvers_leave_less_with_more_iterations_and_less_than_the_budget_of_engines) {
  const Study study = studied(cost::study_inverse_kinematics);
  const Group& group = study.group;
  EXPECT_EQ(group.name, "inverse kinematics");
  ASSERT_EQ(group.points.size(), 16u);
  const double budget = error_in(group, "ccd, 4 iterations of 2 degrees");
  EXPECT_LT(budget, 1000.0);
  for (const char* solver : {"ccd", "fabrik", "damped"}) {
    const std::string name(solver);
    EXPECT_LT(error_in(group, (name + ", 4 iterations").c_str()), 0.2 * budget) << name;
    EXPECT_LT(error_in(group, (name + ", 16 iterations").c_str()), error_in(group, (name + ", 1 iteration").c_str()));
  }
  EXPECT_LT(error_in(group, "damped, 8 iterations"), 1e-3) << "it is exact";
  EXPECT_EQ(cost::default_of(group).name, "fabrik, 16 iterations");
  EXPECT_EQ(study.findings(group).size(), 3u);
}

TEST(cost_procedures, ticks_swing_alike_at_any_frame_rate_and_steps_of_frames_do_not) {
  const Study study = studied(cost::study_springs);
  const Group& group = study.group;
  EXPECT_EQ(group.name, "springs");
  ASSERT_EQ(group.points.size(), 12u);
  for (const Point& point : group.points) {
    ASSERT_EQ(point.values.size(), 1u);
    const bool is_at_60 = point.name.ends_with("60 Hz"), has_ticks = point.name.starts_with("ticks");
    if (is_at_60) {
      EXPECT_EQ(point.values[0].value, 0.0) << point.name;
    } else if (has_ticks) {
      EXPECT_LT(point.values[0].value, 1.0) << point.name;
    } else {
      EXPECT_GT(point.values[0].value, 20.0) << point.name;
    }
  }
  EXPECT_EQ(error_in(group, "ticks of 1/60 s, 60 Hz"), error_in(group, "a step a frame, 60 Hz")) << "the same steps";
  EXPECT_LT(error_in(group, "ticks of 1/240 s, 60 Hz"), 0.5 * error_in(group, "ticks of 1/60 s, 60 Hz"));
  EXPECT_EQ(cost::default_of(group).name, "ticks of 1/60 s, 60 Hz");
  EXPECT_EQ(study.findings(group).size(), 2u);
}

}  // namespace
}  // namespace sinew::test
