// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_arrays.h"

#include <utility>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

template <class T>
std::string bytes_of(T number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string floats(const std::vector<double>& numbers) {
  std::string bytes;
  bytes.reserve(numbers.size() * sizeof(float));
  for (const double number : numbers) bytes += bytes_of(static_cast<float>(number));
  return bytes;
}

constexpr const char* kWorld = "world";

/// World matrices by rows.
std::vector<double> world_matrices(const Pose& pose) {
  std::vector<double> numbers;
  numbers.reserve(16 * pose.nodes.size());
  for (const NodeWorld& node : pose.nodes)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column) numbers.push_back(node.world[4 * column + row]);
  return numbers;
}

}  // namespace

void WorldArray::begin_sample(const Pose& pose) {
  if (first_) out_.write(npy_head({kWorld, "<f4", {samples_, pose.nodes.size(), 4, 4}}));
  first_ = false;
  out_.write(floats(world_matrices(pose)));
}

/// The array of a name. On first use it is created, with an entry of the given shape for each sample.
std::size_t PoseArrays::array(const std::string& name, const char* type, std::vector<std::size_t> shape_of_sample) {
  const auto [found, is_new] = by_name_.try_emplace(name, 0);
  if (is_new) {
    shape_of_sample.insert(shape_of_sample.begin(), samples_);
    found->second = file_.add({name, type, std::move(shape_of_sample)});
  }
  return found->second;
}

void PoseArrays::append_floats(const std::string& name, std::vector<std::size_t> shape_of_sample,
                               const std::vector<double>& numbers) {
  file_.append(array(name, "<f4", std::move(shape_of_sample)), floats(numbers));
}

void PoseArrays::begin_clip(std::uint32_t clip, std::string_view name) {
  clip_ = clip;
  clips_.push_back({std::string(name)});
}

void PoseArrays::begin_sample(const Pose& pose) {
  ++clips_.back().samples;
  append_floats(kWorld, {pose.nodes.size(), 4, 4}, world_matrices(pose));
  file_.append(array("time_s", "<f8", {}), bytes_of(pose.time_s));
  file_.append(array("clip", "<i4", {}), bytes_of(clip_ == kNone ? -1 : static_cast<std::int32_t>(clip_)));
  for (const NodeWeights& node : pose.weights)
    append_floats(fmt::format("weights_{}", node.node), {node.weights.size()}, node.weights);
  for (const PrimitivePose& primitive : pose.primitives) add(primitive);
}

/// Appends vertex numbers. They are the same in every sample, so the file has them once.
void PoseArrays::append_vertices(const std::string& name, const std::vector<std::uint32_t>& vertices) {
  const auto [found, is_new] = by_name_.try_emplace(name, 0);
  if (!is_new) return;
  found->second = file_.add({name, "<i4", {vertices.size()}});
  for (const std::uint32_t vertex : vertices) file_.append(found->second, bytes_of(static_cast<std::int32_t>(vertex)));
}

void PoseArrays::add(const PrimitivePose& primitive) {
  const std::string name = fmt::format("node{}_primitive{}_", primitive.node, primitive.primitive);
  if (!primitive.vertices.empty()) append_vertices(name + "vertices", primitive.vertices);
  for (std::size_t kind = 0; kind < kVertexKinds.size(); ++kind)
    if (!primitive.values[kind].empty())
      append_floats(name + kVertexKinds[kind].key, {primitive.vertices.size(), kVertexKinds[kind].width},
                    primitive.values[kind]);
}

void PoseArrays::add_clip_names() {
  std::vector<std::string> names;
  for (const ClipSamples& clip : clips_) names.push_back(clip.name);
  const std::size_t width = text_width(names);
  const std::size_t array = file_.add({"clip_name", text_type(width), {samples_}});
  for (const ClipSamples& clip : clips_) {
    const std::string entry = text_entry(clip.name, width);
    for (std::size_t s = 0; s < clip.samples; ++s) file_.append(array, entry);
  }
}

void PoseArrays::add_node_names() {
  std::vector<std::string> names;
  for (const std::uint32_t joint : scene_.skeleton.joint_of_node) names.push_back(scene_.skeleton.names[joint]);
  const std::size_t width = text_width(names);
  const std::size_t array = file_.add({"node_name", text_type(width), {names.size()}});
  for (const std::string& name : names) file_.append(array, text_entry(name, width));
}

void PoseArrays::end() {
  add_clip_names();
  add_node_names();
  file_.finish();
}

}  // namespace sinew::tool
