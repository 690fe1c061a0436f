// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_arrays.h"

#include <utility>

#include <fmt/format.h>

namespace sinew::tool {
namespace {

template <class T>
void append(NpyArray& array, T number) {
  array.bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void append_floats(NpyArray& array, const std::vector<double>& numbers) {
  for (const double number : numbers) append(array, static_cast<float>(number));
}

}  // namespace

/// The array of a name, made when it is first asked for. Its shape is that of one sample until finish_shapes().
NpyArray& PoseArrays::array(const std::string& name, const char* type, std::vector<std::size_t> shape_of_sample) {
  const auto [found, is_new] = by_name_.try_emplace(name, arrays_.size());
  if (is_new) arrays_.push_back({name, type, std::move(shape_of_sample), {}});
  return arrays_[found->second];
}

void PoseArrays::begin_clip(std::uint32_t clip, std::string_view name) {
  clip_ = clip;
  clip_name_ = name;
}

void PoseArrays::begin_sample(const Pose& pose) {
  ++samples_;
  NpyArray& world = array("world", "<f4", {pose.nodes.size(), 4, 4});
  for (const NodeWorld& node : pose.nodes)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        append(world, static_cast<float>(node.world[4 * column + row]));
  if (!all_) return;
  append(array("time_s", "<f8", {}), pose.time_s);
  append(array("clip", "<i4", {}), clip_ == kNone ? -1 : static_cast<std::int32_t>(clip_));
  clip_names_.push_back(clip_name_);
  for (const NodeWeights& node : pose.weights)
    append_floats(array(fmt::format("weights_{}", node.node), "<f4", {node.weights.size()}), node.weights);
  for (const PrimitivePose& primitive : pose.primitives) add(primitive);
}

void PoseArrays::add(const PrimitivePose& primitive) {
  if (!all_) return;
  const std::string name = fmt::format("node{}_primitive{}_", primitive.node, primitive.primitive);
  const std::string vertices = name + "vertices";
  if (!by_name_.contains(vertices))
    for (const std::uint32_t vertex : primitive.vertices)
      append(array(vertices, "<i4", {primitive.vertices.size()}), static_cast<std::int32_t>(vertex));
  for (std::size_t kind = 0; kind < kVertexKinds.size(); ++kind)
    if (!primitive.values[kind].empty())
      append_floats(array(name + kVertexKinds[kind].key, "<f4", {primitive.vertices.size(), kVertexKinds[kind].width}),
                    primitive.values[kind]);
}

/// Numbers of vertices are the same in every sample; everything else has an entry for each.
void PoseArrays::finish_shapes() {
  for (NpyArray& array : arrays_)
    if (!array.name.ends_with("_vertices")) array.shape.insert(array.shape.begin(), samples_);
}

std::string PoseArrays::end() {
  finish_shapes();
  if (!all_) {
    out_.write(npy_file(arrays_.at(0)));
    return {};
  }
  std::vector<std::string> nodes;
  for (const std::uint32_t joint : scene_.skeleton.joint_of_node) nodes.push_back(scene_.skeleton.names[joint]);
  arrays_.push_back(text_array("clip_name", clip_names_));
  arrays_.push_back(text_array("node_name", nodes));
  const std::string file = npz_file(arrays_);
  out_.write(file);
  return file.empty() ? "is more than an .npz file of 4 GiB can hold" : "";
}

}  // namespace sinew::tool
