// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_events.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

using Place = PoseEvents::Place;

constexpr std::size_t kMostSkipped = 1000;  // nested levels

/// Keys that an object must have. A value that is no object is reported as an object without its first key.
struct Required {
  Place place;
  std::string_view key;
  const char* otherwise;
};
constexpr Required kRequired[] = {{Place::document, "clips", "an array is missing here"},
                                  {Place::clip, "clip", "an index or null is missing here"},
                                  {Place::clip, "samples", "an array is missing here"},
                                  {Place::sample, "time", "a time is missing here"},
                                  {Place::sample, "nodes", "an array is missing here"},
                                  {Place::sample, "weights", "an array is missing here"},
                                  {Place::sample, "skinned", "an array is missing here"},
                                  {Place::node, "node", "an index is missing here"},
                                  {Place::node, "world", "an array is missing here"},
                                  {Place::weights_node, "node", "an index is missing here"},
                                  {Place::weights_node, "weights", "an array is missing here"},
                                  {Place::primitive, "node", "an index is missing here"},
                                  {Place::primitive, "primitive", "an index is missing here"},
                                  {Place::primitive, "vertices", "an array is missing here"}};

std::size_t kind_of(std::string_view key) {
  const auto found =
      std::find_if(kVertexKinds.begin(), kVertexKinds.end(), [&](const auto& k) { return k.key == key; });
  return static_cast<std::size_t>(found - kVertexKinds.begin());
}

}  // namespace

/// The object or array that must follow a key, or that each element of an array must be.
struct PoseEvents::Step {
  Place from;
  std::string_view key;
  Place to;
  bool to_array;
};
const PoseEvents::Step PoseEvents::kSteps[] = {{Place::file, "", Place::document, false},
                                               {Place::document, "clips", Place::clips, true},
                                               {Place::clips, "", Place::clip, false},
                                               {Place::clip, "samples", Place::samples, true},
                                               {Place::samples, "", Place::sample, false},
                                               {Place::sample, "bits", Place::bits, false},
                                               {Place::sample, "nodes", Place::nodes, true},
                                               {Place::nodes, "", Place::node, false},
                                               {Place::node, "world", Place::world, true},
                                               {Place::sample, "weights", Place::weight_list, true},
                                               {Place::weight_list, "", Place::weights_node, false},
                                               {Place::weights_node, "weights", Place::weights, true},
                                               {Place::sample, "skinned", Place::skinned, true},
                                               {Place::skinned, "", Place::primitive, false},
                                               {Place::primitive, "vertices", Place::vertices, true},
                                               {Place::values, "", Place::value, true}};

const PoseEvents::Step* PoseEvents::step_from(const Level& level) {
  static constexpr Step kToValues{Place::primitive, "", Place::values, true};
  if (level.place == Place::primitive && kind_of(level.key) < kVertexKinds.size()) return &kToValues;
  const auto found = std::find_if(std::begin(kSteps), std::end(kSteps), [&](const Step& step) {
    return step.from == level.place && (level.is_array || step.key == level.key);
  });
  return found == std::end(kSteps) ? nullptr : found;
}

bool PoseEvents::String(const char* text, unsigned size, bool) {
  return scalar({.text = std::string_view(text, size)});
}

bool PoseEvents::RawNumber(const char* text, unsigned size, bool) {
  Scalar value;
  double number = 0.0;
  if (std::from_chars(text, text + size, number).ec != std::errc())
    number = std::strtod(std::string(text, size).c_str(), nullptr);  // too small or too large
  if (!std::isfinite(number)) return false;
  value.number = number;
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text, text + size, index);
  if (error == std::errc() && end == text + size && index < kNone) value.index = index;
  return scalar(value);
}

bool PoseEvents::Key(const char* text, unsigned size, bool) {
  if (skipped_ > 0 || issue) return true;
  Level& level = levels_.back();
  level.key.assign(text, size);
  for (std::size_t i = 0; i < std::size(kRequired); ++i)
    if (kRequired[i].place == level.place && kRequired[i].key == level.key) level.seen |= 1u << i;
  return true;
}

