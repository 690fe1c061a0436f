// SPDX-License-Identifier: MIT
#include "runtime/compress/clip_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "runtime/animation/track_sample.h"
#include "runtime/compress/pose_errors.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew {
namespace {

/// Times between keys, as fractions of the interval. Two cubics differ by roughly a parabola, whose top is within 1/12
/// of one of these times: at most 3 percent above the value there.
constexpr double kBetween[] = {1.0 / 6, 2.0 / 6, 3.0 / 6, 4.0 / 6, 5.0 / 6};

/// Calls `visit(track)` for each joint and weight track.
template <class Visit>
void each_track(const Animation& truth, const Visit& visit) {
  for (const BoneAnimation& bone : truth.bones) {
    visit(bone.translation);
    visit(bone.rotation);
    visit(bone.scale);
  }
  for (const WeightAnimation& animated : truth.weights) visit(animated.weights);
}

void sort_unique(std::vector<float>& times) {
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

/// Times at which a track jumps: keys of stepped tracks, and keys that share a time.
std::vector<float> jump_times(const Animation& truth) {
  std::vector<float> times;
  each_track(truth, [&](const auto& track) {
    for (std::size_t k = 1; k < track.times_s.size(); ++k)
      if (track.interpolation == Interpolation::step || track.times_s[k] == track.times_s[k - 1])
        times.push_back(track.times_s[k]);
  });
  sort_unique(times);
  return times;
}

/// Measures poses of clips, or of keys in authoring form, a block of times at once.
class Meter {
 public:
  explicit Meter(const TruthSamples& truth)
      : truth_(truth),
        skeleton_(truth.scene().skeleton),
        joint_count_(skeleton_.joint_count()),
        memories_(PoseBlock::kPoses, PoseMemory(joint_count_)),
        poses_(joint_count_),
        models_(joint_count_ * PoseErrorsJob::kModelNumbers),
        largest_squared_(joint_count_, 0.0),
        weights_(truth.truth().weights.empty() ? 0 : truth.scene().weight_count()),
        rest_weights_(weights_.empty() ? std::vector<float>{} : rest_weights_of(truth.scene())),
        displaced_m_(weights_.empty() ? 0 : truth.scene().instances.size()) {
    error_.of_joint_m.resize(joint_count_);
  }

  /// Measures all forms at `count` times from `first` on, at most PoseBlock::kPoses.
  void look_at(std::size_t first, std::size_t count, std::span<const Clip* const> forms) {
    gather_truth(first, count);
    samples_.resize(forms.size());
    for (std::size_t f = 0; f < forms.size(); ++f) {
      make_room(samples_[f], count);
      for (std::size_t i = 0; i < count; ++i) sample_clip(*forms[f], truth_.times_s()[first + i], i, f);
      for (std::size_t j = 0; j < joint_count_; ++j)
        for (std::size_t i = 0; i < count; ++i) poses_.set(i, j, in_double(memories_[i].span().get(j)));
      measure(samples_[f], count);
    }
    for (std::size_t i = 0; i < count; ++i)
      for (const BlockSample& form : samples_) compare(first + i, i, form);
  }

  /// Same, for keys. Returns true if all errors at these times are within a limit.
  bool look_at(std::size_t first, std::size_t count, const Animation& written, double limit_m) {
    gather_truth(first, count);
    samples_.resize(1);
    make_room(samples_[0], count);
    TruthCursor cursor(written, skeleton_);
    for (std::size_t i = 0; i < count; ++i) sample_keys(written, cursor, truth_.times_s()[first + i], i);
    measure(samples_[0], count);
    bool is_within = true;
    for (std::size_t i = 0; i < count; ++i) is_within &= compare(first + i, i, samples_[0]) <= limit_m;
    return is_within;
  }

  std::span<const double> times_s() const noexcept { return truth_.times_s(); }
  std::size_t joint_count() const noexcept { return joint_count_; }

  ClipError take() noexcept {
    for (std::size_t j = 0; j < joint_count_; ++j) error_.of_joint_m[j] = std::sqrt(largest_squared_[j]);
    for (const TruthSamples::Scratch& scratch : scratch_) error_.truth_poses += scratch.evaluated;
    return std::move(error_);
  }

 private:
  /// A form at the times of a block.
  struct BlockSample {
    std::vector<double> squared;  ///< [times][J] squared errors of joints
    std::vector<double> worst;    ///< [times] the largest of each time
    std::vector<double> weights;  ///< [times][W]
  };

  void gather_truth(std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      exact_[i] = &truth_.at(first + i, scratch_[i]);
      corners_[i] = exact_[i]->corners.data();
    }
  }

  void make_room(BlockSample& out, std::size_t count) const {
    out.squared.resize(PoseBlock::kPoses * joint_count_);
    out.worst.resize(count);
    out.weights.resize(PoseBlock::kPoses * weights_.size());
  }

  /// Measures the poses of the block.
  void measure(BlockSample& out, std::size_t count) {
    run_unchecked(PoseErrorsJob{.skeleton = &skeleton_,
                                .boxes = truth_.vertices().boxes,
                                .poses = &poses_,
                                .truth = std::span(corners_).first(count),
                                .models = models_,
                                .squared = out.squared,
                                .largest = largest_squared_,
                                .worst = out.worst});
  }

  std::span<double> weights_of(BlockSample& sample, std::size_t i) const {
    return std::span(sample.weights).subspan(i * weights_.size(), weights_.size());
  }

  void sample_clip(const Clip& clip, double time_s, std::size_t i, std::size_t form) {
    run_unchecked(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = memories_[i].span(), .weights = weights_});
    std::copy(weights_.begin(), weights_.end(), weights_of(samples_[form], i).begin());
  }

