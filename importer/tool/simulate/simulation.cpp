// SPDX-License-Identifier: MIT
#include "importer/tool/simulate/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/tool/simulate/standing_feet.h"
#include "importer/vrm_look_at.h"
#include "importer/vrm_springs.h"
#include "runtime/plan/run_plan.h"
#include "runtime/pose/exact_joint.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/procedures/constraints/node_constraints.h"
#include "runtime/procedures/springs/springs_job.h"

namespace sinew::tool {
namespace {

/// The eyes of a character, or none if it does not have to look.
/// err   a sentence for the user
tl::expected<std::optional<Eyes>, std::string> eyes_that_look(const VrmCharacter& vrm, const Skeleton& skeleton,
                                                              bool looks) {
  if (!looks) return std::nullopt;
  const std::optional<EyesSetup> setup = eyes_of(vrm);
  if (!setup) return tl::unexpected<std::string>("its VRM data do not say how it looks at things (lookAt)");
  const auto eyes = prepare_eyes(skeleton, *setup);
  if (!eyes) return tl::unexpected(fmt::format("its eyes cannot be used: {}", describe(eyes.error())));
  return *eyes;
}

Needs needs_of_local_poses() {
  Needs needs;
  needs.out.positions = needs.out.normals = needs.out.tangents = false;
  needs.out.weights = needs.out.properties = false;
  needs.in.max_layers = 1;
  return needs;
}

std::string joint_name_of(const Skeleton& skeleton, std::uint32_t joint) {
  const std::string& name = skeleton.names[joint];
  return name.empty() ? "node " + std::to_string(skeleton.node_of_joint[joint]) : name;
}

}  // namespace

struct Simulation::Parts {
  Parts(const Scene& of, std::uint32_t clip_index, Springs made, NodeConstraints sorted)
      : scene(of),
        clip(clip_index),
        plan(compile_plan(lend(of), needs_of_local_poses())),
        frame(plan),
        pose(of.skeleton.joint_count()),
        constraints(std::move(sorted)),
        springs(std::move(made)),
        state(springs.state_bytes() / 8 + 1, 0),
        scratch(springs.scratch_bytes() / 8 + 1, 0),
        tails(springs.joint_count()) {}

  void run(double time_s, double dt_s, const Vec3<double>& root, SpringEvent event) {
    sample(time_s);
    Affined world;
    for (int r = 0; r < 3; ++r) world.row[r].w = root[r];
    if (feet) {
      world.row[1].w += feet->ground().body_height(root);
      feet->run(scene.skeleton, pose.span(), world, dt_s, event == SpringEvent::reset);
    }
    if (eyes)
      run_unchecked(
          LookAtJob{&scene.skeleton, pose.span(), &*eyes, look_at - translation_of(world), 1.0f, &gaze.emplace()});
    run_unchecked(NodeConstraintsJob{&constraints, &scene.skeleton, pose.span()});
    const SpringsJob job{.springs = &springs,
                         .skeleton = &scene.skeleton,
                         .pose = pose.span(),
                         .root = world,
                         .dt_s = dt_s,
                         .state = std::as_writable_bytes(std::span(state)),
                         .scratch = std::as_writable_bytes(std::span(scratch)),
                         .event = event,
                         .tails = tails};
    run_unchecked(job);
    for (std::size_t j = 0; j < result.size(); ++j) {
      const glm::quat q = pose.span().get(joints[j]).rotation;
      const bool swings = j < tails.size();
      result[j] = {{q.x, q.y, q.z, q.w}, swings ? tails[j] : place_of(joints[j], world)};
    }
  }

  Vec3<double> place_of(std::uint32_t joint, const Affined& root) {
    return translation_of(root * exact_model_matrix(scene.skeleton, pose.span(), joint));
  }

  /// Copies the pose of the clip, which loops, or the rest pose.
  void sample(double time_s) {
    ClipLayer layer{clip, 0.0};
    if (clip != kNone) {
      const double duration_s = scene.animations[clip].duration_s;
      layer.time_s = duration_s > 0.0 ? std::fmod(time_s, duration_s) : 0.0;
    }
    FrameInput input;
    if (clip != kNone) input.layers = {&layer, 1};
    (void)run_plan(plan, input, frame);
    const PoseSpan from = frame.result().local;
    for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j) pose.span().set(j, from.get(j));
  }

