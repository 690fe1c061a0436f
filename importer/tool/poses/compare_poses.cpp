// SPDX-License-Identifier: MIT
#include "importer/tool/poses/compare_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string_view>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

constexpr double kMissing = std::numeric_limits<double>::infinity();

double length_of_difference(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::isnan(sum) ? kMissing : std::sqrt(sum);
}

double largest_entry(std::span<const double> numbers) {
  double largest = 0.0;
  for (const double n : numbers) largest = std::fmax(largest, std::fabs(n));
  return largest;
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::fabs(a[i] - b[i]);
    if (!(difference <= largest)) largest = std::isnan(difference) ? kMissing : difference;
  }
  return largest;
}

std::string clip_name(std::uint32_t clip) { return clip == kNone ? "rest pose" : fmt::format("clip {}", clip); }

}  // namespace

template <class Where>
void PoseComparison::add(double amount, double tolerance, const char* unit, const Where& where) {
  ++compared_;
  if (std::string_view(unit) == "m") largest_m_ = std::fmax(largest_m_, amount);
  if (amount <= tolerance) return;
  ++failed_;
  const auto worse = [](const Deviation& a, const Deviation& b) { return a.severity() > b.severity(); };
  Deviation deviation{{}, amount, tolerance, unit};
  const auto at = std::upper_bound(worst_.begin(), worst_.end(), deviation, worse);
  if (static_cast<std::size_t>(at - worst_.begin()) >= keep_worst_) return;
  deviation.where = where();
  worst_.insert(at, std::move(deviation));
  if (worst_.size() > keep_worst_) worst_.pop_back();
}

void PoseComparison::missing(std::string where) {
  add(kMissing, tolerance_.relative, "", [&] { return std::move(where); });
}

double PoseComparison::allowed_m(double size_m) const noexcept {
  const double size = std::fmax(size_m, tolerance_.model_size_m);
  return tolerance_.distance_m.value_or(tolerance_.relative * size) + slack_ * size;
}

void PoseComparison::compare_bits(const Pose& golden, const Pose& pose, const std::string& where) {
  for (const auto& [name, hash] : golden.bits) {
    const auto found = pose.bits.find(name);
    const double amount = found == pose.bits.end() ? kMissing : found->second == hash ? 0.0 : 1.0;
    add(amount, 0.0, "bits", [&, n = name] { return fmt::format("{}, {}", where, n); });
  }
}

void PoseComparison::compare_node(const NodeWorld& golden, const NodeWorld* pose, const std::string& where) {
  const std::span<const double> g(golden.world), p(pose ? pose->world : golden.world);
  const std::span<const double> linear = g.first(12), translation = g.subspan(12, 3);
  add(pose ? length_of_difference(translation, p.subspan(12, 3)) : kMissing, allowed_m(largest_entry(translation)), "m",
      [&] { return fmt::format("{}, node {}, translation", where, golden.node); });
  constexpr double kNoSize = 1e-6;  // a scene without vertices: a point at 1 m stands for the model
  const double lever_m = tolerance_.model_size_m > kNoSize ? tolerance_.model_size_m : 1.0;
  const double largest = largest_entry(linear);
  const double turned = largest_difference(linear, p.first(12)) / (largest > 0.0 ? largest : 1.0);
  add(pose ? turned * lever_m : kMissing, allowed_m(lever_m), "m",
      [&] { return fmt::format("{}, node {}, rotation and scale", where, golden.node); });
}

void PoseComparison::compare(std::uint32_t clip, const Pose& golden, const Pose& pose) {
  const std::string sample = fmt::format("{}, {:.9g} s", clip_name(clip), golden.time_s);
  slack_ = 1.5 * golden.non_unit;
  if (tolerance_.exact) compare_bits(golden, pose, sample);
  std::map<std::uint32_t, const NodeWorld*> nodes;
  for (const NodeWorld& node : pose.nodes) nodes[node.node] = &node;
  for (const NodeWorld& node : golden.nodes) {
    const auto found = nodes.find(node.node);
    compare_node(node, found == nodes.end() ? nullptr : found->second, sample);
  }
  std::map<std::uint32_t, const NodeWeights*> weights;
  for (const NodeWeights& node : pose.weights) weights[node.node] = &node;
  for (const NodeWeights& node : golden.weights) {
    const auto found = weights.find(node.node);
    const bool usable = found != weights.end() && found->second->weights.size() == node.weights.size();
    const double scale = std::fmax(1.0, largest_entry(node.weights));
    add(usable ? largest_difference(node.weights, found->second->weights) / scale : kMissing,
        tolerance_.weight + slack_, "", [&] { return fmt::format("{}, node {}, weights", sample, node.node); });
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, const PrimitivePose*> primitives;
  for (const PrimitivePose& p : pose.primitives) primitives[{p.node, p.primitive}] = &p;
  for (const PrimitivePose& p : golden.primitives) {
    const auto found = primitives.find({p.node, p.primitive});
    compare_primitive(p, found == primitives.end() ? nullptr : found->second, sample);
  }
}

void PoseComparison::compare_primitive(const PrimitivePose& golden, const PrimitivePose* pose,
                                       const std::string& where) {
  for (std::size_t kind = 0; kind < kVertexKinds.size(); ++kind) {
    const auto& [key, width, direction] = kVertexKinds[kind];
    const std::vector<double>& values = golden.values[kind];
    for (std::size_t i = 0; i * width < values.size(); ++i) {
      const std::span<const double> expected = std::span(values).subspan(i * width, width);
      if (std::isnan(expected[0])) continue;
      double amount = kMissing;
      if (pose && !pose->values[kind].empty()) {
        const auto at = std::lower_bound(pose->vertices.begin(), pose->vertices.end(), golden.vertices[i]);
        if (at != pose->vertices.end() && *at == golden.vertices[i]) {
          const auto row = static_cast<std::size_t>(at - pose->vertices.begin()) * width;
          amount = length_of_difference(expected, std::span(pose->values[kind]).subspan(row, width));
        }
      }
      const double allowed = direction ? tolerance_.direction + slack_ : allowed_m(largest_entry(expected));
      add(amount, allowed, direction ? "" : "m", [&, k = key] {
        return fmt::format("{}, node {}, primitive {}, vertex {}, {}", where, golden.node, golden.primitive,
                           golden.vertices[i], k);
      });
    }
  }
}

}  // namespace sinew::tool
