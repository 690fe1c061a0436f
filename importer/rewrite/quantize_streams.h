// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/streams.h"

namespace sinew::rewrite {

/// How many bits the rounded values keep. Those of gltfpack where it has the same choice.
struct QuantizeBits {
  int positions = 15;  ///< of the largest coordinate of each vertex, with its sign; compressed files only
  int normals = 8;     ///< of each coordinate
  int texcoords = 12;
  int rotations = 12;    ///< of each component of a key
  int key_vectors = 16;  ///< of keys of translations and scales; compressed files only
};

/// Rounds floats to small integers: normals, tangents (KHR_mesh_quantization), texture coordinates and colours within
/// [0, 1], weights of vertices with one set, joints, and keys of rotations that are not CUBICSPLINE. Weights of a
/// vertex still add up to 1. Data of other types, ranges and uses stay floats. Positions stay floats, because nodes and
/// inverse bind matrices then stay as they are.
/// in    filters   streams are for EXT_meshopt_compression: normals and rotations take its filters, and positions and
///                 other vectors keep as many bits as `bits` says
/// cost  O(elements)
void quantize_streams(const QuantizeBits& bits, bool filters, Streams& streams, Draft& draft);

}  // namespace sinew::rewrite