  const Scene& scene;
  std::uint32_t clip;
  Plan plan;
  FrameBuffer frame;
  PoseMemory pose;
  NodeConstraints constraints;
  Springs springs;
  std::optional<Eyes> eyes;
  Vec3<double> look_at{0.0};
  std::optional<Gaze> gaze;
  std::unique_ptr<StandingFeet> feet;
  std::vector<std::uint64_t> state, scratch;
  std::vector<Vec3<double>> tails;
  std::vector<std::uint32_t> joints;  ///< those that swing, those with a constraint, eyes, legs
  std::vector<std::string> names, left_out;
  std::vector<SimulatedJoint> result;
};

tl::expected<Simulation, std::string> Simulation::make(const ImportedFile& file, std::uint32_t clip,
                                                       const std::optional<Vec3<double>>& look_at,
                                                       const std::optional<GroundProfile>& ground) {
  if (!file.vrm && !ground)
    return tl::unexpected<std::string>("it has none of VRM, VRMC_springBone and VRMC_node_constraint");
  const Skeleton& skeleton = file.scene.skeleton;
  const VrmCharacter none, &vrm = file.vrm ? *file.vrm : none;
  VrmSprings from = spring_setup_of(vrm, skeleton);
  auto springs = compile_springs(skeleton, from.setup);
  if (!springs) return tl::unexpected<std::string>("its springs cannot be used: " + springs.error().text);
  auto constraints = sort_constraints(skeleton, node_constraints_of(vrm));
  if (!constraints) return tl::unexpected<std::string>("its constraints cannot be used: " + constraints.error().text);
  const auto eyes = eyes_that_look(vrm, skeleton, look_at.has_value());
  if (!eyes) return tl::unexpected(eyes.error());
  if (from.setup.joints.empty() && constraints->ordered().empty() && !*eyes && !ground)
    return tl::unexpected<std::string>("it has no joint with a spring or constraint");
  auto parts = std::make_unique<Parts>(file.scene, clip, *std::move(springs), *std::move(constraints));
  const auto add = [&](std::uint32_t joint) {
    if (joint != kNone && std::find(parts->joints.begin(), parts->joints.end(), joint) == parts->joints.end())
      parts->joints.push_back(joint);
  };
  for (const SpringJoint& joint : from.setup.joints) parts->joints.push_back(joint.joint);
  for (const NodeConstraint& constraint : parts->constraints.ordered()) add(constraint.joint);
  if (*eyes) {
    parts->eyes = *eyes;
    parts->look_at = *look_at;
    add(parts->eyes->left.joint);
    add(parts->eyes->right.joint);
  }
  if (ground) {
    auto feet = StandingFeet::make(file, *ground);
    if (!feet) return tl::unexpected(feet.error());
    parts->feet = *std::move(feet);
    for (const std::uint32_t joint : parts->feet->joints()) add(joint);
  }
  for (const std::uint32_t joint : parts->joints) parts->names.push_back(joint_name_of(skeleton, joint));
  parts->left_out = std::move(from.left_out);
  parts->result.resize(parts->names.size());
  return Simulation(std::move(parts));
}

Simulation::Simulation(std::unique_ptr<Parts> parts) noexcept : parts_(std::move(parts)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

const std::vector<std::string>& Simulation::joints() const noexcept { return parts_->names; }
const std::vector<std::string>& Simulation::left_out() const noexcept { return parts_->left_out; }

const std::optional<Gaze>& Simulation::gaze() const noexcept { return parts_->gaze; }

std::span<const FootResult> Simulation::feet() const noexcept {
  if (!parts_->feet) return {};
  return parts_->feet->results();
}

void Simulation::reset(double time_s, const Vec3<double>& root) { parts_->run(time_s, 0.0, root, SpringEvent::reset); }

const std::vector<SimulatedJoint>& Simulation::step(double time_s, double dt_s, const Vec3<double>& root) {
  parts_->run(time_s, dt_s, root, SpringEvent::none);
  return parts_->result;
}

}  // namespace sinew::tool
