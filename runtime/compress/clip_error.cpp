// SPDX-License-Identifier: MIT
#include "runtime/compress/clip_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "runtime/animation/track_sample.h"
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

/// The largest squared distance between corresponding corners.
double farthest_apart_squared(const BoxCorners& a, const BoxCorners& b) noexcept {
  std::array<double, 8> squares;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double x = a[0][i] - b[0][i], y = a[1][i] - b[1][i], z = a[2][i] - b[2][i];
    squares[i] = x * x + y * y + z * z;
  }
  double largest = 0.0;
  for (const double square : squares) largest = std::max(largest, square);
  return largest;
}

class Meter {
 public:
  explicit Meter(const TruthSamples& truth)
      : truth_(truth),
        skeleton_(truth.scene().skeleton),
        memory_(skeleton_.joint_count()),
        local_(skeleton_.joint_count()),
        model_(local_.size()),
        largest_squared_(local_.size(), 0.0),
        weights_(truth.truth().weights.empty() ? 0 : truth.scene().weight_count()),
        rest_weights_(weights_.empty() ? std::vector<float>{} : rest_weights_of(truth.scene())),
        exact_weights_(weights_.size()),
        displaced_m_(weights_.empty() ? 0 : truth.scene().instances.size()) {
    error_.of_joint_m.resize(local_.size());
  }

  void look_at(std::size_t time, std::span<const Clip* const> forms) {
    const TruthSample& truth = truth_.at(time, scratch_);
    for (const Clip* clip : forms) {
      sample(*clip, truth_.times_s()[time]);
      compare(truth_.times_s()[time], truth);
    }
  }

  /// Returns the error at this time.
  double look_at(std::size_t time, const Animation& written) {
    const TruthSample& truth = truth_.at(time, scratch_);
    sample(written, truth_.times_s()[time]);
    return compare(truth_.times_s()[time], truth);
  }

  std::span<const double> times_s() const noexcept { return truth_.times_s(); }
  std::size_t joint_count() const noexcept { return local_.size(); }

  ClipError take() noexcept {
    for (std::size_t j = 0; j < local_.size(); ++j) error_.of_joint_m[j] = std::sqrt(largest_squared_[j]);
    error_.truth_poses = scratch_.evaluated;
    return std::move(error_);
  }

 private:
  struct Worst {
    std::uint32_t joint = kNone;
    double error_m = 0.0;
  };

  void sample(const Clip& clip, double time_s) {
    run_unchecked(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = memory_.span(), .weights = weights_});
    for (std::size_t j = 0; j < local_.size(); ++j) local_[j] = in_double(memory_.span().get(j));
    std::copy(weights_.begin(), weights_.end(), exact_weights_.begin());
    model_from_local(skeleton_, local_, model_);
  }

  void sample(const Animation& written, double time_s) {
    evaluate_truth(written, skeleton_, time_s, pose_);
    model_.swap(pose_.model);
    std::copy(rest_weights_.begin(), rest_weights_.end(), exact_weights_.begin());
    for (const WeightAnimation& animated : written.weights) {
      if (animated.weights.empty()) continue;
      const std::size_t first = truth_.scene().first_weight[animated.instance] + animated.first_target;
      sample_track<double>(animated.weights, time_s,
                           std::span(exact_weights_).subspan(first, animated.weights.target_count));
    }
  }

  double compare(double time_s, const TruthSample& truth) {
    const auto [joint, joints_m] = compare_joints(truth);
    const double weights_m = weights_.empty() ? 0.0 : compare_weights(truth);
    error_.weights_m = std::max(error_.weights_m, weights_m);
    if (!(joints_m + weights_m <= error_.worst_m)) {
      error_.worst_m = joints_m + weights_m;
      error_.worst_time_s = time_s;
      error_.worst_joint = joint;
    }
    return joints_m + weights_m;
  }

  Worst compare_joints(const TruthSample& truth) {
    Worst worst;
    double worst_squared = 0.0;
    for (std::uint32_t j = 0; j < local_.size(); ++j) {
      const double squared =
          farthest_apart_squared(corners_in_model(model_[j], truth_.vertices().boxes[j]), truth.corners[j]);
      largest_squared_[j] = std::max(largest_squared_[j], squared);
      if (!(squared > worst_squared)) continue;
      worst_squared = squared;
      if (const double error_m = std::sqrt(squared); error_m > worst.error_m) worst = {j, error_m};
    }
    return worst;
  }

  double compare_weights(const TruthSample& truth) {
    std::fill(displaced_m_.begin(), displaced_m_.end(), 0.0);
    auto value = truth.weights.begin();
    for (const WeightAnimation& animated : truth_.truth().weights) {
      if (animated.weights.empty()) continue;
      const std::size_t first = truth_.scene().first_weight[animated.instance] + animated.first_target;
      double& sum = displaced_m_[animated.instance];
      for (std::size_t i = first; i < first + animated.weights.target_count; ++i, ++value)
        sum += std::abs(exact_weights_[i] - *value) * static_cast<double>(truth_.vertices().metres_per_weight[i]);
    }
    double worst = 0.0;
    for (std::size_t i = 0; i < displaced_m_.size(); ++i)
      if (displaced_m_[i] > 0.0) worst = std::max(worst, displaced_m_[i] * truth.stretch[i]);
    return worst;
  }

  const TruthSamples& truth_;
  const Skeleton& skeleton_;
  TruthSamples::Scratch scratch_;
  PoseMemory memory_;
  std::vector<Transformd> local_;
  std::vector<Affined> model_;
  std::vector<double> largest_squared_;  // [J]
  TruthPose pose_;
  std::vector<float> weights_, rest_weights_;
  std::vector<double> exact_weights_;
  std::vector<double> displaced_m_;  // [instances] in mesh space
  ClipError error_;
};

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
  for (std::size_t i = 0; i < truth.times_s().size(); ++i) meter.look_at(i, forms);
  return meter.take();
}

ClipError measure_animation(const TruthSamples& truth, const Animation& written) {
  Meter meter(truth);
  for (std::size_t i = 0; i < truth.times_s().size(); ++i) meter.look_at(i, written);
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
  const auto first = std::upper_bound(times_s.begin(), times_s.end(), begin_s) - times_s.begin();
  const auto last = std::lower_bound(times_s.begin(), times_s.end(), end_s) - times_s.begin();
  for (auto time = first; time < last; ++time) {
    work += meter.joint_count();
    if (!(meter.look_at(static_cast<std::size_t>(time), written) <= limit_m)) return false;
  }
  return true;
}

}  // namespace sinew
