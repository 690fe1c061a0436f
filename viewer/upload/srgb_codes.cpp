// SPDX-License-Identifier: MIT
#include "viewer/upload/srgb_codes.h"

#include <cmath>

namespace sinew::viewer {

SrgbCodes::SrgbCodes() {
  const auto decode = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  for (std::size_t i = 0; i < 256; ++i) {
    linear_[i] = static_cast<float>(decode(static_cast<double>(i) / 255.0));
    above_[i] = static_cast<float>(decode((static_cast<double>(i) + 0.5) / 255.0));
  }
  above_[255] = 2.0f;
  std::uint8_t code = 0;
  for (std::size_t i = 0; i < guess_.size(); ++i) {
    while (static_cast<float>(i) / 1024.0f >= above_[code]) ++code;
    guess_[i] = code;
  }
}

const SrgbCodes& srgb_codes() {
  static const SrgbCodes codes;
  return codes;
}

}  // namespace sinew::viewer
