// SPDX-License-Identifier: MIT
#include "runtime/pose/correct_pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/reference/pose_corrective.h"
#include "tests/scenes/pose_samples.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using test::about_z;

/// A solved corrective with everything that a run of it needs.
class Rig {
 public:
  explicit Rig(const PoseSamples& samples) : pose_(joint_count(samples)) {
    auto solved = solve_corrective(samples);
    EXPECT_TRUE(solved.has_value()) << describe(solved ? ErrorCode::ok : solved.error());
    if (solved) corrective_ = *std::move(solved);
    scratch_.resize(scratch_size(corrective_));
    weights.resize(1 + *std::max_element(samples.weights.begin(), samples.weights.end()));
  }
  void turn(std::size_t driver, const glm::quat& rotation) {
    Transform t;
    t.rotation = rotation;
    pose_.span().set(corrective_.samples.drivers[driver].joint, t);
  }
  CorrectPoseJob job() {
    return {.corrective = &corrective_, .pose = pose_.span(), .scratch = scratch_, .weights = weights};
  }
  /// What is added to weights of zero.
  const std::vector<float>& at(std::span<const glm::quat> rotations) {
    for (std::size_t d = 0; d < rotations.size(); ++d) turn(d, rotations[d]);
    std::fill(weights.begin(), weights.end(), 0.0f);
    EXPECT_EQ(check(job()), ErrorCode::ok);
    EXPECT_EQ(run(job()), ErrorCode::ok);
    return weights;
  }
  float at(const glm::quat& rotation, std::size_t weight) { return at(std::span(&rotation, 1))[weight]; }

  std::vector<float> weights;

 private:
  static std::size_t joint_count(const PoseSamples& samples) {
    std::size_t count = 0;
    for (const PoseDriver& driver : samples.drivers) count = std::max<std::size_t>(count, driver.joint + 1);
    return count;
  }
  PoseCorrective corrective_;
  test::PoseBuffer pose_;
  std::vector<double> scratch_;
};

std::span<const glm::quat> sample_pose(const PoseSamples& samples, std::size_t s) {
  return std::span(samples.rotations).subspan(s * samples.drivers.size(), samples.drivers.size());
}

TEST(correct_pose, rejects_what_it_cannot_do) {
  Rig rig(test::hinge_samples());
  EXPECT_EQ(check(rig.job()), ErrorCode::ok);
  auto job = rig.job();
  job.corrective = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = rig.job();
  job.scratch = job.scratch.first(job.scratch.size() - 1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = rig.job();
  job.weights = job.weights.first(1);
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
  job = rig.job();
  job.pose.joint_count = 1;
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
}

TEST(correct_pose, a_sample_pose_gives_its_values_bit_for_bit_whatever_the_sign) {
  test::FixedRandom random(1);
  for (const bool partition : {false, true})
    for (const bool clamp : {false, true})
      for (std::uint32_t drivers = 1; drivers <= 4; ++drivers) {
        PoseSamples samples = test::random_samples(random, drivers, 9, 3);
        samples.partition = partition;
        samples.clamp = clamp;
        Rig rig(samples);
        for (std::size_t s = 0; s < 9; ++s) {
          std::vector<glm::quat> pose(sample_pose(samples, s).begin(), sample_pose(samples, s).end());
          for (int sign = 0; sign < 2; ++sign, pose[0] = -pose[0])
            for (std::size_t w = 0; w < 3; ++w) EXPECT_EQ(rig.at(pose)[w], samples.values[3 * s + w]);
        }
      }
}

// The values at a sample come from the interpolant too, not only from the rule for equal poses: a hair beside the
// sample they are the same but for the slope.
TEST(correct_pose, the_interpolant_goes_through_the_samples) {
  for (const RadialKernel kernel : {RadialKernel::linear, RadialKernel::gaussian, RadialKernel::thin_plate}) {
    PoseSamples samples = test::hinge_samples();
    samples.kernel = kernel;
    Rig rig(samples);
    const double angles[] = {0.0, 0.7, 1.5, 2.2};
    for (std::size_t s = 0; s < 4; ++s)
      for (std::size_t w = 0; w < 2; ++w)
        EXPECT_NEAR(rig.at(about_z(angles[s] + 1e-5), samples.weights[w]), samples.values[2 * s + w], 1e-4);
  }
}

struct Kind {
  RadialKernel kernel;
  PolynomialTail tail;
  float regularisation;
  bool partition, clamp;
};

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  for (const RadialKernel kernel : {RadialKernel::linear, RadialKernel::gaussian, RadialKernel::thin_plate})
    for (const PolynomialTail tail : {PolynomialTail::none, PolynomialTail::constant, PolynomialTail::affine})
      for (const float regularisation : {0.0f, 0.05f})
        for (int options = 0; options < 4; ++options)
          all.push_back({kernel, tail, regularisation, (options & 1) != 0, (options & 2) != 0});
  return all;
}

