// SPDX-License-Identifier: MIT
#pragma once
#include <set>

#include "importer/rewrite/streams.h"

namespace sinew::rewrite {

/// Bits of quantized values. The defaults are those of gltfpack where it has the same option.
struct QuantizeBits {
  int positions = 15;  ///< of the largest coordinate of each vertex, including the sign; compressed files only
  int normals = 8;     ///< of each coordinate
  int texcoords = 12;
  bool keys = true;                           ///< false: keys stay floats
  int rotations = 12;                         ///< per component of a key
  int key_vectors = 16;                       ///< of translation and scale keys; compressed files only
  std::set<std::uint32_t> fine_weights = {};  ///< accessors of weights that get 16 bits, others get 8 (weight_bits.h)
};

/// Quantizes floats to small integers. Covers normals and tangents (KHR_mesh_quantization), texture coordinates and
/// colours within [0, 1], joints, and weights of vertices with one set. Also rotation keys that are not CUBICSPLINE.
/// Weights of a vertex still sum to 1; a weight that becomes 0 names joint 0. Rotation keys of nodes with a camera or a
/// light, and of nodes above these, keep 16 bits. Other data stay floats. So do positions, so that nodes and inverse
/// bind matrices need no change.
/// in    filters   streams are for EXT_meshopt_compression: normals and rotations use its filters; positions and other
///       vectors are rounded to `bits`
/// cost  O(elements)
void quantize_streams(const QuantizeBits& bits, bool filters, Streams& streams, Draft& draft);

}  // namespace sinew::rewrite
