// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/words.h"
#include "importer/tool/length_text.h"
#include "runtime/animation/track_sample.h"
#include "runtime/clip/clip.h"
#include "runtime/clip/clip_file.h"
#include "runtime/clip/packed_keys.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew::cost {
namespace {

constexpr double kRoundingOfKeys = 1.5;  // times the rounding error that unchanged keys have
constexpr double kRates[] = {24.0, 30.0, 60.0, 120.0};
constexpr std::uint32_t kBits[] = {16, 12, 8};
constexpr double kMostKeys =
    200'000.0;  // most keys of one resampled track; long clips are resampled only at rates that stay below

/// Powers of ten in metres, rising: 0.1 mm and 1 mm, and the powers around a ten-thousandth of the model's size.
std::vector<double> budgets_m(double size_m) {
  const int hardly_seen = size_m > 0.0 ? static_cast<int>(std::lround(std::log10(1e-4 * size_m))) : -4;
  std::vector<double> budgets;
  for (int power = std::min(-4, hardly_seen - 1); power <= std::max(-3, hardly_seen + 1); ++power)
    budgets.push_back(std::pow(10.0, power));
  return budgets;
}

/// Factor from one tolerance to the next. It is small enough to lose no bit, since half a bit is a factor of 1.4.
constexpr double kStep = 1.1;

/// The largest difference of one component between two keys.
template <class V>
double range_of(const Track<V>& track) {
  double range = 0.0;
  for (int c = 0; c < static_cast<int>(sizeof(V) / sizeof(float)); ++c) {
    const auto [low, high] = std::minmax_element(track.values.begin(), track.values.end(),
                                                 [c](const V& a, const V& b) { return a[c] < b[c]; });
    range = std::max(range, static_cast<double>((*high)[c]) - static_cast<double>((*low)[c]));
  }
  return range;
}

/// The smallest tolerance, within a factor of kStep, for which the numbers fit into the bits.
template <class V>
double tolerance_for(const Track<V>& track, std::uint32_t bits) {
  if (track.key_count() < 2) return 0.0;
  const double range = range_of(track);
  for (double tolerance = std::ldexp(range, -static_cast<int>(bits) - 1); tolerance > 0.0 && tolerance <= 4.0 * range;
       tolerance *= kStep) {
    const std::optional<PackedTrack> packed = pack_keys(track, tolerance);
    if (packed && *std::max_element(packed->width.begin(), packed->width.end()) <= bits) return tolerance;
  }
  return 0.0;
}

/// The rounding steps of each joint for which no component takes more than `bits` over the range of its track. 0 keeps
/// floats: for curves, which cannot be packed, and for tracks that do not move.
/// in   bits   1 to PackedTrack::kMostBits
KeyTolerances keys_in_bits(const Animation& animation, std::uint32_t bits) {
  KeyTolerances out;
  for (const BoneAnimation& bone : animation.bones)
    out.bones.push_back(
        {tolerance_for(bone.translation, bits), tolerance_for(bone.rotation, bits), tolerance_for(bone.scale, bits)});
  return out;
}

std::vector<float> even_times(double duration_s, double fps) {
  std::vector<float> times_s;
  for (std::size_t f = 0; static_cast<double>(f) / fps < duration_s; ++f)
    times_s.push_back(static_cast<float>(static_cast<double>(f) / fps));
  const auto end = static_cast<float>(duration_s);
  if (times_s.empty() || times_s.back() < end) times_s.push_back(end);
  return times_s;
}

/// The same motion with linear keys at even times. Step tracks stay as they are, because no rate catches their jumps.
template <class V>
Track<V> resampled(const Track<V>& track, const std::vector<float>& times_s) {
  if (track.key_count() < 2 || track.interpolation == Interpolation::step) return track;
  Track<V> out{Interpolation::linear, times_s, {}};
  for (const float time_s : times_s) out.values.push_back(V(sample_track<double>(track, static_cast<double>(time_s))));
  return out;
}

Animation resampled(const Animation& animation, double fps) {
  const std::vector<float> times_s = even_times(animation.duration_s, fps);
  Animation out;
  out.name = animation.name;
  out.duration_s = animation.duration_s;
  for (const BoneAnimation& bone : animation.bones) {
    BoneAnimation& even = out.bones.emplace_back();
    even.joint = bone.joint;
    even.translation = resampled(bone.translation, times_s);
    even.rotation = resampled(bone.rotation, times_s);
    even.scale = resampled(bone.scale, times_s);
  }
  return out;
}

Animation joints_only(const Animation& animation) {
  Animation out;
  out.name = animation.name;
  out.duration_s = animation.duration_s;
  out.bones = animation.bones;
  return out;
}

bool rounds_any(const KeyTolerances& rounding) {
  return std::any_of(rounding.bones.begin(), rounding.bones.end(),
                     [](const KeyTolerances::OfBone& t) { return t.translation + t.rotation + t.scale > 0.0; });
}

double error_mm(const Subject& subject, const Clip& clip, const std::vector<double>& moments) {
  const Skeleton& skeleton = subject.scene.skeleton;
  PoseMemory memory(skeleton.joint_count());
  double largest_m = 0.0;
  for (const double time_s : moments) {
    run_unchecked(SampleClipJob{&clip, time_s, memory.span(), {}, {}});
    LocalPose found;
    for (std::size_t j = 0; j < skeleton.joint_count(); ++j) {
      const Transform local = memory.span().get(j);
      found.push_back({Vec3<double>(local.translation), quat_cast<double>(local.rotation), Vec3<double>(local.scale)});
    }
    const ModelPose truth = model_pose(skeleton, true_local_pose(skeleton, *subject.animation(), time_s));
    largest_m = std::max(largest_m, subject.probe.distance_m(model_pose(skeleton, found), truth));
  }
  return 1e3 * largest_m;
}

void add_stored(Study& study, const Subject& subject, const std::string& name, Clip clip, const std::string& note,
                const std::vector<double>& moments) {
  struct Play {
    Clip clip;
    PoseMemory memory;
    std::vector<double> times_s;
  };
  const double duration_s = subject.animation()->duration_s;
  const auto play = std::make_shared<Play>(
      Play{std::move(clip), PoseMemory(subject.scene.skeleton.joint_count()), timed_moments(duration_s)});
  const std::size_t joints = subject.animation()->bones.size();
  Point point;
  point.name = name;
  point.note = note;
  point.error = error_mm(subject, play->clip, moments);
  const auto bytes = static_cast<double>(saved_bytes(play->clip));
  point.size = bytes / (static_cast<double>(joints) * std::max(1e-3, duration_s));
  point.values = {{"saved", bytes / 1024.0, "KiB"},
                  {"in memory", static_cast<double>(play->clip.byte_size()) / 1024.0, "KiB"}};
  study.add(std::move(point), {joints * play->times_s.size(), [play] {
                                 for (const double time_s : play->times_s)
                                   run_unchecked(SampleClipJob{&play->clip, time_s, play->memory.span(), {}, {}});
                               }});
}

std::vector<std::string> findings_of_storage(const Group& group, double hardly_seen_mm) {
  const Point& whole = default_of(group);
  std::vector<std::string> out{
      fmt::format("The keys as they are take {} {}; sampling them takes {} and is within {} of the truth.",
                  number(*whole.size), group.size_unit, time_of(group, whole), error_of(group, whole))};
  for (const char* name : {"30 Hz", "60 Hz"})
    if (const Point* even = find(group, name))
      out.push_back(fmt::format("Resampled at {} they take {} times the size and are off by up to {}; sampling {}.",
                                even->name, number(*even->size / *whole.size), error_of(group, *even),
                                time_beside(group, *even, whole)));
  const Point* best = cheapest_within(group, hardly_seen_mm);
  const std::string limit = fmt::format("{}, a ten-thousandth of the model's size", length(hardly_seen_mm));
  if (best == &whole)
    out.push_back(fmt::format("Keep the keys as they are: nothing smaller stays within {}.", limit));
  else if (best != nullptr)
    out.push_back(sentence(fmt::format(
        "{} is the smallest that stays within {}: {} times the size, off by up to {}; sampling {}.", best->name, limit,
        number(*best->size / *whole.size), error_of(group, *best), time_beside(group, *best, whole))));
  return out;
}

}  // namespace

