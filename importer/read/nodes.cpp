// SPDX-License-Identifier: MIT
#include "importer/read/nodes.h"

#include <cmath>
#include <string>
#include <vector>

#include "importer/file/json_pointer.h"
#include "importer/read/rotations.h"
#include "runtime/math/decompose.h"

namespace sinew {
namespace {

constexpr double kRotationTolerance = 5e-5;

/// Converts to vec3; returns `absent` if the vector is empty.
glm::vec3 to_vec3(const std::vector<double>& v, glm::vec3 absent) {
  return v.empty() ? absent : glm::vec3(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
}

NodeTransform read_matrix(const gltf::Node& node, const std::string& place, IssueLog& log) {
  NodeTransform out;
  out.is_matrix = true;
  if (!to_affine(node.matrix.data(), out.matrix))
    log.report(Rule::node_matrix_row, pointer(place, "matrix"), "the fourth row is not 0 0 0 1; it is ignored");
  out.transform = decompose_trs(out.matrix).transform;
  return out;
}

}  // namespace

NodeTransform read_node_transform(const gltf::Node& node, std::uint32_t index, IssueLog& log) {
  const std::string place = pointer("nodes", index);
  if (!node.matrix.empty()) {
    if (node.has_trs)
      log.report(Rule::node_matrix_trs, pointer(place, "matrix"),
                 "the node has a matrix and translation, rotation or scale; the matrix is used");
    return read_matrix(node, place, log);
  }
  const auto& r = node.rotation;
  const UnitRotation unit = r.empty() ? unit_rotation(0.0, 0.0, 0.0, 1.0) : unit_rotation(r[0], r[1], r[2], r[3]);
  if (unit.length <= 1e-12)
    log.report(Rule::rotation_zero, pointer(place, "rotation"), "has no length; taken as no rotation");
  else if (std::abs(unit.length - 1.0) > kRotationTolerance)
    log.report(Rule::rotation_length, pointer(place, "rotation"),
               "has length " + std::to_string(unit.length) + "; normalised");
  NodeTransform out;
  out.transform = {to_vec3(node.translation, glm::vec3(0.0f)), unit.rotation, to_vec3(node.scale, glm::vec3(1.0f))};
  return out;
}

}  // namespace sinew
