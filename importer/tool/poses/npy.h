// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::tool {

/// An array as NumPy stores it: little-endian, the last index varies fastest.
struct NpyArray {
  std::string name;  ///< in an .npz
  std::string type;  ///< NumPy's "descr": "<f4", "<f8", "<i4", "<U12"
  std::vector<std::size_t> shape;
  std::string bytes;
};

/// An array of texts ("<U", as wide as the longest).
/// in   texts   UTF-8; bytes that are none become U+FFFD
NpyArray text_array(std::string name, std::span<const std::string> texts);

/// A .npy file, format 1.0 (numpy.lib.format).
std::string npy_file(const NpyArray& array);

/// A .npz file: a zip of .npy files that are not compressed.
/// out  empty when it would be larger than 4 GiB, which is the most of a plain zip
std::string npz_file(std::span<const NpyArray> arrays);

}  // namespace sinew::tool
