// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/decompose.h"
#include "runtime/math/interpolate.h"
#include "runtime/math/inverse.h"
#include "runtime/model/scene.h"
#include "runtime/pose_program/run_pose_program.h"
#include "tests/reference/mirror_rows.h"
#include "tests/reference/sampling.h"
#include "tests/reference/transitions.h"

namespace sinew::reference {

/// A pose with its numbers, in double precision.
struct SlowPose {
  std::vector<Transformd> joints;
  std::vector<double> weights, properties;
};

/// The tables that a program indexes.
struct SlowTables {
  std::vector<PoseMask> masks;  ///< those of the assets, then those of the caller
  std::vector<SlowPose> externals;
  std::span<const JointOverrides> overrides;
  std::vector<std::function<void(SlowPose& pose, double share)>> procedures;
  const MirrorMap* mirror = nullptr;
  Affine root = {};
};

/// Runs a program by the equations of its operations, from the authoring form: the truth for run(PoseProgramJob).
class SlowProgram {
 public:
  SlowProgram(const Scene& scene, std::span<const float> rest_weights, SlowTables tables)
      : scene_(scene), tables_(std::move(tables)) {
    for (const Transform& t : scene.skeleton.rest) rest_.joints.push_back(in_double(t));
    rest_.weights.assign(rest_weights.begin(), rest_weights.end());
    rest_.properties.assign(scene.properties.rest.begin(), scene.properties.rest.end());
  }

  SlowPose run(PoseProgramSpan program) {
    stack_.clear();
    for (const PoseOp& op : program) {
      SlowPose made = apply(op);
      stack_.push_back({std::move(made), double(op.weight), op.mask});
    }
    return stack_.back().pose;
  }

 private:
  struct Entry {
    SlowPose pose;
    double weight;
    std::uint8_t mask;
  };

  SlowPose apply(const PoseOp& op) {
    switch (op.kind) {
      case PoseOpKind::sample: return sampled(op.index, op.time_s);
      case PoseOpKind::sample_mirrored: return mirrored(sampled(op.index, op.time_s));
      case PoseOpKind::rest_mirrored: return mirrored(rest_);
      case PoseOpKind::external: return tables_.externals[op.index];
      case PoseOpKind::mean: return mean(op.index, op.time_s);
      case PoseOpKind::overlay: return overlaid(false);
      case PoseOpKind::overlay_model: return overlaid(true);
      case PoseOpKind::add_to_rest: {
        const Entry layer = popped();
        return added(popped().pose, layer, rest_, op.index == 1);
      }
      case PoseOpKind::add: {
        const SlowPose reference = popped().pose;
        const Entry layer = popped();
        return added(popped().pose, layer, reference, op.index == 1);
      }
      case PoseOpKind::cached: return popped().pose;
      case PoseOpKind::inertialize:
        return in_transition<4>([&](const auto& now, const auto& start) {
          return inertialized(now, start[0], start[1], start[2], start[3], op.time_s, double(op.index));
        });
      case PoseOpKind::dead_blend:
        return in_transition<2>([&](const auto& now, const auto& start) {
          return dead_blended(now, start[0], start[1], op.time_s, double(op.index));
        });
      case PoseOpKind::override_joints: return overridden(popped().pose, tables_.overrides[op.index].joints, op.time_s);
      case PoseOpKind::procedure: {
        SlowPose pose = popped().pose;
        if (op.time_s > 0.0) tables_.procedures[op.index](pose, op.time_s);
        return pose;
      }
      default: return rest_;
    }
  }

  Entry popped() {
    Entry top = std::move(stack_.back());
    stack_.pop_back();
    return top;
  }

  using MaskPart = std::span<const float> PoseMask::*;

  double share(const Entry& entry, std::size_t i, MaskPart part = &PoseMask::joints) const {
    if (entry.mask == PoseOp::kNoMask || (tables_.masks[entry.mask].*part).empty()) return entry.weight;
    return entry.weight * double((tables_.masks[entry.mask].*part)[i]);
  }

