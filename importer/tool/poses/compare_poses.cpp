// SPDX-License-Identifier: MIT
#include "importer/tool/poses/compare_poses.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
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

std::string with_name(std::string text, std::uint32_t index, const std::vector<std::string>& names) {
  if (index < names.size() && !names[index].empty()) text += " " + names[index];
  return text;
}

double in_degrees(double chord) {
  return chord > 2.0 ? (std::isinf(chord) ? chord : 180.0) : 2.0 * std::asin(chord / 2.0) * 180.0 / std::numbers::pi;
}

/// Limit for report_renumbered: at most this many golden vertices are searched for among the vertices of a primitive.
/// If it has more, they are sampled evenly, because each search visits all vertices.
constexpr std::size_t kLookedFor = 256;

}  // namespace

bool Deviation::is_worse_than(const Deviation& other) const noexcept {
  const double own = amount / tolerance, others = other.amount / other.tolerance;
  if (std::isinf(amount) != std::isinf(other.amount)) return std::isinf(amount);
  return own > others || (!(own < others) && amount > other.amount);
}

template <class Where>
void PoseComparison::add(const Kind& kind, double amount, double tolerance, const char* unit, const Where& where) {
  ++compared_;
  if (std::string_view(unit) == "m") largest_m_ = std::fmax(largest_m_, amount);
  ratio_ = std::fmax(ratio_, tolerance > 0.0 ? amount / tolerance : amount > 0.0 ? kMissing : 0.0);
  if (amount <= tolerance) return;
  ++failed_;
  Deviation deviation{{}, amount, tolerance, unit, 0, kind.name, clip_, kind.node, time_s_};
  const auto [known, is_first] = worst_.try_emplace(kind, deviation);
  if (!is_first) deviation.more = known->second.more + 1;
  if (!is_first && deviation.amount <= known->second.amount) {
    known->second.more = deviation.more;
    return;
  }
  deviation.where = where();
  known->second = std::move(deviation);
}

std::vector<Deviation> PoseComparison::worst() const {
  std::vector<Deviation> out;
  for (const auto& [kind, deviation] : worst_) out.push_back(deviation);
  std::stable_sort(out.begin(), out.end(), [](const Deviation& a, const Deviation& b) { return a.is_worse_than(b); });
  return out;
}

std::string PoseComparison::node_text(std::uint32_t node) const {
  return with_name(fmt::format("node {}", node), node, names_.nodes);
}

std::string PoseComparison::clip_text(std::uint32_t clip) const {
  return clip == kNone ? "rest pose" : with_name(fmt::format("clip {}", clip), clip, names_.clips);
}

void PoseComparison::missing(std::string where) {
  add({"missing", static_cast<std::uint32_t>(worst_.size())}, kMissing, tolerance_.relative, "",
      [&] { return std::move(where); });
}

double PoseComparison::allowed_m(double size_m) const noexcept {
  const double size = std::fmax(size_m, tolerance_.model_size_m);
  return tolerance_.distance_m.value_or(tolerance_.relative * size) + slack_ * size;
}

void PoseComparison::compare_bits(const Pose& golden, const Pose& pose, const std::string& where) {
  for (const auto& [name, hash] : golden.bits) {
    const auto found = pose.bits.find(name);
    const double amount = found == pose.bits.end() ? kMissing : found->second == hash ? 0.0 : 1.0;
    add({"bits", kNone, static_cast<std::uint32_t>(std::distance(golden.bits.begin(), golden.bits.find(name)))}, amount,
        0.0, "bits", [&, n = name] { return fmt::format("{}, {}", where, n); });
  }
}

