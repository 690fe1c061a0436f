// SPDX-License-Identifier: MIT
#include "importer/build/merge_influences.h"

#include <algorithm>
#include <cmath>

#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

struct Influence {
  std::uint32_t joint = 0;
  double weight = 0.0;
};

/// Deviation per weight caused by rounding to float. Sums within it are not normalised again, because that would change
/// the last bits of normalised weights.
constexpr double kWeightRounding = 0x1p-24;

/// Issues counted over all vertices, so that each kind is reported once.
struct IssueCounts {
  std::size_t negative = 0, zero_sum = 0, repeated = 0, unused_out_of_range = 0, off_sum = 0;
  double worst_deviation = 0.0, sum_of_deviations = 0.0;
};

constexpr std::size_t kFew = 32;

/// Sorts a list. Short lists, usually of four almost sorted entries, use insertion sort; std::stable_sort would
/// allocate.
template <class Less>
void sort_influences(std::vector<Influence>& list, Less less) {
  if (list.size() > kFew) return std::stable_sort(list.begin(), list.end(), less);
  for (std::size_t i = 1; i < list.size(); ++i) {
    const Influence moved = list[i];
    std::size_t at = i;
    for (; at > 0 && less(moved, list[at - 1]); --at) list[at] = list[at - 1];
    list[at] = moved;
  }
}

class Merger {
 public:
  Merger(std::span<const InfluenceSet> sets, std::uint32_t joint_limit, const std::string& place, IssueLog& log)
      : sets_(sets), limit_(joint_limit), place_(place), log_(log) {}

  MergedInfluences run(std::size_t vertex_count) {
    MergedInfluences out;
    out.first.reserve(vertex_count + 1);
    out.joints.reserve(4 * vertex_count);
    out.weights.reserve(4 * vertex_count);
    out.first.push_back(0);
    for (std::size_t v = 0; v < vertex_count; ++v) {
      if (!gather(v)) return {};
      clean();
      for (const auto& [joint, weight] : vertex_) {
        out.joints.push_back(static_cast<std::uint16_t>(joint));
        out.weights.push_back(static_cast<float>(weight));
      }
      out.first.push_back(static_cast<std::uint32_t>(out.joints.size()));
    }
    report();
    return out;
  }

 private:
  /// Collects the non-zero influences of vertex v. False on error.
  bool gather(std::size_t v) {
    vertex_.clear();
    sum_ = 0.0;
    for (const InfluenceSet& set : sets_)
      for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) {
        const std::uint32_t joint = set.joints[k];
        const float weight = set.weights[k];
        if (weight < 0.0f) ++counts_.negative;
        const bool counts = weight > 1e-20f;
        if (joint >= limit_ && !counts) ++counts_.unused_out_of_range;
        if (!counts) continue;
        if (joint >= limit_) {
          log_.report(Rule::joint_index, pointer(place_, "JOINTS_" + std::to_string(set.number)),
                      "vertex " + std::to_string(v) + " is moved by joint " + std::to_string(joint) +
                          " of a skin with " + std::to_string(limit_) + " joints");
          return false;
        }
        vertex_.push_back({joint, static_cast<double>(weight)});
        sum_ += static_cast<double>(weight);
      }
    return true;
  }

  void clean() {
    if (vertex_.empty()) {
      ++counts_.zero_sum;
      vertex_.push_back({0, 1.0});
      return;
    }
    const double deviation = std::abs(sum_ - 1.0);
    counts_.worst_deviation = std::max(counts_.worst_deviation, deviation);
    if (deviation > 2e-7 * static_cast<double>(vertex_.size())) {
      ++counts_.off_sum;
      counts_.sum_of_deviations += deviation;
    }
    if (vertex_.size() > kFew || repeats_a_joint()) add_up_joints();
    sort_influences(vertex_, [](const Influence& a, const Influence& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
    });
    if (deviation <= kWeightRounding * static_cast<double>(vertex_.size())) return;
    for (auto& influence : vertex_) influence.weight /= sum_;
  }

  bool repeats_a_joint() const {
    for (std::size_t i = 1; i < vertex_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (vertex_[i].joint == vertex_[k].joint) return true;
    return false;
  }

  void add_up_joints() {
    sort_influences(vertex_, [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
    std::size_t kept = 0;
    for (std::size_t i = 1; i < vertex_.size(); ++i) {
      if (vertex_[i].joint == vertex_[kept].joint) {
        vertex_[kept].weight += vertex_[i].weight;
        ++counts_.repeated;
      } else {
        vertex_[++kept] = vertex_[i];
      }
    }
    vertex_.resize(kept + 1);
  }

  void report() {
    const auto report_count = [&](std::size_t count, Rule rule, const std::string& what) {
      if (count > 0) log_.report(rule, place_, std::to_string(count) + " " + what);
    };
    report_count(
        counts_.off_sum, Rule::weights_sum,
        "vertices have weights that do not add up to 1, the worst is off by " +
            std::to_string(counts_.worst_deviation) + ", on average they are by " +
            std::to_string(counts_.sum_of_deviations / static_cast<double>(std::max<std::size_t>(counts_.off_sum, 1))) +
            "; divided by their sum");
    report_count(counts_.zero_sum, Rule::weights_zero, "vertices have no weight at all; joint slot 0 moves them");
    report_count(counts_.negative, Rule::weights_negative, "weights are negative; taken as zero");
    report_count(counts_.repeated, Rule::joint_repeated, "weights repeat a joint of their vertex; added up");
    report_count(counts_.unused_out_of_range, Rule::joint_index_unused,
                 "joint indices without weight are out of range; ignored");
  }

  std::span<const InfluenceSet> sets_;
  std::uint32_t limit_;
  const std::string& place_;
  IssueLog& log_;
  std::vector<Influence> vertex_;
  double sum_ = 0.0;
  IssueCounts counts_;
};

}  // namespace

MergedInfluences merge_influences(std::span<const InfluenceSet> sets, std::size_t vertex_count,
                                  std::uint32_t joint_limit, const std::string& place, IssueLog& log) {
  if (sets.empty() || vertex_count == 0) return {};
  return Merger(sets, joint_limit, place, log).run(vertex_count);
}

}  // namespace sinew
