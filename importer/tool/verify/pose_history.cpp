// SPDX-License-Identifier: MIT
#include "importer/tool/verify/pose_history.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string_view>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

constexpr std::size_t kJointsShown = 4, kStartsShown = 6, kVerticesShown = 1500;

bool is_of_joint(const Deviation& deviation) {
  const std::string_view kind = deviation.kind;
  return deviation.node != kNone && (kind == "translation" || kind == "matrix");
}

std::string name_of(std::uint32_t node, const PoseNames& names) {
  if (node < names.nodes.size() && !names.nodes[node].empty()) return names.nodes[node];
  return fmt::format("node {}", node);
}

/// The parent of a node; kNone for a root, and for a number that the file lacks.
std::uint32_t parent_of(std::uint32_t node, const Skeleton& skeleton) {
  if (node >= skeleton.joint_of_node.size() || skeleton.joint_of_node[node] == kNone) return kNone;
  const std::uint32_t parent = skeleton.parents[skeleton.joint_of_node[node]];
  return parent == kNone ? kNone : skeleton.node_of_joint[parent];
}

bool has_one_above(std::uint32_t node, const std::set<std::uint32_t>& nodes, const Skeleton& skeleton) {
  for (std::uint32_t above = parent_of(node, skeleton); above != kNone; above = parent_of(above, skeleton))
    if (nodes.contains(above)) return true;
  return false;
}

Point place_of(const NodeWorld& node) { return {node.world[12], node.world[13], node.world[14]}; }

/// The angle between two axes of any length, in degrees. atan2 keeps small angles, which acos would lose.
double angle_deg(std::span<const double> a, std::span<const double> b) {
  const Point cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double sine = std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  return std::atan2(sine, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180.0 / std::numbers::pi;
}

double turned_deg(const NodeWorld& golden, const NodeWorld& now) {
  double largest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    largest = std::fmax(
        largest, angle_deg(std::span(golden.world).subspan(4 * axis, 3), std::span(now.world).subspan(4 * axis, 3)));
  return largest;
}

const NodeWorld* find_node(const Pose& pose, std::uint32_t node) {
  const auto found = std::find_if(pose.nodes.begin(), pose.nodes.end(), [&](const auto& n) { return n.node == node; });
  return found == pose.nodes.end() ? nullptr : &*found;
}

void add_joints(PoseFigure& figure, const Pose& golden, const Pose& pose, const Skeleton& skeleton) {
  std::map<std::uint32_t, const NodeWorld*> now;
  for (const NodeWorld& node : pose.nodes) now[node.node] = &node;
  std::map<std::uint32_t, std::size_t> row_of;
  for (const NodeWorld& node : golden.nodes) {
    if (!now.contains(node.node)) continue;
    row_of[node.node] = figure.golden.size();
    figure.golden.push_back(place_of(node));
    figure.now.push_back(place_of(*now[node.node]));
  }
  for (const auto& [node, row] : row_of)
    if (const auto parent = row_of.find(parent_of(node, skeleton)); parent != row_of.end())
      figure.bones.emplace_back(parent->second, row);
}

void add_vertices(PoseFigure& figure, const PrimitivePose& golden, const PrimitivePose& now) {
  const std::vector<double>&expected = golden.of(VertexKind::positions), &found = now.of(VertexKind::positions);
  for (std::size_t i = 0; 3 * i < expected.size() && figure.vertices.size() < kVerticesShown; ++i) {
    const auto at = std::lower_bound(now.vertices.begin(), now.vertices.end(), golden.vertices[i]);
    const auto row = 3 * static_cast<std::size_t>(at - now.vertices.begin());
    if (at == now.vertices.end() || *at != golden.vertices[i] || row + 3 > found.size()) continue;
    figure.golden_vertices.push_back({expected[3 * i], expected[3 * i + 1], expected[3 * i + 2]});
    figure.vertices.push_back({found[row], found[row + 1], found[row + 2]});
  }
}

}  // namespace

PoseHistory PoseHistory::of(const std::vector<Deviation>& worst, const Skeleton& skeleton, const PoseNames& names) {
  PoseHistory history;
  if (!worst.empty()) history.figure = {.clip = worst.front().clip, .time_s = worst.front().time_s};
  std::set<std::uint32_t> moved;
  std::vector<const Deviation*> chosen;
  for (const Deviation& deviation : worst)
    if (is_of_joint(deviation) && moved.insert(deviation.node).second) chosen.push_back(&deviation);
  std::stable_partition(chosen.begin(), chosen.end(),
                        [&](const Deviation* d) { return !has_one_above(d->node, moved, skeleton); });
  std::size_t starts = 0;
  while (starts < chosen.size() && !has_one_above(chosen[starts]->node, moved, skeleton)) ++starts;
  for (std::size_t i = 0; i < std::min(starts, kStartsShown); ++i)
    history.starts.push_back(name_of(chosen[i]->node, names));
  // After the start of the worst branch come the joints by their difference.
  if (!chosen.empty())
    std::stable_sort(chosen.begin() + 1, chosen.end(),
                     [](const Deviation* a, const Deviation* b) { return a->is_worse_than(*b); });
  for (std::size_t i = 0; i < std::min(chosen.size(), kJointsShown); ++i)
    history.joints.push_back({.name = name_of(chosen[i]->node, names),
                              .clip = chosen[i]->clip,
                              .node = chosen[i]->node,
                              .worst_s = chosen[i]->time_s});
  return history;
}

void PoseHistory::add(std::uint32_t clip, const Pose& golden, const Pose& pose, const Skeleton& skeleton) {
  for (JointHistory& joint : joints) {
    if (joint.clip != clip) continue;
    const NodeWorld *const was = find_node(golden, joint.node), *const is = find_node(pose, joint.node);
    if (!was || !is) continue;
    joint.times_s.push_back(golden.time_s);
    joint.golden.push_back(place_of(*was));
    joint.now.push_back(place_of(*is));
    joint.turned_deg.push_back(turned_deg(*was, *is));
  }
  const bool is_worst = figure.clip == clip && figure.time_s == golden.time_s && figure.golden.empty();
  if (!is_worst) return;
  add_joints(figure, golden, pose, skeleton);
  for (const PrimitivePose& expected : golden.primitives)
    for (const PrimitivePose& now : pose.primitives)
      if (now.node == expected.node && now.primitive == expected.primitive) add_vertices(figure, expected, now);
}

}  // namespace sinew::tool
