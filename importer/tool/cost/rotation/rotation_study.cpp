// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "importer/tool/cost/rotation/rotation_lanes.h"
#include "importer/tool/cost/rotation/rotation_tracks.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew::cost {
namespace {

constexpr double kRoundingOfSlerp =
    1.5;  // times the error of exact slerp, which is rounding: errors up to it count as equal
constexpr double kFramesPerSecond = 60.0;
constexpr std::size_t kCrowdJoints = 64;  // fewest joints that are timed
constexpr std::size_t kMostFrames = 600;  // most frames of incremental play

using Sampler = std::function<void(const Clip& clip, double time_s, const PoseSpan& pose)>;

struct TurnVariant {
  const char* name;
  Interpolation interpolation;  // interpolation that the clip is compiled for
  Sampler sample;
  bool is_exact;  // how the runtime plays tracks of that interpolation
  const char* note;
};

void sample_as_compiled(const Clip& clip, double time_s, const PoseSpan& pose) {
  run_unchecked(SampleClipJob{&clip, time_s, pose, {}, {}});
}

Sampler by(ArcRule rule) {
  return [rule](const Clip& clip, double time_s, const PoseSpan& pose) { sample_rotations(clip, time_s, rule, pose); };
}

std::vector<TurnVariant> turn_variants() {
  return {
      {"step", Interpolation::step, sample_as_compiled, true, "the key before, as it is"},
      {"nlerp", Interpolation::linear, by(ArcRule::nlerp), false, "right path, uneven speed"},
      {"corrected nlerp", Interpolation::linear, by(ArcRule::corrected_nlerp), false, "nlerp at a warped time"},
      {"polynomial slerp", Interpolation::linear, by(ArcRule::polynomial_slerp), false, "slerp without sines"},
      {"exact slerp", Interpolation::linear, sample_as_compiled, true, "what the runtime plays linear tracks with"},
      {"squad", Interpolation::squad, sample_as_compiled, true,
       "a smooth curve through the keys, by squad; one joint at a time"},
      {"cubic", Interpolation::cubic_spline, sample_as_compiled, true,
       "Hermite curve through the keys; tangents from neighbouring keys where the file has none"},
  };
}

/// The largest differences between poses that differ only in rotations.
struct Difference {
  double angle_rad = 0.0, distance_m = 0.0;

  void add(const Subject& subject, const LocalPose& truth, const ModelPose& true_model, const LocalPose& found) {
    for (std::size_t j = 0; j < truth.size(); ++j)
      angle_rad =
          std::max(angle_rad, rotation_angle_between(normalised(found[j].rotation), normalised(truth[j].rotation)));
    distance_m = std::max(distance_m, subject.probe.distance_m(model_pose(subject.scene.skeleton, found), true_model));
  }
};

/// The true pose at every time at which variants are compared.
struct Truth {
  std::vector<double> times_s;
  std::vector<LocalPose> local;
  std::vector<ModelPose> model;

