// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sinew::test {

/// A KTX2 file, and its texels by the decoder of Basis Universal.
struct Ktx2Sample {
  std::uint32_t width = 0, height = 0;
  std::vector<std::byte> file;
  std::vector<std::uint8_t> rgba;
};

/// A UASTC block of random bits, and its texels by the decoder of Basis Universal.
struct UastcSample {
  unsigned mode = 0;
  std::vector<std::byte> block;
  std::vector<std::uint8_t> rgba;
};

const Ktx2Sample& etc1s_sample();        ///< BasisLZ, RGB, with 4 mip levels
const Ktx2Sample& etc1s_alpha_sample();  ///< BasisLZ, RGB and a slice of alpha
const Ktx2Sample& uastc_zstd_sample();   ///< UASTC with alpha, compressed with zstd

/// One block of each mode, in the order of modes.
std::span<const UastcSample> uastc_samples();

/// Encoded data, and the 64-bit FNV-1a hash of their texels by the decoder of Basis Universal.
struct HashedSample {
  std::vector<std::byte> data;
  std::uint64_t texel_hash = 0;
};

/// UASTC blocks of random colors with each pattern: 30 of mode 2, 11 of mode 3 and 19 of mode 7.
const HashedSample& uastc_pattern_blocks();
/// A BasisLZ file of 96 x 96 texels with alpha, which uses every kind of prediction and the history of selectors.
const HashedSample& etc1s_large_file();

/// A KTX2 file of one level.
/// in   color_model, channel   of the only sample of the data format descriptor
std::vector<std::byte> write_ktx2(std::uint32_t width, std::uint32_t height, std::uint32_t vk_format,
                                  std::uint8_t color_model, std::uint8_t channel, std::span<const std::byte> level);

}  // namespace sinew::test
