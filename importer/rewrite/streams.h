// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Common use of an accessor by all its users.
enum class StreamUse : std::uint8_t { vertex, triangles, indices, key_times, key_values, matrices };

/// Quantization filter before compression (EXT_meshopt_compression, "Filters").
enum class Filter : std::uint8_t { none, octahedral, quaternion, exponential };

/// The elements of one accessor; vertex elements are padded to a multiple of four bytes.
struct Stream {
  StreamUse use = StreamUse::vertex;
  std::string semantic;  ///< vertices: "NORMAL" and so on; displacements: "target POSITION" and so on; empty = several
  std::vector<std::byte> bytes;
  std::size_t stride = 0, count = 0;
  Filter filter = Filter::none;  ///< filter already applied to `bytes`

  template <class T>
  T at(std::size_t element, std::size_t component) const {
    T value;
    std::memcpy(&value, bytes.data() + element * stride + component * sizeof(T), sizeof(T));
    return value;
  }
};

/// Streams by accessor index. Accessors without bytes (zeros), and accessors with other users, have no stream.
using Streams = std::map<std::uint32_t, Stream>;

/// Reads the streams of primitives, animations and skins. With `dense`, sparse accessors become dense; otherwise they
/// have no stream.
Streams take_streams(const gltf::Document& document, Draft& draft, bool dense);

/// Writes the streams into new views; streams with equal use, stride and filter share a view.
/// in    compress   compress views with EXT_meshopt_compression if that is smaller
void put_streams(const Streams& streams, bool compress, Draft& draft);

/// Sets the component type of an accessor to a normalised integer type.
void set_normalized(Json& accessor, int component_type);

std::size_t component_count(const Json& accessor);

/// All components as stored; normalised integers are not decoded.
std::vector<double> stored_values(const Stream& stream, const Json& accessor);

}  // namespace sinew::rewrite
