// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sinew::test {

/// `pixels` holds `channels` bytes per pixel, rows from the top.
std::vector<std::byte> encode_png(int width, int height, int channels, const std::vector<std::uint8_t>& pixels);
std::vector<std::byte> encode_jpeg(int width, int height, int channels, const std::vector<std::uint8_t>& pixels);
std::vector<std::byte> encode_progressive_jpeg(int width, int height, const std::vector<std::uint8_t>& rgb);
std::vector<std::byte> encode_webp(int width, int height, const std::vector<std::uint8_t>& rgba);  ///< lossless
/// Lossless: full chroma, no colour transform.    in   rgba  with any alpha
std::vector<std::byte> encode_avif(int width, int height, const std::vector<std::uint8_t>& rgba);

}  // namespace sinew::test