void PoseComparison::compare_node(const NodeWorld& golden, const NodeWorld* pose, const std::string& where) {
  const std::span<const double> g(golden.world), p(pose ? pose->world : golden.world);
  const std::span<const double> linear = g.first(12), translation = g.subspan(12, 3);
  add({"translation", golden.node}, pose ? length_of_difference(translation, p.subspan(12, 3)) : kMissing,
      allowed_m(largest_entry(translation)), "m",
      [&] { return fmt::format("{}, {}, translation", where, node_text(golden.node)); });
  constexpr double kNoSize = 1e-6;  // a scene without vertices: a point at 1 m takes the place of the model
  const double lever_m = tolerance_.model_size_m > kNoSize ? tolerance_.model_size_m : 1.0;
  const double largest = largest_entry(linear);
  const double turned = largest_difference(linear, p.first(12)) / (largest > 0.0 ? largest : 1.0);
  const auto place = [&] { return fmt::format("{}, {}, rotation and scale", where, node_text(golden.node)); };
  if (tolerance_.matrix)
    add({"matrix", golden.node}, pose ? turned : kMissing, *tolerance_.matrix + slack_, "", place);
  else
    add({"matrix", golden.node}, pose ? turned * lever_m : kMissing, allowed_m(lever_m), "m", place);
}

double PoseComparison::compare(std::uint32_t clip, const Pose& golden, const Pose& pose) {
  clip_ = clip;
  time_s_ = golden.time_s;
  ratio_ = 0.0;
  const std::string sample = fmt::format("{}, {:.9g} s", clip_text(clip), golden.time_s);
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
    add({"weights", node.node}, usable ? largest_difference(node.weights, found->second->weights) / scale : kMissing,
        tolerance_.weight + slack_, "", [&] { return fmt::format("{}, {}, weights", sample, node_text(node.node)); });
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, const PrimitivePose*> primitives;
  for (const PrimitivePose& p : pose.primitives) primitives[{p.node, p.primitive}] = &p;
  for (const PrimitivePose& p : golden.primitives) {
    const auto found = primitives.find({p.node, p.primitive});
    compare_primitive(p, found == primitives.end() ? nullptr : found->second, sample);
  }
  return ratio_;
}

void PoseComparison::compare_primitive(const PrimitivePose& golden, const PrimitivePose* pose,
                                       const std::string& where) {
  if (pose && report_renumbered(golden, *pose, where)) return;
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
      add({key, golden.node, golden.primitive}, direction ? in_degrees(amount) : amount,
          direction ? in_degrees(allowed) : allowed, direction ? "deg" : "m", [&, k = key] {
            return fmt::format("{}, {}, primitive {}, vertex {}, {}", where, node_text(golden.node), golden.primitive,
                               golden.vertices[i], k);
          });
    }
  }
}

/// Reports once that the vertices of a primitive have other numbers than in the golden pose. Then some vertices differ,
/// although each golden position is the place of some vertex.
bool PoseComparison::report_renumbered(const PrimitivePose& golden, const PrimitivePose& pose,
                                       const std::string& where) {
  if (renumbered_.contains({golden.node, golden.primitive})) return true;
  const std::vector<double>&expected = golden.of(VertexKind::positions), &found = pose.of(VertexKind::positions);
  if (expected.empty() || found.empty()) return false;
  const auto far = [&](std::size_t i, std::size_t row) {
    const std::span<const double> place = std::span(expected).subspan(3 * i, 3);
    return !(length_of_difference(place, std::span(found).subspan(3 * row, 3)) <= allowed_m(largest_entry(place)));
  };
  const auto is_moved = [&](std::size_t i) {
    const auto at = std::lower_bound(pose.vertices.begin(), pose.vertices.end(), golden.vertices[i]);
    return at == pose.vertices.end() || *at != golden.vertices[i] ||
           far(i, static_cast<std::size_t>(at - pose.vertices.begin()));
  };
  const auto is_somewhere = [&](std::size_t i) {
    for (std::size_t row = 0; row < pose.vertices.size(); ++row)
      if (!far(i, row)) return true;
    return false;
  };
  const std::size_t count = golden.vertices.size(), step = count / kLookedFor + 1;
  std::size_t moved = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (std::isnan(expected[3 * i]))
      return false;
    else
      moved += is_moved(i);
  if (moved < 2 || count < 3) return false;
  for (std::size_t i = 0; i < count; i += step)
    if (!is_somewhere(i)) return false;
  renumbered_.emplace(golden.node, golden.primitive);
  add({"numbers", golden.node, golden.primitive}, kMissing, 0.0, "numbers", [&] {
    return fmt::format("{}, {}, primitive {}, {} of {} vertices", where, node_text(golden.node), golden.primitive,
                       moved, count);
  });
  return true;
}

}  // namespace sinew::tool
