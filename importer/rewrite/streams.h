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

/// What an accessor is used for, by all that use it.
enum class StreamUse : std::uint8_t { vertex, triangles, indices, key_times, key_values, matrices };

/// How floats are rounded before they are compressed (EXT_meshopt_compression, "Filters").
enum class Filter : std::uint8_t { none, octahedral, quaternion, exponential };

/// The elements of one accessor, one after another, each padded to a multiple of four bytes where they are vertices.
struct Stream {
  StreamUse use = StreamUse::vertex;
  std::string semantic;  ///< of vertices, such as "NORMAL"; "target POSITION" of displacements; empty = several
  std::vector<std::byte> bytes;
  std::size_t stride = 0, count = 0;
  Filter filter = Filter::none;  ///< `bytes` hold filtered elements already

  template <class T>
  T at(std::size_t element, std::size_t component) const {
    T value;
    std::memcpy(&value, bytes.data() + element * stride + component * sizeof(T), sizeof(T));
    return value;
  }
};

/// Streams by accessor. Accessors without bytes (zeros) and accessors that anything else refers to have none.
using Streams = std::map<std::uint32_t, Stream>;

/// Reads the streams of primitives, animations and skins. Sparse accessors become dense where `dense` is set, and have
/// no stream otherwise.
Streams take_streams(const gltf::Document& document, Draft& draft, bool dense);

/// Writes the streams into views of their own: those of one use, stride and filter one after another in a view.
/// in    compress   views become EXT_meshopt_compression streams where that is smaller
void put_streams(const Streams& streams, bool compress, Draft& draft);

/// Says that the elements of an accessor are integers of this type, which stand for floats.
void set_normalized(Json& accessor, int component_type);

std::size_t component_count(const Json& accessor);

/// All components as numbers, as they are stored; no normalised integer is decoded.
std::vector<double> stored_values(const Stream& stream, const Json& accessor);

}  // namespace sinew::rewrite