  Truth(const Subject& subject, std::vector<double> moments) : times_s(std::move(moments)) {
    for (const double time_s : times_s) {
      local.push_back(true_local_pose(subject.scene.skeleton, *subject.animation(), time_s));
      model.push_back(model_pose(subject.scene.skeleton, local.back()));
    }
  }
};

Difference difference_of(const Subject& subject, const Truth& truth, const Animation& turned,
                         const TurnVariant& variant) {
  const Clip clip = compile_clip(turned, subject.scene.skeleton, {}, {}, {});
  PoseMemory memory(subject.scene.skeleton.joint_count());
  Difference difference;
  for (std::size_t i = 0; i < truth.times_s.size(); ++i) {
    variant.sample(clip, truth.times_s[i], memory.span());
    LocalPose found = truth.local[i];
    for (const BoneAnimation& bone : turned.bones)
      found[bone.joint].rotation = quat_cast<double>(memory.span().get(bone.joint).rotation);
    difference.add(subject, truth.local[i], truth.model[i], found);
  }
  return difference;
}

std::size_t copies_of(const Animation& turned) {
  return (kCrowdJoints + turned.bones.size() - 1) / turned.bones.size();
}

Work timed(const Subject& subject, const Animation& turned, const TurnVariant& variant) {
  struct Play {
    Clip clip;
    PoseMemory memory;
    std::vector<double> times_s;
    Sampler sample;
  };
  const Crowd crowd = crowd_of(subject.scene.skeleton, turned, copies_of(turned));
  const auto play = std::make_shared<Play>(Play{compile_clip(crowd.animation, crowd.skeleton, {}, {}, {}),
                                                PoseMemory(crowd.skeleton.joint_count()),
                                                timed_moments(turned.duration_s), variant.sample});
  return {crowd.animation.bones.size() * play->times_s.size(), [play] {
            for (const double time_s : play->times_s) play->sample(play->clip, time_s, play->memory.span());
          }};
}

Point point_of(const char* name, const Difference& difference, const char* note) {
  Point point;
  point.name = name;
  point.error = 1e3 * difference.distance_m;
  point.values = {{"angle", difference.angle_rad, "rad"}};
  point.note = note;
  return point;
}

/// Incremental slerp cannot seek, so it is played track by track instead of being sampled.
void add_incremental(Study& study, const Subject& subject, const Animation& turned) {
  const auto count = static_cast<std::size_t>(std::max(1.0, turned.duration_s * kFramesPerSecond));
  const std::size_t frame_count = std::min(count, kMostFrames);
  std::vector<std::vector<glm::quat>> played(turned.bones.size(), std::vector<glm::quat>(frame_count));
  for (std::size_t b = 0; b < played.size(); ++b) walk_track(turned.bones[b].rotation, kFramesPerSecond, played[b]);
  Difference difference;
  const std::size_t stride = std::max<std::size_t>(1, frame_count / (2 * subject.effort.key_intervals));
  for (std::size_t f = 0; f < frame_count; f += stride) {
    const Truth truth(subject, {static_cast<double>(f) / kFramesPerSecond});
    LocalPose found = truth.local[0];
    for (std::size_t b = 0; b < played.size(); ++b)
      found[turned.bones[b].joint].rotation = quat_cast<double>(played[b][f]);
    difference.add(subject, truth.local[0], truth.model[0], found);
  }
  struct Play {
    Animation animation;
    std::vector<glm::quat> frames;
  };
  const auto play = std::make_shared<Play>(Play{turned, std::vector<glm::quat>(frame_count)});
  study.add(point_of("incremental slerp", difference, "60 frames a second in a row, one joint at a time; no seeking"),
            {turned.bones.size() * frame_count, [play] {
               for (const BoneAnimation& bone : play->animation.bones)
                 walk_track(bone.rotation, kFramesPerSecond, play->frames);
             }});
}

/// The interpolation of most tracks of the file.
Interpolation usual_interpolation(const Animation& animation) {
  std::map<Interpolation, std::size_t> tracks;
  for (const BoneAnimation& bone : animation.bones)
    if (is_between_keys(bone.rotation)) ++tracks[bone.rotation.interpolation];
  return std::max_element(tracks.begin(), tracks.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

std::vector<std::string> findings_of_rotations(const Group& group, double hardly_seen_mm) {
  const Point& standard = default_of(group);
  constexpr double kDegrees = 57.29577951308232;
  std::vector<std::string> out{sentence(
      fmt::format("{}, what the file asks for and sinew plays, takes {} and stays within {} of the truth at the skin.",
                  standard.name, time_of(group, standard), error_of(group, standard)))};
  for (const char* name : {"nlerp", "corrected nlerp"})
    if (const Point* other = find(group, name))
      out.push_back(sentence(fmt::format("{} loses up to {} at the skin ({} degrees at a joint) and {}.", other->name,
                                         error_of(group, *other), number(kDegrees * other->values[0].value),
                                         time_beside(group, *other, standard))));
  const Point* best = cheapest_within(group, hardly_seen_mm);
  const std::string limit = fmt::format("{}, a ten-thousandth of the model's size", length(hardly_seen_mm));
  if (best == &standard)
    out.push_back(fmt::format("Use {}: nothing clearly cheaper stays within {}.", standard.name, limit));
  else if (best != nullptr)
    out.push_back(fmt::format("{} will do for this clip: it stays within {}, and {}. Where every digit counts, use {}.",
                              sentence(best->name), limit, time_beside(group, *best, standard), standard.name));
  return out;
}

}  // namespace

Study study_rotation(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "rotation";
  group.title = "Rotation interpolation";
  group.question = "Which interpolation should I use for this clip?";
  group.error_name = "largest error at the skin";
  group.error_unit = "mm";
  group.item = "joint";
  if (subject.animation() == nullptr) return left_out(std::move(study), "the file has no clips");
  if (rotations_only(*subject.animation(), Interpolation::linear).bones.empty())
    return left_out(std::move(study), fmt::format("{} turns no joint from one key to another", subject.clip_name()));
  const Interpolation usual = usual_interpolation(*subject.animation());
  const Truth truth(subject, times_of_large_errors(*subject.animation(), subject.effort.key_intervals));
  for (const TurnVariant& variant : turn_variants()) {
    const Animation turned = rotations_only(*subject.animation(), variant.interpolation);
    if (variant.is_exact && variant.interpolation == Interpolation::linear) add_incremental(study, subject, turned);
    Point point = point_of(variant.name, difference_of(subject, truth, turned, variant), variant.note);
    point.is_default = variant.is_exact && variant.interpolation == usual;
    const bool smooth =
        variant.interpolation == Interpolation::squad || variant.interpolation == Interpolation::cubic_spline;
    point.other_aim = smooth && !point.is_default;
    study.add(std::move(point), timed(subject, turned, variant));
  }
  const std::size_t joints = rotations_only(*subject.animation(), Interpolation::linear).bones.size();
  group.about = fmt::format(
      "{} rotation tracks of {}, every variant from the same keys. The error is the largest distance that {} move "
      "against the file's own "
      "interpolation in double precision, between keys. Timed in lanes over the same compiled clip, key search "
      "included{}.",
      joints, subject.clip_name(), subject.probe.description(),
      joints < kCrowdJoints ? fmt::format(", as a crowd of {} to fill the lanes",
                                          copies_of(rotations_only(*subject.animation(), Interpolation::linear)))
                            : "");
  group.rounding = kRoundingOfSlerp * default_of(group).error;
  study.findings = [limit = subject.hardly_seen_mm()](const Group& g) { return findings_of_rotations(g, limit); };
  return study;
}

}  // namespace sinew::cost
