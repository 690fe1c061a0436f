// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/math/affine.h"

namespace sinew::tool {

/// The vertex arrays of a pose file, in the order in which they are written.
enum class VertexKind : std::size_t { positions, normals, tangents, dqs, dqs_normals, cors, cor_normals };
struct VertexKindTraits {
  const char* key;    ///< key in a JSON pose file
  std::size_t width;  ///< numbers per vertex
  bool direction;     ///< unit vectors: compared by their angle in degrees; false = by distance in metres
};
inline constexpr std::array<VertexKindTraits, 7> kVertexKinds{{{"positions", 3, false},
                                                               {"normals", 3, true},
                                                               {"tangents", 4, true},
                                                               {"dqs", 3, false},
                                                               {"dqsNormals", 3, true},
                                                               {"cors", 3, false},
                                                               {"corNormals", 3, true}}};

/// The deformed vertices of one primitive on one node, in world space. Node, mesh, primitive and vertex numbers are the
/// file's. NaN means "no value" (null in the file).
struct PrimitivePose {
  std::uint32_t node = 0, mesh = 0, primitive = 0;
  std::vector<std::uint32_t> vertices;                          ///< numbers of the vertices in the file, increasing
  std::array<std::vector<double>, kVertexKinds.size()> values;  ///< [width * vertices] or empty

  std::vector<double>& of(VertexKind kind) { return values[static_cast<std::size_t>(kind)]; }
  const std::vector<double>& of(VertexKind kind) const { return values[static_cast<std::size_t>(kind)]; }
};

struct NodeWorld {
  std::uint32_t node = 0;
  std::array<double, 16> world{};  ///< column-major
};

struct NodeWeights {
  std::uint32_t node = 0;
  std::vector<double> weights;
};

/// One pose of one clip at one time.
struct Pose {
  double time_s = 0.0;
  double non_unit = 0.0;  ///< golden files only: how much rotations that are not unit quaternions may change the pose
  std::vector<NodeWorld> nodes;
  std::vector<NodeWeights> weights;
  std::vector<PrimitivePose> primitives;
  std::map<std::string, std::string>
      bits;  ///< hashes: of all joints ("pose"), and of all vertices for each skinning method
};

}  // namespace sinew::tool
