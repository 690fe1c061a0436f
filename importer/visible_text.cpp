// SPDX-License-Identifier: MIT
#include "importer/visible_text.h"

#include <cstddef>
#include <cstdint>

namespace sinew {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t size = 0;  ///< bytes; 0 = not UTF-8
};

/// Decodes the first character of a non-empty text.
/// eq   1 to 4 bytes, shortest form, no surrogates   (RFC 3629)
Character first_of(std::string_view text) noexcept {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned head = at(0);
  if (head < 0x80) return {head, 1};
  const std::size_t size = head >= 0xf0 ? 4 : head >= 0xe0 ? 3 : 2;
  if (head < 0xc2 || head > 0xf4 || size > text.size()) return {};
  std::uint32_t code = head & (0xffu >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((at(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (at(i) & 0x3fu);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kSmallest[size] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
  return {code, size};
}

/// True for C0 and C1 control characters and for characters that change the direction of surrounding text.
bool is_control(std::uint32_t code) noexcept {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x200e || code == 0x200f ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

std::string hex(std::uint32_t value, int digits) {
  std::string out;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) out += "0123456789abcdef"[value >> shift & 15];
  return out;
}

std::string escape(std::uint32_t code) { return code < 0x80 ? "\\x" + hex(code, 2) : "\\u" + hex(code, 4); }

}  // namespace

std::string visible_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Character c = first_of(text);
    const std::size_t size = c.size == 0 ? 1 : c.size;
    if (c.size == 0)
      out += "\\x" + hex(static_cast<unsigned char>(text.front()), 2);
    else if (is_control(c.code))
      out += escape(c.code);
    else
      out += text.substr(0, size);
    text.remove_prefix(size);
  }
  return out;
}

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const std::size_t size = first_of(text).size;
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string visible_json(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  while (!json.empty()) {
    const Character c = first_of(json);
    const std::size_t size = c.size == 0 ? 1 : c.size;
    if (c.size != 0 && c.code >= 0x7f && is_control(c.code))
      out += "\\u" + hex(c.code, 4);
    else
      out += json.substr(0, size);
    json.remove_prefix(size);
  }
  return out;
}

}  // namespace sinew
