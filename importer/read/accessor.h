// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "importer/file/document.h"

namespace sinew {

/// Memory layout of one element of an accessor. Matrix columns start at multiples of 4 bytes, so small matrices have
/// padding after each column.
struct ElementLayout {
  std::uint32_t rows = 1, columns = 1;  ///< a vector is one column
  std::uint32_t component_bytes = 4;
  std::uint32_t column_bytes = 4;   ///< bytes of a column, including its padding
  std::uint32_t element_bytes = 4;  ///< bytes of an element, including its padding

  std::uint32_t components() const noexcept { return rows * columns; }
};

ElementLayout element_layout(gltf::ElementType type, gltf::ComponentType component) noexcept;
inline ElementLayout element_layout(const gltf::Accessor& accessor) noexcept {
  return element_layout(accessor.type, accessor.component_type);
}
std::uint32_t component_bytes(gltf::ComponentType type) noexcept;
bool is_unsigned(gltf::ComponentType type) noexcept;

/// Bytes between elements: the byteStride of the view, else the element size.
std::uint64_t element_stride(const gltf::Document& document, const gltf::Accessor& accessor) noexcept;

/// Reads all components of all elements as floats, column by column. Applies sparse replacements, decodes normalised
/// integers, skips padding. An accessor without a view holds zeros. Bytes are copied, so alignment does not matter.
/// eq    signed normalised f = max(c / (2^(b-1) - 1), -1), unsigned f = c / (2^b - 1)   (glTF 2.0, "Animations")
/// in    accessor   passed check_accessors()
/// out   [count * components]
/// cost  O(count)
std::vector<float> read_floats(const gltf::Document& document, std::uint32_t accessor);

/// Reads elements as vectors. V is glm::vec2, vec3 or vec4, with as many components as the accessor; not for matrices.
template <class V>
std::vector<V> read_vectors(const gltf::Document& document, std::uint32_t accessor);

/// The replacements of a sparse accessor, in file order; `indices` are the replaced elements.
template <class V>
struct Replacements {
  std::vector<std::uint32_t> indices;
  std::vector<V> values;
};
template <class V>
Replacements<V> read_replacements(const gltf::Document& document, std::uint32_t accessor);

/// Reads unsigned integers such as indices and joints, without normalisation.
std::vector<std::uint32_t> read_unsigned(const gltf::Document& document, std::uint32_t accessor);

/// Reads components as stored; normalised integers are not decoded.
std::vector<double> read_stored(const gltf::Document& document, std::uint32_t accessor);

}  // namespace sinew
