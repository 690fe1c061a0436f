// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/vertex_streams.h"

namespace sinew {

/// An array whose elements lie `stride` bytes apart, as an attribute in an interleaved vertex buffer. Elements need no
/// alignment.
template <class T>
struct StridedSpan {
  using Byte = std::conditional_t<std::is_const_v<T>, const std::byte, std::byte>;
  using Value = std::remove_const_t<T>;

  Byte* first = nullptr;
  std::size_t count = 0;
  std::size_t stride = sizeof(T);

  bool empty() const noexcept { return count == 0; }
  StridedSpan part(std::size_t from, std::size_t part_count) const noexcept {
    return empty() ? StridedSpan() : StridedSpan{first + from * stride, part_count, stride};
  }
  Value load(std::size_t i) const noexcept {
    Value value;
    std::memcpy(&value, first + i * stride, sizeof value);
    return value;
  }
  void store(std::size_t i, const Value& value) const noexcept requires(!std::is_const_v<T>) {
    std::memcpy(first + i * stride, &value, sizeof value);
  }
};

/// As VertexInput and VertexOutput, with a stride for each attribute.
struct StridedInput {
  StridedSpan<const glm::vec3> positions, normals;
  StridedSpan<const glm::vec4> tangents;
};
struct StridedOutput {
  StridedSpan<glm::vec3> positions, normals;
  StridedSpan<glm::vec4> tangents;
};

}  // namespace sinew