Study study_storage(const Subject& subject) {
  Study study;
  Group& group = study.group;
  group.name = "storage";
  group.title = "Key storage";
  group.question = "How should the keys of this clip be kept?";
  group.error_name = "largest error at the skin";
  group.error_unit = "mm";
  group.item = "joint";
  group.size_unit = "saved bytes a joint and second";
  if (subject.animation() == nullptr) return left_out(std::move(study), "the file has no clips");
  if (subject.animation()->bones.empty())
    return left_out(std::move(study), fmt::format("{} moves no joints", subject.clip_name()));
  const std::vector<double> moments = times_of_large_errors(*subject.animation(), subject.effort.key_intervals);
  group.about = fmt::format(
      "The {} animated joints of {}, compiled and sampled by the runtime. The error is the largest distance that {} "
      "move against "
      "the file's own keys in double precision.",
      subject.animation()->bones.size(), subject.clip_name(), subject.probe.description());
  const Animation joints = joints_only(*subject.animation());
  const auto compiled = [&](const Animation& animation, const KeyTolerances& rounding = {}) {
    return compile_clip(animation, subject.scene.skeleton, {}, {}, {}, rounding);
  };
  add_stored(study, subject, "keys as they are", compiled(joints), "full floats at the file's own times", moments);
  group.points.back().is_default = true;
  for (const std::uint32_t bits : kBits)
    if (const KeyTolerances rounding = keys_in_bits(joints, bits); rounds_any(rounding))
      add_stored(study, subject, fmt::format("{} bits", bits), compiled(joints, rounding),
                 fmt::format("every key, at most {} bits a component over its track's range", bits), moments);
  const VirtualVertices vertices = virtual_vertices(subject.scene);
  for (const double budget_m : budgets_m(subject.size_m))
    add_stored(study, subject, "budget " + tool::length_text(budget_m),
               compile_clip_within(subject.scene, joints, vertices, budget_m).clip,
               "fewer keys, in fewer bits: every vertex stays within it (sinew compile --budget)", moments);
  for (const double fps : kRates)
    if (fps * subject.animation()->duration_s < kMostKeys)
      add_stored(study, subject, fmt::format("{} Hz", fps), compiled(resampled(joints, fps)),
                 "full floats at even times, linear between them", moments);
  group.rounding = kRoundingOfKeys * default_of(group).error;
  study.findings = [limit = subject.hardly_seen_mm()](const Group& g) { return findings_of_storage(g, limit); };
  return study;
}

}  // namespace sinew::cost