  /// Properties have no sides: a mirrored sample keeps them.
  SlowPose mirrored(const SlowPose& pose) const {
    SlowPose out = pose;
    for (std::size_t j = 0; j < pose.joints.size(); ++j) {
      const MirroredJoint& joint = tables_.mirror->joints[j];
      out.joints[j] = mirrored_plainly(joint, pose.joints[joint.source]);
    }
    for (std::size_t w = 0; w < tables_.mirror->weight_source.size(); ++w)
      out.weights[w] = pose.weights[tables_.mirror->weight_source[w]];
    return out;
  }

  SlowPose sampled(std::size_t clip, double time_s) const {
    SlowPose pose = rest_;
    const Animation& animation = scene_.animations[clip];
    for (const BoneAnimation& bone : animation.bones)
      pose.joints[bone.joint] = bone.interpolate<double>(time_s, rest_.joints[bone.joint]);
    for (const WeightAnimation& animated : animation.weights)
      set_numbers(sample(animated.weights, time_s), scene_.first_weight[animated.instance] + animated.first_target,
                  pose.weights);
    for (const PropertyTrack& track : animation.properties)
      for (const PropertyTable::Entry& entry : scene_.properties.entries)
        if (entry.target == track.target) set_numbers(sample(track.values, time_s), entry.first, pose.properties);
    return pose;
  }

  static void set_numbers(const Numbers& from, std::size_t first, std::vector<double>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[first + i] = double(from[i]);
  }

  /// eq   (sum w x + r rest) / (sum w + r), r = max(0, threshold - sum w)
  SlowPose mean(std::size_t count, double threshold) {
    std::vector<Entry> operands(count);
    for (std::size_t i = count; i-- > 0;) operands[i] = popped();
    SlowPose out = rest_;
    for (std::size_t j = 0; j < out.joints.size(); ++j) {
      double total = 0.0;
      for (const Entry& entry : operands) total += share(entry, j);
      const double fill = std::max(0.0, threshold - total);
      const Transformd& rest = rest_.joints[j];
      Transformd sum{rest.translation * fill, rest.rotation * fill, rest.scale * fill};
      for (const Entry& entry : operands) {
        const double w = share(entry, j);
        const Transformd& x = entry.pose.joints[j];
        sum.translation += x.translation * w;
        sum.rotation = sum.rotation + aligned_with(rest.rotation, x.rotation) * w;
        sum.scale += x.scale * w;
      }
      const double by = 1.0 / (total + fill);
      out.joints[j] = {sum.translation * by, normalised(sum.rotation), sum.scale * by};
    }
    const auto numbers = [&](auto member, MaskPart part) {
      for (std::size_t i = 0; i < (out.*member).size(); ++i) {
        double total = 0.0, sum = 0.0;
        for (const Entry& entry : operands) {
          total += share(entry, i, part);
          sum += share(entry, i, part) * (entry.pose.*member)[i];
        }
        const double fill = std::max(0.0, threshold - total);
        (out.*member)[i] = (sum + fill * (rest_.*member)[i]) / (total + fill);
      }
    };
    numbers(&SlowPose::weights, &PoseMask::weights);
    numbers(&SlowPose::properties, &PoseMask::properties);
    return out;
  }

  SlowPose overlaid(bool in_model_space) {
    const Entry above = popped();
    SlowPose out = popped().pose;
    std::vector<Quat<double>> below_model, above_model, model;
    for (std::size_t j = 0; j < out.joints.size(); ++j) {
      const double w = std::min(1.0, share(above, j));
      const Transformd a = out.joints[j], b = above.pose.joints[j];
      out.joints[j] = {a.translation * (1.0 - w) + b.translation * w,
                       normalised(a.rotation * (1.0 - w) + aligned_with(a.rotation, b.rotation) * w),
                       a.scale * (1.0 - w) + b.scale * w};
      if (!in_model_space) continue;
      const std::uint32_t parent = scene_.skeleton.parents[j];
      const bool is_root = parent == kNone;
      below_model.push_back(is_root ? a.rotation : below_model[parent] * a.rotation);
      above_model.push_back(is_root ? b.rotation : above_model[parent] * b.rotation);
      if (w > 0.0) {
        model.push_back(slerp_short_arc(below_model[j], above_model[j], w));
        out.joints[j].rotation = is_root ? model[j] : quat_conjugate(model[parent]) * model[j];
      } else {
        out.joints[j].rotation = a.rotation;
        model.push_back(is_root ? a.rotation : model[parent] * a.rotation);
      }
    }
    const auto numbers = [&](auto member, MaskPart part) {
      for (std::size_t i = 0; i < (out.*member).size(); ++i) {
        const double w = std::min(1.0, share(above, i, part));
        (out.*member)[i] = (out.*member)[i] * (1.0 - w) + (above.pose.*member)[i] * w;
      }
    };
    numbers(&SlowPose::weights, &PoseMask::weights);
    numbers(&SlowPose::properties, &PoseMask::properties);
    return out;
  }