bool PoseEvents::enter(bool is_array) {
  if (issue) return true;
  if (skipped_ == 0) {
    const Level& level = levels_.back();
    const Step* step = step_from(level);
    if (step != nullptr && step->to_array == is_array) {
      begin(step->to);
      levels_.push_back({.place = step->to, .is_array = is_array, .key = {}});
      return true;
    }
    step != nullptr ? report_type(*step) : read(level, {});
  }
  if (++skipped_ <= kMostSkipped) return true;
  report(pointer(), fmt::format("is nested more than {} deep", kMostSkipped));
  return false;
}

bool PoseEvents::leave() {
  if (issue) return true;
  if (skipped_ > 0) {
    --skipped_;
    return true;
  }
  const Level level = std::move(levels_.back());
  levels_.pop_back();
  finish(level);
  end_of_value();
  return !stopped;
}

bool PoseEvents::scalar(const Scalar& value) {
  if (skipped_ > 0 || issue) return true;
  const Level& level = levels_.back();
  const Step* step = step_from(level);
  if (step == nullptr)
    read(level, value);
  else if (step->to == Place::value && value.is_null)
    pose_.primitives.back().values[kind_].insert(pose_.primitives.back().values[kind_].end(), width(),
                                                 std::numeric_limits<double>::quiet_NaN());
  else
    report_type(*step);
  end_of_value();
  return true;
}

void PoseEvents::read(const Level& level, const Scalar& value) {
  switch (level.place) {
    case Place::document:
      if (level.key == "extent") summary.extent = number(value);
      return;
    case Place::clip:
      if (level.key == "clip" && !value.is_null) summary.clips.back() = index(value);
      return;
    case Place::sample:
      if (level.key == "time") pose_.time_s = number(value);
      if (level.key != "nonUnit") return;
      pose_.non_unit = number(value);
      if (pose_.non_unit < 0.0) report(pointer(), "is negative");
      return;
    case Place::bits:
      if (!value.text) return report(pointer(), "is not a hash");
      pose_.bits[level.key] = *value.text;
      return;
    default: read_of_pose(level, value);
  }
}

void PoseEvents::read_of_pose(const Level& level, const Scalar& value) {
  switch (level.place) {
    case Place::node:
      if (level.key == "node") pose_.nodes.back().node = index(value);
      return;
    case Place::world:
    case Place::value: numbers_.push_back(rounded(value)); return;
    case Place::weights_node:
      if (level.key == "node") pose_.weights.back().node = index(value);
      return;
    case Place::weights: pose_.weights.back().weights.push_back(rounded(value)); return;
    case Place::primitive:
      if (level.key == "node") pose_.primitives.back().node = index(value);
      if (level.key == "primitive") pose_.primitives.back().primitive = index(value);
      return;
    case Place::vertices: pose_.primitives.back().vertices.push_back(index(value)); return;
    default: return;
  }
}

/// Begins a list. If a key occurs twice, the last value counts, so the list is emptied.
void PoseEvents::begin(Place place) {
  switch (place) {
    case Place::clip: summary.clips.push_back(kNone); return;
    case Place::sample: pose_ = {}; return;
    case Place::bits: return pose_.bits.clear();
    case Place::nodes: return pose_.nodes.clear();
    case Place::node: pose_.nodes.emplace_back(); return;
    case Place::weight_list: return pose_.weights.clear();
    case Place::weights_node: pose_.weights.emplace_back(); return;
    case Place::weights: return pose_.weights.back().weights.clear();
    case Place::skinned: return pose_.primitives.clear();
    case Place::primitive:
      pose_.primitives.emplace_back();
      kinds_ = 0;
      return;
    case Place::vertices: return pose_.primitives.back().vertices.clear();
    case Place::values:
      kind_ = kind_of(levels_.back().key);
      kinds_ |= 1u << kind_;
      return pose_.primitives.back().values[kind_].clear();
    default: return numbers_.clear();
  }
}

void PoseEvents::finish(const Level& level) {
  for (std::size_t i = 0; i < std::size(kRequired); ++i)
    if (kRequired[i].place == level.place && (level.seen >> i & 1u) == 0)
      report(fmt::format("{}/{}", pointer(), kRequired[i].key), kRequired[i].otherwise);
  if (level.place == Place::world || level.place == Place::value) finish_numbers(level.place);
  if (level.place == Place::primitive) finish_primitive();
  if (level.place == Place::sample) finish_sample();
}

