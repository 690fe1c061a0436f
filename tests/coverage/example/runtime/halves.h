// SPDX-License-Identifier: MIT
// A template that is compiled twice, each copy by another source.
#pragma once
#include <stdexcept>

template <class Number>
Number half(Number x) {
  if (x < Number(0)) throw std::range_error("negative");
  return x / Number(2);
}
