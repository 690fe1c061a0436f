// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>

namespace sinew {

/// A place in a JSON document: a key and a pointer to the place that contains it. `parent` must outlive this.
struct JsonPath {
  const JsonPath* parent = nullptr;
  std::string key;

  JsonPath() = default;
  JsonPath(const JsonPath* above, std::string name) : parent(above), key(std::move(name)) {}

  /// The place as a JSON pointer (RFC 6901), for example "/nodes/walk"; empty for the root.
  std::string text() const {
    if (parent == nullptr) return {};
    std::string out = parent->text();
    out += '/';
    for (const char c : key) {
      if (c == '~')
        out += "~0";
      else if (c == '/')
        out += "~1";
      else
        out += c;
    }
    return out;
  }
};

}  // namespace sinew