void PoseEvents::finish_numbers(Place place) {
  if (place == Place::world) {
    auto& world = pose_.nodes.back().world;
    if (numbers_.size() != world.size()) return report(pointer(), "is not a matrix of 16 numbers");
    std::copy(numbers_.begin(), numbers_.end(), world.begin());
    return;
  }
  if (numbers_.size() != width()) return report(pointer(), fmt::format("is not a vector of {} numbers", width()));
  std::vector<double>& values = pose_.primitives.back().values[kind_];
  values.insert(values.end(), numbers_.begin(), numbers_.end());
}

void PoseEvents::finish_primitive() {
  const PrimitivePose& primitive = pose_.primitives.back();
  const auto& vertices = primitive.vertices;
  if (std::adjacent_find(vertices.begin(), vertices.end(), std::greater_equal<>()) != vertices.end())
    report(pointer() + "/vertices", "do not increase");
  for (std::size_t kind = 0; kind < kVertexKinds.size(); ++kind)
    if ((kinds_ >> kind & 1u) != 0 && primitive.values[kind].size() != kVertexKinds[kind].width * vertices.size())
      report(fmt::format("{}/{}", pointer(), kVertexKinds[kind].key),
             fmt::format("does not have one entry for each of the {} vertices", vertices.size()));
}

void PoseEvents::finish_sample() {
  // With two entries of one name it would be unclear which of them counts.
  const auto named_once = [this](const auto& list, const char* key, const auto& name) {
    std::set<decltype(name(list.front()))> names;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!names.insert(name(list[i])).second)
        report(fmt::format("{}/{}/{}", pointer(), key, i), "repeats what an earlier entry names");
  };
  named_once(pose_.nodes, "nodes", [](const NodeWorld& node) { return node.node; });
  named_once(pose_.weights, "weights", [](const NodeWeights& node) { return node.node; });
  named_once(pose_.primitives, "skinned", [](const PrimitivePose& p) { return std::pair(p.node, p.primitive); });
  if (issue) return;
  summarize();
  if (sink_) stopped = !sink_(summary.clips.size() - 1, pose_);
}

void PoseEvents::summarize() {
  ++summary.poses;
  for (const PrimitivePose& primitive : pose_.primitives)
    for (std::size_t kind = 0; kind < kVertexKinds.size(); ++kind)
      summary.kinds[kind] = summary.kinds[kind] || !primitive.values[kind].empty();
  for (const auto& [name, hash] : pose_.bits) summary.bits.insert(name);
}

double PoseEvents::number(const Scalar& value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (value.number && std::abs(*value.number) <= kLargest) return *value.number;
  report(pointer(levels_.back().place == Place::value ? 1 : 0), "is not a finite number of single precision");
  return 0.0;
}

/// Values of a pose were floats when they were written and become floats again, so that an unchanged pose compares
/// equal.
double PoseEvents::rounded(const Scalar& value) { return static_cast<double>(static_cast<float>(number(value))); }

std::uint32_t PoseEvents::index(const Scalar& value) {
  if (!value.index) report(pointer(), "is not an index");
  return value.index.value_or(0);
}

std::size_t PoseEvents::width() const { return kVertexKinds[kind_].width; }

void PoseEvents::end_of_value() { ++levels_.back().index; }

/// The JSON pointer of the value that is read, or of the object or array around it.
std::string PoseEvents::pointer(std::size_t without_last) const {
  std::string text;
  for (std::size_t i = 1; i + without_last < levels_.size(); ++i)
    text += levels_[i].is_array ? fmt::format("/{}", levels_[i].index) : "/" + levels_[i].key;
  return text;
}

void PoseEvents::report(std::string pointer, std::string detail) {
  if (!issue) issue = {Severity::error, "pose-format", std::move(pointer), std::move(detail)};
}

void PoseEvents::report_type(const Step& step) {
  if (step.to == Place::document) return report("", "a pose file is an object");
  if (step.to == Place::bits) return report(pointer(), "is not an object of hashes");
  if (step.to == Place::value) return report(pointer(), fmt::format("is not a vector of {} numbers", width()));
  if (step.to_array) return report(pointer(), "an array is missing here");
  const auto* first = std::find_if(std::begin(kRequired), std::end(kRequired),
                                   [&](const Required& required) { return required.place == step.to; });
  report(fmt::format("{}/{}", pointer(), first->key), first->otherwise);
}

}  // namespace sinew::tool
