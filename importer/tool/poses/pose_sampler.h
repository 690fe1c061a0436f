// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "importer/tool/poses/pose.h"
#include "importer/tool/poses/vertex_choice.h"
#include "runtime/base/result.h"
#include "runtime/plan/run_plan.h"

namespace sinew::tool {

/// The parts of a pose besides node matrices and morph weights.
struct PoseContent {
  bool linear = true;                       ///< positions, normals and tangents of skinned primitives
  bool dual_quaternion = true;              ///< dqs and dqsNormals of skinned primitives
  bool center_of_rotation = true;           ///< cors and corNormals of skinned primitives
  std::size_t vertices_per_primitive = 64;  ///< 0 without `bits`: nothing is skinned
  bool bits = true;                         ///< Pose::bits
};

/// Samples poses of a scene in the same way as a program that links sinew: each sample runs one compiled plan for each
/// skinning method. A primitive without centers of rotation is skinned linearly in place of that method. Positions,
/// normals and tangents of unskinned primitives are always there.
class PoseSampler {
 public:
  /// The scene must outlive the sampler.
  PoseSampler(const Scene& scene, const PoseContent& content);

  /// Evaluates one pose. The functions below read it until the next call.
  /// in    clip   index, or kNone for the rest pose
  /// err   as run_plan
  ErrorCode run(std::uint32_t clip, double time_s);

  Pose pose() const;  ///< nodes and weights, without primitives
  std::size_t primitive_count() const noexcept { return drawn_.size(); }
  PrimitivePose primitive(std::size_t i) const;  ///< one at a time, because all of them may not fit into memory

  /// Runs and returns the whole pose with all primitives.
  Result<Pose> sample(std::uint32_t clip, double time_s);

 private:
  struct Method {
    Method(const Scene& scene, Skinning skinning, bool with_vertices);
    Plan plan;
    FrameBuffer frame;
  };
  struct Drawn {  ///< one primitive of one mesh instance
    std::uint32_t instance = 0, primitive = 0;
    std::size_t choice = 0;  ///< shared by all instances of the mesh
  };

  const VertexChoice& choice_of(const Drawn& drawn) const { return choices_[drawn.choice]; }
  void add_rigid(const Drawn& drawn, PrimitivePose& out) const;
  void add_linear(const Drawn& drawn, PrimitivePose& out) const;
  void add_turned(const Method& method, const Drawn& drawn, VertexKind positions, VertexKind normals,
                  PrimitivePose& out) const;
  const FrameResult& any_frame() const;
  std::map<std::string, std::string> bits() const;

  const Scene& scene_;
  std::unique_ptr<Method> linear_;
  std::unique_ptr<Method> dual_quaternion_;
  std::unique_ptr<Method> center_of_rotation_;
  double time_s_ = 0.0;
  bool with_bits_ = true;
  std::vector<VertexChoice> choices_;  // for each primitive of each mesh
  std::vector<Drawn> drawn_;
};

}  // namespace sinew::tool
