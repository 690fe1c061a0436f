// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace sinew::viewer {

/// Tables that convert between 8-bit sRGB codes and linear light. Calling pow for each channel would take a second for
/// a large texture.
class SrgbCodes {
 public:
  SrgbCodes();

  float decode(std::uint8_t code) const noexcept { return linear_[code]; }

  /// The sRGB code nearest to a linear value, by distance in sRGB.
  /// in   value  [0, 1]
  std::uint8_t encode(float value) const noexcept {
    std::uint8_t code = guess_[static_cast<std::size_t>(value * 1024.0f)];
    while (value >= above_[code]) ++code;
    return code;
  }

 private:
  std::array<float, 256> linear_{};  // linear value of each code
  std::array<float, 256> above_{};  // least linear value that encodes to the next code; the last entry is never reached
  std::array<std::uint8_t, 1025> guess_{};  // lower bound of the code of i / 1024
};

const SrgbCodes& srgb_codes();

}  // namespace sinew::viewer