// Bound: the float that the result is rounded to, and the condition of the systems (below 1e5 here) times the rounding
// of double.
TEST(correct_pose, all_kinds_agree_with_the_equations_in_long_double) {
  test::FixedRandom random(2);
  int kind_index = 0;
  for (const Kind& kind : kinds()) {
    const std::uint32_t drivers = 1 + static_cast<std::uint32_t>(kind_index++ % 3);
    PoseSamples samples = test::random_samples(random, drivers, 12, 2);
    samples.kernel = kind.kernel;
    samples.tail = kind.tail;
    samples.regularisation = kind.regularisation;
    samples.partition = kind.partition;
    samples.clamp = kind.clamp;
    Rig rig(samples);
    for (int i = 0; i < 20; ++i) {
      std::vector<glm::quat> pose;
      for (std::uint32_t d = 0; d < drivers; ++d) pose.push_back(random.rotation());
      if (i % 4 == 3) pose.assign(sample_pose(samples, 5).begin(), sample_pose(samples, 5).end());
      reference::Pose turned;
      for (const glm::quat& q : pose) turned.push_back(reference::rotation_of(q));
      const auto truth = reference::correct_pose(samples, turned);
      const auto& found = rig.at(pose);
      for (std::size_t w = 0; w < 2; ++w)
        EXPECT_NEAR(static_cast<double>(found[w]), static_cast<double>(truth[w]),
                    1e-9 + 6.1e-8 * std::abs(static_cast<double>(truth[w])))
            << "kind " << kind_index << " pose " << i;
    }
  }
}

/// Largest change from step to step while a hinge turns twice round: its rotation returns as -q in between.
double largest_jump(Rig& rig, int steps) {
  constexpr double kTwoTurns = 4 * 3.14159265358979323846;
  const auto at = [&](int i) { return rig.at(std::vector<glm::quat>{about_z(kTwoTurns * i / steps)}); };
  std::vector<float> before = at(0);
  double largest = 0;
  for (int i = 1; i <= steps; ++i) {
    const std::vector<float> now = at(i);
    for (std::size_t w = 0; w < 2; ++w)
      largest = std::max(largest, std::abs(static_cast<double>(now[w]) - static_cast<double>(before[w])));
    before = now;
  }
  return largest;
}

TEST(correct_pose, weights_are_continuous_through_720_degrees) {
  for (const Kind& kind : kinds()) {
    if (kind.tail == PolynomialTail::affine) continue;  // needs poses off the hinge
    PoseSamples samples = test::hinge_samples();
    samples.kernel = kind.kernel;
    samples.tail = kind.tail;
    samples.regularisation = kind.regularisation;
    samples.partition = kind.partition;
    samples.clamp = kind.clamp;
    Rig rig(samples);
    const double jump = largest_jump(rig, 7200);
    EXPECT_GT(jump, 1e-4);
    EXPECT_LT(jump, 0.1);
    EXPECT_LT(jump, 0.6 * largest_jump(rig, 3600));  // half the step, half the change: a jump would stay
  }
}

TEST(correct_pose, a_twist_driver_is_blind_to_swings_and_a_swing_driver_to_twists) {
  PoseSamples samples = test::hinge_samples();
  samples.drivers[0].axis = {0, 0, 2};
  samples.drivers[0].measure = RotationMeasure::twist;
  Rig twist(samples);
  const glm::quat swing = quat_xyzw(0.3f, 0.1f, 0.0f, std::sqrt(0.9f));  // its axis lies across z
  for (const double angle : {0.1, 0.9, 1.7})
    for (std::size_t w = 0; w < 2; ++w)
      EXPECT_NEAR(twist.at(swing * about_z(angle), w), twist.at(about_z(angle), w), 2e-6);

  samples.drivers[0].axis = {1, 0, 0};
  samples.drivers[0].measure = RotationMeasure::swing;
  Rig swung(samples);
  for (const double angle : {0.1, 0.9, 1.7})
    for (std::size_t w = 0; w < 2; ++w)
      EXPECT_NEAR(swung.at(about_z(angle) * quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f), w), swung.at(about_z(angle), w), 2e-6);
}

