// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew {

/// Options for computing centers of rotation.
struct CentersOptions {
  double sigma = 0.1;                                ///< width of the similarity kernel; the paper's value
  std::function<void(double done_0_to_1)> progress;  ///< called occasionally on the calling thread; may be empty
  std::filesystem::path cache_folder;                ///< empty = no cache; holds one file per surface and sigma
};

/// Optimised centers of rotation: for each vertex, the point of the bind shape about which similarly weighted parts of
/// the surface rotate.
/// eq    p*_i = sum_t s(w_i, w_t) a_t v_t / sum_t s(w_i, w_t) a_t over triangles t with area a_t, centroid v_t and mean
///       weights w_t;  s(u, v) = sum_{j != k} u_j u_k v_j v_k exp(-(u_j v_k - u_k v_j)^2 / sigma^2) (Le and Hodgins
///       2016, "Real-time skeletal skinning with optimized centers of rotation", eqs. 1 and 4)
/// in    primitive   skinned triangles: positions, indices, influences
/// out   [V] points in mesh space. A vertex with fewer than two influences, or without a similar triangle, gets its own
///       position, where the method equals linear blend skinning
/// cost  O(V * triangles that share a pair of joints), in double, on all cores. Vertices with equal weights are
///       computed once; triangles with equal weights are merged. With a cache folder, later calls read the result; a
///       damaged cache file is replaced
std::vector<glm::vec3> centers_of_rotation(const Primitive& primitive, const CentersOptions& options = {});

}  // namespace sinew