  SlowPose added(SlowPose base, const Entry& layer, const SlowPose& reference, bool in_joint_frame) const {
    const Quat<double> one = quat_identity<double>();
    for (std::size_t j = 0; j < base.joints.size(); ++j) {
      const double w = share(layer, j), size = std::fabs(w);
      const Transformd &l = layer.pose.joints[j], &r = reference.joints[j];
      Transformd& x = base.joints[j];
      x.translation += (l.translation - r.translation) * w;
      const Quat<double> back = quat_conjugate(r.rotation);
      const Quat<double> d = aligned_with(one, in_joint_frame ? back * l.rotation : l.rotation * back);
      const Quat<double> added = one * (1.0 - size) + d * size, part = w < 0.0 ? quat_conjugate(added) : added;
      x.rotation = normalised(in_joint_frame ? x.rotation * part : part * x.rotation);
      for (int c = 0; c < 3; ++c) {
        const double factor = 1.0 + size * ((r.scale[c] == 0.0 ? 1.0 : l.scale[c] / r.scale[c]) - 1.0);
        if (w >= 0.0)
          x.scale[c] *= factor;
        else if (factor != 0.0)
          x.scale[c] /= factor;
      }
    }
    for (std::size_t i = 0; i < base.weights.size(); ++i)
      base.weights[i] += share(layer, i, &PoseMask::weights) * (layer.pose.weights[i] - reference.weights[i]);
    return base;
  }

  SlowPose overridden(SlowPose pose, std::span<const JointOverride> joints, double share) const {
    for (const JointOverride& given : joints) {
      Transformd to = in_double(given.transform);
      if (given.space != OverrideSpace::local) {
        std::vector<Affined> model(pose.joints.size());
        model_from_local(scene_.skeleton, pose.joints, model);
        const std::uint32_t parent = scene_.skeleton.parents[given.joint];
        Affined above = parent == kNone ? Affined{} : model[parent];
        if (given.space == OverrideSpace::world) above = affine_cast<double>(tables_.root) * above;
        const auto back = inverse_of(above);
        if (!back) continue;
        to = decompose_trs(*back * affine_from_transform(to)).transform;
      }
      Transformd& x = pose.joints[given.joint];
      x = {x.translation * (1.0 - share) + to.translation * share,
           normalised(x.rotation * (1.0 - share) + aligned_with(x.rotation, to.rotation) * share),
           x.scale * (1.0 - share) + to.scale * share};
    }
    return pose;
  }

  /// Calls `mix(now, start)` for each joint and number; `start` has those of the other operands.
  template <std::size_t kOthers, class Mix>
  SlowPose in_transition(const Mix& mix) {
    std::array<SlowPose, kOthers> others;
    for (std::size_t o = kOthers; o-- > 0;) others[o] = popped().pose;
    SlowPose now = popped().pose;
    const auto mix_all = [&](auto member) {
      auto& list = now.*member;
      for (std::size_t i = 0; i < list.size(); ++i) {
        std::array<std::decay_t<decltype(list[i])>, kOthers> start;
        for (std::size_t o = 0; o < kOthers; ++o) start[o] = (others[o].*member)[i];
        list[i] = mix(list[i], start);
      }
    };
    mix_all(&SlowPose::joints);
    mix_all(&SlowPose::weights);
    mix_all(&SlowPose::properties);
    return now;
  }

  const Scene& scene_;
  SlowTables tables_;
  SlowPose rest_;
  std::vector<Entry> stack_;
};

}  // namespace sinew::reference
