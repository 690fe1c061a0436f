// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/procedures/chain_ik.h"
#include "samples/showcase/scene_builder.h"

namespace sinew::cost {
namespace {

constexpr std::uint32_t kBones = 8;
constexpr std::size_t kTargets = 32;
constexpr std::uint32_t kIterations[] = {1, 2, 4, 8, 16};

/// A chain of 1 m, and targets within its reach in all directions.
class Reaching {
 public:
  Reaching() {
    for (std::size_t i = 0; i < kTargets; ++i) {  // a spiral over the sphere
      const double y = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / kTargets, beside = std::sqrt(1.0 - y * y),
                   around = static_cast<double>(i) * std::numbers::pi * (3.0 - std::sqrt(5.0)),
                   far = 0.3 + 0.6 * static_cast<double>(i * 13 % kTargets) / kTargets;
      targets_.push_back(Vec3<double>(beside * std::cos(around), y, beside * std::sin(around)) * far);
    }
  }

  /// Solves for all targets, each time from the bent chain. Returns the mean distance that is left, in metres.
  double run(ChainGoal goal) {
    goal.joints = joints_;
    double left = 0.0;
    for (const Vec3<double>& target : targets_) {
      const ChainEffector effector{.joint = kBones, .target = target};
      goal.effectors = {&effector, 1};
      const std::size_t bytes = chain_ik_bytes(scene_.skeleton, goal);
      memory_.resize(bytes / sizeof(Block));
      for (std::uint32_t j = 0; j <= kBones; ++j) pose_.span().set(j, scene_.skeleton.rest[j]);
      IkResult result;
      run_unchecked(
          ChainIkJob{&scene_.skeleton, pose_.span(), goal, std::as_writable_bytes(std::span(memory_)), &result});
      left += static_cast<double>(result.metres_left) / kTargets;
    }
    return left;
  }

 private:
  struct alignas(64) Block {
    std::byte bytes[64];
  };

  static Scene make_scene() {
    showcase::SceneBuilder scene;
    for (std::uint32_t j = 0; j <= kBones; ++j) {
      const float bend = 0.1f * static_cast<float>(j % 3);
      scene.add_joint(fmt::format("bone {}", j), j == 0 ? kNone : j - 1,
                      {.translation = {0.0f, j == 0 ? 0.0f : 1.0f / kBones, 0.0f},
                       .rotation = quat_xyzw(std::sin(bend), 0.0f, 0.0f, std::cos(bend))});
    }
    return scene.finish();
  }
  static std::vector<ChainIkJoint> make_joints() {
    std::vector<ChainIkJoint> joints(kBones);
    for (std::uint32_t j = 0; j < kBones; ++j) joints[j].joint = j;
    return joints;
  }

  Scene scene_ = make_scene();
  std::vector<ChainIkJoint> joints_ = make_joints();
  std::vector<Vec3<double>> targets_;
  PoseMemory pose_{kBones + 1};
  std::vector<Block> memory_;
};

struct StudiedSolver {
  const char *name, *note;
  ChainSolver solver;
};
constexpr StudiedSolver kStudiedSolvers[] = {
    {"ccd", "each joint from the last to the first turns the tip to its target", ChainSolver::ccd},
    {"fabrik", "places of joints move to the target and back, then joints turn to them", ChainSolver::fabrik},
    {"damped", "damped least squares over all joints", ChainSolver::damped}};
constexpr const char* kBudget = "ccd, 4 iterations of 2 degrees";

std::string chain_point(const char* solver, std::uint32_t iterations) {
  return fmt::format("{}, {} iteration{}", solver, iterations, iterations == 1 ? "" : "s");
}

void add_goal(Study& study, const std::shared_ptr<Reaching>& reaching, const ChainGoal& goal, std::string name,
              const char* note) {
  const ChainGoal usual;
  Point point;
  point.name = std::move(name);
  point.note = note;
  point.error = 1e3 * reaching->run(goal);
  point.is_default =
      goal.solver == usual.solver && goal.iterations == usual.iterations && goal.most_turn_rad == usual.most_turn_rad;
  study.add(std::move(point), {kTargets, [reaching, goal] { reaching->run(goal); }});
}

std::vector<std::string> findings_of_ik(const Group& group) {
  const Point &usual = default_of(group), *budget = find(group, kBudget),
              *close = find(group, chain_point("damped", 8));
  return {fmt::format("The default, {}, leaves {} of a chain of 1 m and takes {}.", usual.name, error_of(group, usual),
                      time_of(group, usual)),
          fmt::format("Damped least squares leave {} after 8 iterations, which {}.", error_of(group, *close),
                      time_beside(group, *close, usual)),
          fmt::format("The budget of many engines, {}, leaves {}.", budget->name, error_of(group, *budget))};
}

}  // namespace

Study study_inverse_kinematics(const Subject&) {
  Study study;
  Group& group = study.group;
  group.name = "inverse kinematics";
  group.title = "Inverse kinematics";
  group.question = "What does it cost to bring the tip of a chain to its target?";
  group.about = fmt::format(
      "A built-in chain of {} bones and 1 m, and {} targets 0.3 to 0.9 m away in all directions, each from the same "
      "bent "
      "pose. The error is the mean distance from tip to target.",
      kBones, kTargets);
  group.error_name = "mean distance that is left";
  group.error_unit = "mm";
  group.rounding = 1e-4;
  group.item = "target";
  const auto reaching = std::make_shared<Reaching>();
  for (const StudiedSolver& solver : kStudiedSolvers)
    for (const std::uint32_t iterations : kIterations)
      add_goal(study, reaching,
               {.joints = {}, .effectors = {}, .solver = solver.solver, .iterations = iterations, .tolerance = 0.0f},
               chain_point(solver.name, iterations), solver.note);
  add_goal(study, reaching,
           {.joints = {},
            .effectors = {},
            .solver = ChainSolver::ccd,
            .iterations = 4,
            .most_turn_rad = 2.0f * std::numbers::pi_v<float> / 180.0f,
            .tolerance = 0.0f},
           kBudget, "the common budget of engines, for comparison");
  study.findings = findings_of_ik;
  return study;
}

}  // namespace sinew::cost
