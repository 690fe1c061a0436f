// SPDX-License-Identifier: MIT
#include "viewer/app/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/math/inverse.h"
#include "runtime/model/mirror_scene.h"
#include "runtime/plan/run_plan.h"

namespace sinew::viewer {
namespace {

bool any_expression(const MotionSettings& settings, const CharacterRig* rig) {
  return rig && !rig->expressions.empty() &&
         std::any_of(settings.expressions.begin(), settings.expressions.end(), [](float v) { return v != 0.0f; });
}

bool runs_procedures(const MotionSettings& settings, const CharacterRig* rig) {
  return (rig && rig->has_procedures() && settings.springs) || any_expression(settings, rig);
}

/// Root motion of a clip: the movement since the start, and the place at its time.
struct RootOfClip {
  DualQuatd world, place;
};

RootOfClip root_of_clip(const Scene& scene, const RootJoint& root, std::uint32_t clip, double time_s, double turns) {
  if (clip >= scene.animations.size()) return {};
  const Animation& animation = scene.animations[clip];
  const auto bone = std::find_if(animation.bones.begin(), animation.bones.end(),
                                 [&](const BoneAnimation& b) { return b.joint == root.joint; });
  if (bone == animation.bones.end()) return {};
  const Transform& rest = scene.skeleton.rest[root.joint];
  PlaybackStep step;
  step.duration_s = animation.duration_s;
  step.to_turns = turns;
  step.to_s = time_s;
  const DualQuatd start = root_place(*bone, rest, root.parts, 0.0);
  return {normalised(start * root_motion(*bone, rest, root.parts, step)), root_place(*bone, rest, root.parts, time_s)};
}

DualQuatd mixed(const DualQuatd& from, const DualQuatd& to, double share) {
  const RootShare shares[] = {{from, from, 1.0 - share}, {to, to, share}};
  return blend_root_motion(shares).place;
}

}  // namespace

MotionMoment moment_at(const Scene& scene, std::uint32_t clip, double played_s) {
  MotionMoment moment{.clip = clip, .time_s = played_s};
  const double duration = clip < scene.animations.size() ? scene.animations[clip].duration_s : 0.0;
  if (!(duration > 0.0) || played_s <= duration) return moment;
  moment.turns = std::floor(played_s / duration);
  moment.time_s = std::fmod(played_s, duration);
  return moment;
}

MotionShape shape_of(const MotionSettings& settings, const CharacterRig* rig) {
  MotionShape shape;
  const bool graph = rig && rig->graph;
  shape.writes_program = graph || settings.mirrored || !settings.layers.empty() ||
                         settings.root != RootPlay::as_in_clip || settings.fade_s > 0.0f ||
                         runs_procedures(settings, rig);
  if (!shape.writes_program) return shape;
  shape.mirrors = settings.mirrored || graph;
  shape.layer_count = settings.layers.size();
  for (const LayerSetting& layer : settings.layers) {
    shape.mirrors |= layer.mirrored;
    if (layer.mask != kNone && std::find(shape.masks.begin(), shape.masks.end(), layer.mask) == shape.masks.end())
      shape.masks.push_back(layer.mask);
  }
  return shape;
}

void add_motion_needs(const MotionShape& shape, const Scene& scene, const CharacterRig* rig, Needs& needs) {
  if (!shape.writes_program) return;
  PoseProgramRoom room;
  const bool graph = rig && rig->graph;
  if (graph) {
    room = rig->graph->graph.room();
    needs.in.masks = rig->graph->masks;
  }
  for (const std::uint32_t joint : shape.masks) needs.in.masks.push_back(mask_below(scene.skeleton, joint));
  if (shape.mirrors) needs.in.mirror = std::make_shared<const MirrorMap>(make_mirror_map(scene));
  room.ops = std::min(std::max(room.ops, 3u) + 3 * static_cast<std::uint32_t>(shape.layer_count) + 1,
                      static_cast<std::uint32_t>(kMostPoseOps));
  room.slots = std::max(room.slots, 1u) + 2;
  room.masks = static_cast<std::uint32_t>(needs.in.masks.size());
  room.procedures = 1;
  needs.in.program = room;
}

Motion::Motion(const Scene& scene, std::shared_ptr<const CharacterRig> rig, MotionSettings settings)
    : scene_(&scene), rig_(std::move(rig)) {
  if (rig_ && rig_->graph) graph_.emplace(rig_->graph);
  if (rig_ && rig_->springs) {
    spring_state_.resize(rig_->springs->state_bytes() / 8 + 1, 0);
    spring_scratch_.resize(rig_->springs->scratch_bytes() / 8 + 1, 0);
    springs_.springs = &*rig_->springs;
    springs_.state = std::as_writable_bytes(std::span(spring_state_)).first(rig_->springs->state_bytes());
    springs_.scratch = std::as_writable_bytes(std::span(spring_scratch_)).first(rig_->springs->scratch_bytes());
  }
  set(settings);
}

void Motion::set(const MotionSettings& settings) {
  settings_ = settings;
  shape_ = shape_of(settings_, rig_.get());
  expressions_ = settings_.expressions;
  if (rig_) expressions_.resize(rig_->expressions.size(), 0.0f);
}

double Motion::layer_time_s(const MotionMoment& moment, std::uint32_t clip) const noexcept {
  const double own = scene_->animations[clip].duration_s;
  if (!(own > 0.0)) return 0.0;
  const double main = moment.clip < scene_->animations.size() ? scene_->animations[moment.clip].duration_s : 0.0;
  if (main > 0.0) return std::clamp(moment.time_s / main, 0.0, 1.0) * own;
  return std::fmod(std::max(moment.time_s, 0.0), own);
}

std::uint8_t Motion::mask_of(const LayerSetting& layer) const noexcept {
  if (layer.mask == kNone) return PoseOp::kNoMask;
  const auto at = std::find(shape_.masks.begin(), shape_.masks.end(), layer.mask) - shape_.masks.begin();
  const std::size_t of_graph = graph_ ? graph_->graph().masks.size() : 0;
  return static_cast<std::uint8_t>(of_graph + static_cast<std::size_t>(at));
}

void Motion::write_base(const MotionMoment& moment) {
  if (graph_) {
    graph_->seek(std::max(moment.time_s, 0.0));
    for (const PoseOp& op : graph_->program()) program_.push(op);
    return;
  }
  const auto sample = [&](std::uint32_t clip, double time_s, float weight) {
    if (clip >= scene_->animations.size())
      program_.rest(weight);
    else if (settings_.mirrored)
      program_.sample_mirrored(clip, time_s, weight);
    else
      program_.sample(clip, time_s, weight);
  };
  if (moment.fade < 1.0f) {
    sample(moment.faded_clip, moment.faded_time_s, 1.0f);
    sample(moment.clip, moment.time_s, moment.fade);
    program_.overlay();
  } else {
    sample(moment.clip, moment.time_s, 1.0f);
  }
}

void Motion::write_layer(const MotionMoment& moment, const LayerSetting& layer) {
  if (layer.clip >= scene_->animations.size()) return;
  const double time_s = layer_time_s(moment, layer.clip);
  const std::uint8_t mask = mask_of(layer);
  const auto sample = [&](double at_s) {
    if (layer.mirrored)
      program_.sample_mirrored(layer.clip, at_s, layer.weight, mask);
    else
      program_.sample(layer.clip, at_s, layer.weight, mask);
  };
  sample(time_s);
  switch (layer.use) {
    case LayerUse::cover: program_.overlay(); break;
    case LayerUse::add_to_rest: program_.add_to_rest(); break;
    case LayerUse::add_to_start:
      sample(0.0);
      program_.add();
      break;
  }
}

Affine Motion::root_at(const MotionMoment& moment) {
  const RootJoint root = rig_ ? rig_->root : RootJoint();
  DualQuatd world, place;
  if (graph_) {
    if (settings_.root != RootPlay::in_place) world = graph_->world();
    place = graph_->place();
  } else {
    if (root.joint == kNone || settings_.root == RootPlay::as_in_clip) return {};
    RootOfClip of = root_of_clip(*scene_, root, moment.clip, moment.time_s, moment.turns);
    if (moment.fade < 1.0f) {
      const RootOfClip faded = root_of_clip(*scene_, root, moment.faded_clip, moment.faded_time_s, 0.0);
      of.place = mixed(faded.place, of.place, static_cast<double>(moment.fade));
    }
    for (const LayerSetting& layer : settings_.layers)
      if (layer.use == LayerUse::cover && layer.mask == kNone && layer.clip < scene_->animations.size())
        of.place = mixed(of.place, root_of_clip(*scene_, root, layer.clip, layer_time_s(moment, layer.clip), 0.0).place,
                         std::clamp(static_cast<double>(layer.weight), 0.0, 1.0));
    if (settings_.root == RootPlay::moving) world = of.world;
    place = of.place;
  }
  const Affined moved = affine_from_dual_quat(normalised(world * dual_quat_conjugate(place)));
  const auto above = inverse_of(root.parent);
  if (!above) return {};  // a parent without extent draws nothing
  return affine_cast<float>(root.parent * moved * *above);
}

void Motion::run_procedures(void* context, const ProcedurePose& pose) {
  Motion& motion = *static_cast<Motion*>(context);
  const CharacterRig& rig = *motion.rig_;
  if (!motion.expressions_.empty() && !pose.weights.empty())
    run_unchecked(ExpressionsJob{rig.expressions, motion.expressions_, pose.weights});
  if (!motion.settings_.springs) return;
  if (rig.constraints) {
    const PoseProcedure constraints = constraints_procedure(*rig.constraints);
    constraints.run(constraints.context, pose);
  }
  if (!rig.springs) return;
  const PoseProcedure springs = springs_procedure(motion.springs_);
  springs.run(springs.context, pose);
  motion.springs_.event = SpringEvent::none;
}

void Motion::write(const MotionMoment& moment, FrameInput& input) {
  program_.clear();
  write_base(moment);
  for (const LayerSetting& layer : settings_.layers) write_layer(moment, layer);
  input.root = root_at(moment);
  if (runs_procedures(settings_, rig_.get())) {
    springs_.root = affine_cast<double>(input.root);
    springs_.dt_s = moment.dt_s;
    procedure_ = {&Motion::run_procedures, this, 0};
    program_.procedure(0);
    input.program_inputs.procedures = {&procedure_, 1};
  }
  input.layers = {};
  input.program = program_.ops();
}

bool Motion::is_swinging() const noexcept {
  return has_springs() && rig_->springs && !springs_asleep(springs_.state, springs_.root);
}

}  // namespace sinew::viewer
