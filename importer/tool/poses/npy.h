// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::tool {

/// The header of a NumPy array. Numbers follow it in little-endian order; the last index varies fastest.
struct NpyArray {
  std::string name;  ///< name of the array in an .npz file
  std::string type;  ///< NumPy's "descr", such as "<f4" for float32
  std::vector<std::size_t> shape;

  std::uint64_t byte_size() const;  ///< bytes of the numbers, without the header
};

/// The bytes before the numbers of a .npy file, format 1.0 (numpy.lib.format); a multiple of 64 bytes.
std::string npy_head(const NpyArray& array);

/// The number of code points of the longest text; at least 1.
/// in   texts   UTF-8; bytes that are none count as U+FFFD
std::size_t text_width(std::span<const std::string> texts);

/// The type of an array of texts, "<U" and the width.
std::string text_type(std::size_t width);

/// An entry of an array of texts: `width` code points of four bytes, zeros behind the text.
std::string text_entry(std::string_view text, std::size_t width);

}  // namespace sinew::tool