TEST(correct_pose, an_affine_tail_reproduces_what_is_affine_in_the_sines) {
  test::FixedRandom random(3);
  PoseSamples samples = test::random_samples(random, 1, 10, 1);
  samples.rotations[0] = glm::quat(1, 0, 0, 0);
  samples.tail = PolynomialTail::affine;
  const auto affine = [](const glm::quat& q) { return 0.25f + 2.0f * q.w * (0.5f * q.x - 1.0f * q.y + 2.0f * q.z); };
  for (std::size_t s = 0; s < 10; ++s) samples.values[s] = affine(samples.rotations[s]);
  for (const RadialKernel kernel : {RadialKernel::linear, RadialKernel::gaussian, RadialKernel::thin_plate}) {
    samples.kernel = kernel;
    Rig rig(samples);
    for (int i = 0; i < 50; ++i) {
      const glm::quat q = random.rotation();
      EXPECT_NEAR(rig.at(q, 0), affine(q), 5e-5);  // the samples' values are rounded
    }
  }
}

TEST(correct_pose, a_partition_stays_within_the_values_and_is_whole_near_the_samples) {
  test::FixedRandom random(4);
  PoseSamples samples = test::random_samples(random, 1, 8, 1);
  samples.partition = true;
  for (float& v : samples.values) v = 3.0f;
  Rig whole(samples);
  for (int i = 0; i < 200; ++i) EXPECT_NEAR(whole.at(random.rotation_by(random.in(0, 2)), 0), 3.0f, 3e-6);

  samples = test::hinge_samples();
  samples.partition = true;
  samples.radius_rad = 0.1f;
  Rig far(samples);
  EXPECT_EQ(far.at(about_z(-3.0), 0), 0.0f);  // no sample reaches here
}

TEST(correct_pose, a_partition_that_is_clamped_stays_within_the_values_where_no_sample_reaches) {
  PoseSamples samples = test::hinge_samples();
  for (float& v : samples.values) v += 2.0f;
  samples.radius_rad = 0.1f;
  samples.partition = samples.clamp = true;
  Rig far(samples);
  EXPECT_EQ(far.at(about_z(-3.0), samples.weights[0]), 2.0f);
  EXPECT_EQ(far.at(about_z(-3.0), samples.weights[1]), 1.0f);
}

TEST(correct_pose, clamped_results_do_not_overshoot) {
  PoseSamples samples = test::hinge_samples();
  samples.values = {0, 0, 0, 0, 1, 1, 1, 1};
  samples.radius_rad = 1.5f;
  Rig free(samples);
  samples.clamp = true;
  Rig clamped(samples);
  float lowest = 0, highest = 1;
  for (double angle = 0; angle < 2.2; angle += 0.01) {
    const float f = free.at(about_z(angle), 0), c = clamped.at(about_z(angle), 0);
    lowest = std::min(lowest, f);
    highest = std::max(highest, f);
    EXPECT_EQ(c, std::clamp(f, 0.0f, 1.0f));
  }
  EXPECT_LT(lowest, -0.01f);
  EXPECT_GT(highest, 1.01f);
}

TEST(correct_pose, corrections_add_to_the_weights_that_are_there_and_N26_tiny_sums_are_flushed) {
  Rig rig(test::hinge_samples());
  rig.turn(0, about_z(1.5));
  rig.weights = {0.25f, -1.0f};
  EXPECT_EQ(run(rig.job()), ErrorCode::ok);
  EXPECT_EQ(rig.weights, (std::vector<float>{0.65f, 0.0f}));
  rig.turn(0, about_z(0));
  rig.weights = {1e-30f, -1e-39f};
  EXPECT_EQ(run(rig.job()), ErrorCode::ok);
  EXPECT_EQ(rig.weights, (std::vector<float>{0.0f, 0.0f}));
}

TEST(correct_pose, regularised_twins_meet_halfway) {
  PoseSamples samples = test::hinge_samples();
  samples.rotations[1] = samples.rotations[2];
  samples.regularisation = 1e-4f;
  Rig rig(samples);
  EXPECT_NEAR(rig.at(about_z(1.5), 1), 0.65f, 1e-3f);
}

TEST(correct_pose, a_run_allocates_nothing) {
  test::FixedRandom random(5);
  Rig rig(test::random_samples(random, 3, 20, 5));
  const CorrectPoseJob job = rig.job();
  const test::AllocationCounter counter;
  EXPECT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace sinew
