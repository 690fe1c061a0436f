// SPDX-License-Identifier: MIT
#pragma once
#include <cstring>
#include <span>
#include <vector>

#include "tests/c/engine.h"

namespace sinew::test {

/// The C engine's array of numbers; frees itself.
struct Numbers : engine_numbers {
  Numbers() : engine_numbers{} {}
  ~Numbers() { engine_free(this); }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;
  std::vector<float> all() const { return {values, values + count}; }
};

/// Appends elements that consist of floats.
template <class T>
void add_numbers(std::vector<float>& to, std::span<const T> values) {
  const auto* floats = reinterpret_cast<const float*>(values.data());
  to.insert(to.end(), floats, floats + values.size_bytes() / sizeof(float));
}

}  // namespace sinew::test
