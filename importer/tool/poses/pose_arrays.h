// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "importer/tool/poses/npz_file.h"
#include "importer/tool/poses/pose_writer.h"

namespace sinew::tool {

/// One NumPy array, a .npy file: world [S, N, 4, 4] float32, the world matrix of each node in each of the S samples of
/// all clips, for column vectors: world[s, n] @ [x, y, z, 1].
class WorldArray final : public PoseWriter {
 public:
  WorldArray(std::size_t samples, StreamedFile& out) : samples_(samples), out_(out) {}

  void begin(std::string_view, double) override {}
  void begin_clip(std::uint32_t, std::string_view) override {}
  void begin_sample(const Pose& pose) override;
  void add(const PrimitivePose&) override {}
  void end_sample() override {}
  void end_clip() override {}
  void end() override {}

 private:
  std::size_t samples_;
  bool first_ = true;
  StreamedFile& out_;
};

/// NumPy arrays, of which numpy.load() makes a dictionary (.npz). S samples of all clips, in order:
/// - world as above.
/// - time_s [S] float64; clip [S] int32, -1 for the rest pose; clip_name [S]; node_name [N].
/// - weights_<node> [S, targets] float32: morph weights, for each node that has some.
/// - node<n>_primitive<p>_vertices [V] int32: the numbers of the vertices in the file.
/// - node<n>_primitive<p>_positions [S, V, 3] float32, and the other streams of a JSON pose file. NaN = no value.
class PoseArrays final : public PoseWriter {
 public:
  PoseArrays(const Scene& scene, std::size_t samples, StreamedFile& out)
      : scene_(scene), samples_(samples), file_(out) {}

  void begin(std::string_view, double) override {}
  void begin_clip(std::uint32_t clip, std::string_view name) override;
  void begin_sample(const Pose& pose) override;
  void add(const PrimitivePose& primitive) override;
  void end_sample() override {}
  void end_clip() override {}
  void end() override;

 private:
  struct ClipSamples {
    std::string name;
    std::size_t samples = 0;
  };
  std::size_t array(const std::string& name, const char* type, std::vector<std::size_t> shape_of_sample);
  void append_floats(const std::string& name, std::vector<std::size_t> shape_of_sample,
                     const std::vector<double>& numbers);
  void append_vertices(const std::string& name, const std::vector<std::uint32_t>& vertices);
  void add_clip_names();
  void add_node_names();

  const Scene& scene_;
  std::size_t samples_;
  NpzFile file_;
  std::uint32_t clip_ = kNone;
  std::vector<ClipSamples> clips_;
  std::map<std::string, std::size_t> by_name_;
};

}  // namespace sinew::tool