  void sample_keys(const Animation& written, TruthCursor& cursor, double time_s, std::size_t i) {
    locals_.resize(joint_count_);
    cursor.local_at(time_s, locals_);
    for (std::size_t j = 0; j < joint_count_; ++j) poses_.set(i, j, locals_[j]);
    const std::span<double> weights = weights_of(samples_[0], i);
    std::copy(rest_weights_.begin(), rest_weights_.end(), weights.begin());
    for (const WeightAnimation& animated : written.weights) {
      if (animated.weights.empty()) continue;
      const std::size_t first = truth_.scene().first_weight[animated.instance] + animated.first_target;
      sample_track<double>(animated.weights, time_s, weights.subspan(first, animated.weights.target_count));
    }
  }

  /// Returns the error of the pose number i of the block.
  double compare(std::size_t time, std::size_t i, const BlockSample& sample) {
    const double joints_m = std::sqrt(sample.worst[i]);
    const double weights_m =
        weights_.empty() ? 0.0 : compare_weights(*exact_[i], sample.weights.data() + i * weights_.size());
    error_.weights_m = std::max(error_.weights_m, weights_m);
    if (!(joints_m + weights_m <= error_.worst_m)) {
      error_.worst_m = joints_m + weights_m;
      error_.worst_time_s = truth_.times_s()[time];
      error_.worst_joint = first_joint_at(joints_m, sample.squared.data() + i * joint_count_);
    }
    return joints_m + weights_m;
  }

  std::uint32_t first_joint_at(double error_m, const double* squared) const {
    for (std::uint32_t j = 0; j < joint_count_ && error_m > 0.0; ++j)
      if (std::sqrt(squared[j]) == error_m) return j;
    return kNone;
  }

  double compare_weights(const TruthSample& truth, const double* weights) {
    std::fill(displaced_m_.begin(), displaced_m_.end(), 0.0);
    auto value = truth.weights.begin();
    for (const WeightAnimation& animated : truth_.truth().weights) {
      if (animated.weights.empty()) continue;
      const std::size_t first = truth_.scene().first_weight[animated.instance] + animated.first_target;
      double& sum = displaced_m_[animated.instance];
      for (std::size_t i = first; i < first + animated.weights.target_count; ++i, ++value)
        sum += std::abs(weights[i] - *value) * static_cast<double>(truth_.vertices().metres_per_weight[i]);
    }
    double worst = 0.0;
    for (std::size_t i = 0; i < displaced_m_.size(); ++i)
      if (displaced_m_[i] > 0.0) worst = std::max(worst, displaced_m_[i] * truth.stretch[i]);
    return worst;
  }

