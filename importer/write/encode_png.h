// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "runtime/model/material.h"

namespace sinew::write {

/// Encodes the image as an 8-bit RGBA PNG file.
std::vector<std::byte> encode_png(const Image& image);

}  // namespace sinew::write
