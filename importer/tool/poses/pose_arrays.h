// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

#include "importer/tool/poses/npy.h"
#include "importer/tool/poses/pose_writer.h"

namespace sinew::tool {

/// NumPy arrays, of which numpy.load() makes a dictionary (.npz) or one array (.npy). S samples of all clips, in order:
/// - world [S, N, 4, 4] float32: the world matrix of each node, for column vectors: world[s, n] @ [x, y, z, 1];
///   an .npy file holds this array and no other.
/// - time_s [S] float64; clip [S] int32, -1 for the rest pose; clip_name [S]; node_name [N].
/// - weights_<node> [S, targets] float32: morph weights, for each node that has some.
/// - node<n>_primitive<p>_vertices [V] int32: the numbers of the vertices in the file; beside it ..._positions
///   [S, V, 3] float32, and whatever else a pose file in JSON has for them. NaN = no value.
/// Held in memory until end().
class PoseArrays final : public PoseWriter {
 public:
  PoseArrays(const Scene& scene, StreamedFile& out, bool all) : scene_(scene), out_(out), all_(all) {}

  void begin(std::string_view, double) override {}
  void begin_clip(std::uint32_t clip, std::string_view name) override;
  void begin_sample(const Pose& pose) override;
  void add(const PrimitivePose& primitive) override;
  void end_sample() override {}
  void end_clip() override {}
  std::string end() override;

 private:
  NpyArray& array(const std::string& name, const char* type, std::vector<std::size_t> shape_of_sample);
  void finish_shapes();

  const Scene& scene_;
  StreamedFile& out_;
  bool all_;
  std::size_t samples_ = 0;
  std::uint32_t clip_ = kNone;
  std::string clip_name_;
  std::vector<std::string> clip_names_;  // of each sample
  std::vector<NpyArray> arrays_;
  std::map<std::string, std::size_t> by_name_;
};

}  // namespace sinew::tool