  const TruthSamples& truth_;
  const Skeleton& skeleton_;
  const std::size_t joint_count_;
  std::array<TruthSamples::Scratch, PoseBlock::kPoses> scratch_;
  std::array<const TruthSample*, PoseBlock::kPoses> exact_{};
  std::array<const BoxCorners*, PoseBlock::kPoses> corners_{};
  std::vector<PoseMemory> memories_;  // [poses of a block]
  PoseBlock poses_;
  std::vector<double> models_;
  std::vector<Transformd> locals_;
  std::vector<BlockSample> samples_;     // [forms]
  std::vector<double> largest_squared_;  // [J]
  std::vector<float> weights_, rest_weights_;
  std::vector<double> displaced_m_;  // [instances] in mesh space
  ClipError error_;
};

/// Calls `look(first, count)` for all times, block by block.
template <class Look>
void each_block(std::size_t times, const Look& look) {
  for (std::size_t first = 0; first < times; first += PoseBlock::kPoses)
    look(first, std::min(PoseBlock::kPoses, times - first));
}

}  // namespace

std::vector<float> key_times(const Animation& truth) {
  std::vector<float> times{0.0f, static_cast<float>(truth.duration_s)};
  each_track(truth, [&](const auto& track) { times.insert(times.end(), track.times_s.begin(), track.times_s.end()); });
  sort_unique(times);
  return times;
}

std::vector<double> times_to_check(const Animation& truth, std::size_t joint_count) {
  std::vector<double> times;
  const std::vector<float> keys = key_times(truth), jumps = jump_times(truth);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const double key = static_cast<double>(keys[k]);
    if (std::binary_search(jumps.begin(), jumps.end(), keys[k]))
      times.push_back(static_cast<double>(std::nextafter(keys[k], -std::numeric_limits<float>::infinity())));
    times.push_back(key);
    if (k + 1 == keys.size()) break;
    for (const double f : kBetween) times.push_back(key + f * (static_cast<double>(keys[k + 1]) - key));
  }
  std::size_t step = times.size() * joint_count / kMaxJointTimes + 1;
  if (step == 1) return times;
  while (std::gcd(step, std::size(kBetween) + 1) > 1)
    ++step;  // otherwise the stride would always hit the same places between keys
  std::vector<double> some;
  for (std::size_t i = 0; i < times.size(); i += step) some.push_back(times[i]);
  return some;
}

ClipError measure_clip(const TruthSamples& truth, std::span<const Clip* const> forms) {
  Meter meter(truth);
  each_block(truth.times_s().size(), [&](std::size_t first, std::size_t count) { meter.look_at(first, count, forms); });
  return meter.take();
}

ClipError measure_animation(const TruthSamples& truth, const Animation& written) {
  Meter meter(truth);
  each_block(truth.times_s().size(),
             [&](std::size_t first, std::size_t count) { meter.look_at(first, count, written, 0.0); });
  return meter.take();
}

struct PartMeter::State {
  Meter meter;
};

PartMeter::PartMeter(const TruthSamples& truth) : state_(new State{Meter(truth)}) {}
PartMeter::~PartMeter() = default;

bool PartMeter::is_within(const Animation& written, double begin_s, double end_s, double limit_m, std::uint64_t& work) {
  Meter& meter = state_->meter;
  const std::span<const double> times_s = meter.times_s();
  const auto first =
      static_cast<std::size_t>(std::upper_bound(times_s.begin(), times_s.end(), begin_s) - times_s.begin());
  const auto last = static_cast<std::size_t>(std::lower_bound(times_s.begin(), times_s.end(), end_s) - times_s.begin());
  // Most searches that fail do so at the first times, so that the first blocks are small.
  std::size_t count = 1;
  for (std::size_t time = first; time < last; time += count, count = std::min(2 * count, PoseBlock::kPoses)) {
    count = std::min(count, last - time);
    work += count * meter.joint_count();
    if (!meter.look_at(time, count, written, limit_m)) return false;
  }
  return true;
}

}  // namespace sinew
