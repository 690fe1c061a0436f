// SPDX-License-Identifier: MIT
#include "importer/file/json_reader.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

namespace sinew {
namespace {

static_assert(std::endian::native == std::endian::little, "special_bytes() reads the first byte as the lowest");

constexpr std::uint64_t kEachByte = 0x0101010101010101;

/// Sets the highest bit of each zero byte. Bytes above the first zero byte may be marked wrongly.
constexpr std::uint64_t zero_bytes(std::uint64_t bytes) { return (bytes - kEachByte) & ~bytes; }

/// Marks the bytes that end a run of plain text in a string: quote, backslash, control characters, bytes beyond ASCII.
/// Only the lowest mark is exact.
constexpr std::uint64_t special_bytes(std::uint64_t text) {
  const std::uint64_t controls = (text - kEachByte * 0x20) & ~text;
  return (zero_bytes(text ^ kEachByte * '"') | zero_bytes(text ^ kEachByte * '\\') | controls | text) &
         kEachByte * 0x80;
}

constexpr bool is_special(unsigned char c) { return c == '"' || c == '\\' || c < 0x20 || c >= 0x80; }

const char* skip_plain_text(const char* at, const char* end) noexcept {
  for (std::uint64_t text = 0; end - at >= 8; at += 8) {
    std::memcpy(&text, at, sizeof text);
    if (const std::uint64_t special = special_bytes(text); special != 0) return at + std::countr_zero(special) / 8;
  }
  while (at != end && !is_special(static_cast<unsigned char>(*at))) ++at;
  return at;
}

/// Bytes of the well-formed UTF-8 sequence at `at` (Unicode 15, table 3-7); 0 if there is none.
std::size_t utf8_length(const char* at, const char* end) noexcept {
  const auto left = static_cast<std::size_t>(end - at);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(at[i]); };
  const auto follows = [&](std::size_t i, unsigned char low = 0x80, unsigned char high = 0xbf) {
    return i < left && byte(i) >= low && byte(i) <= high;
  };
  const unsigned char lead = byte(0);
  if (lead >= 0xc2 && lead <= 0xdf) return follows(1) ? 2 : 0;
  if (lead >= 0xe0 && lead <= 0xef)
    return follows(1, lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf) && follows(2) ? 3 : 0;
  if (lead >= 0xf0 && lead <= 0xf4)
    return follows(1, lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf) && follows(2) && follows(3) ? 4 : 0;
  return 0;
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto tail = [&](unsigned shift) { out += static_cast<char>(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | code >> 6);
    tail(0);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xe0 | code >> 12);
    tail(6);
    tail(0);
  } else {
    out += static_cast<char>(0xf0 | code >> 18);
    tail(12);
    tail(6);
    tail(0);
  }
}

/// Converts the whole text to a number; false if T cannot represent it.
template <class T>
bool converts(std::string_view text, T& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size();
}

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// One value after the other, by recursive descent. Each function is false at the first fault.
class JsonReader {
 public:
  JsonReader(std::string_view text, JsonBuilder& tree)
      : at_(text.data()), end_(text.data() + text.size()), tree_(tree) {}

  JsonOutcome read() {
    if (!value()) return depth_ > kMaxJsonDepth ? JsonOutcome::too_deep : JsonOutcome::invalid;
    skip_space();
    return at_ == end_ || *at_ == '\0' ? JsonOutcome::read : JsonOutcome::invalid;
  }

 private:
  void skip_space() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
  }

  bool take(char c) {
    const bool found = at_ != end_ && *at_ == c;
    at_ += found;
    return found;
  }

  bool take_word(std::string_view word) {
    const bool found = std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(word);
    if (found) at_ += word.size();
    return found;
  }

  bool value() {
    skip_space();
    if (at_ == end_) return false;
    switch (*at_) {
      case '{': return object();
      case '[': return array();
      case '"': ++at_; return string();
      case 't': return take_word("true") && tree_.Bool(true);
      case 'f': return take_word("false") && tree_.Bool(false);
      case 'n': return take_word("null") && tree_.Null();
      default: return number();
    }
  }

  bool object() {
    if (++depth_ > kMaxJsonDepth) return false;
    ++at_;
    tree_.StartObject();
    rapidjson::SizeType count = 0;
    skip_space();
    if (!take('}')) {
      do {
        skip_space();
        if (!take('"') || !string()) return false;
        skip_space();
        if (!take(':') || !value()) return false;
        ++count;
        skip_space();
      } while (take(','));
      if (!take('}')) return false;
    }
    --depth_;
    return tree_.EndObject(count);
  }

  bool array() {
    if (++depth_ > kMaxJsonDepth) return false;
    ++at_;
    tree_.StartArray();
    rapidjson::SizeType count = 0;
    skip_space();
    if (!take(']')) {
      do {
        if (!value()) return false;
        ++count;
        skip_space();
      } while (take(','));
      if (!take(']')) return false;
    }
    --depth_;
    return tree_.EndArray(count);
  }

  /// Reads a string up to its closing quote. The tree refers to the text if nothing in it is escaped: data URIs can be
  /// as long as the file.
  bool string() {
    const char* const first = at_;
    if (!skip_text()) return false;
    if (*at_ == '\\') return escaped_string(first);
    const auto size = static_cast<rapidjson::SizeType>(at_ - first);
    ++at_;
    return tree_.String(first, size, false);
  }

  bool escaped_string(const char* first) {
    unescaped_.assign(first, at_);
    while (*at_ == '\\') {
      ++at_;
      if (!escape()) return false;
      const char* const plain = at_;
      if (!skip_text()) return false;
      unescaped_.append(plain, at_);
    }
    ++at_;
    return tree_.String(unescaped_.data(), static_cast<rapidjson::SizeType>(unescaped_.size()), true);
  }

  /// Moves to the next quote or backslash. False if a control character, bytes that are no UTF-8, or the end come
  /// first.
  bool skip_text() {
    for (;;) {
      at_ = skip_plain_text(at_, end_);
      if (at_ == end_) return false;
      if (*at_ == '"' || *at_ == '\\') return true;
      const std::size_t length = static_cast<unsigned char>(*at_) < 0x20 ? 0 : utf8_length(at_, end_);
      if (length == 0) return false;
      at_ += length;
    }
  }

  bool escape() {
    if (at_ == end_) return false;
    switch (*at_++) {
      case '"': unescaped_ += '"'; return true;
      case '\\': unescaped_ += '\\'; return true;
      case '/': unescaped_ += '/'; return true;
      case 'b': unescaped_ += '\b'; return true;
      case 'f': unescaped_ += '\f'; return true;
      case 'n': unescaped_ += '\n'; return true;
      case 'r': unescaped_ += '\r'; return true;
      case 't': unescaped_ += '\t'; return true;
      case 'u': return escaped_code_point();
      default: return false;
    }
  }

  /// Reads the digits after "\u", and the second half of a surrogate pair.
  bool escaped_code_point() {
    std::uint32_t code = 0, low = 0;
    if (!four_digits(code) || (code >= 0xdc00 && code < 0xe000)) return false;
    if (code >= 0xd800 && code < 0xdc00) {
      if (!take('\\') || !take('u') || !four_digits(low) || low < 0xdc00 || low >= 0xe000) return false;
      code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
    }
    append_utf8(unescaped_, code);
    return true;
  }

  bool four_digits(std::uint32_t& code) {
    if (end_ - at_ < 4) return false;
    const auto [end, error] = std::from_chars(at_, at_ + 4, code, 16);
    const bool all = error == std::errc() && end == at_ + 4;
    at_ += 4;
    return all;
  }

  /// Reads digits into the mantissa, which is right for up to 19 of them. False if there are none.
  bool digits(std::uint64_t& mantissa) {
    const char* const first = at_;
    for (; at_ != end_ && is_digit(*at_); ++at_) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at_ - '0');
    return at_ != first;
  }

  bool number() {
    const char* const first = at_;
    const bool negative = take('-');
    const char* const whole = at_;
    std::uint64_t mantissa = 0;
    if (!take('0') && !digits(mantissa)) return false;
    std::ptrdiff_t digit_count = at_ - whole, exponent = 0;
    bool integer = true;
    if (take('.')) {
      const char* const fraction = at_;
      if (!digits(mantissa)) return false;
      exponent = fraction - at_;
      digit_count -= exponent;
      integer = false;
    }
    if (take('e') || take('E')) {
      std::uint64_t ignored = 0;
      if (!take('-')) take('+');
      if (!digits(ignored)) return false;
      return converted(first);
    }
    if (integer && digit_count <= 18)
      return tree_.Int64(negative ? -static_cast<std::int64_t>(mantissa) : static_cast<std::int64_t>(mantissa));
    if (integer || digit_count > 19 || mantissa > kExactInteger || exponent < -kExactPowers) return converted(first);
    const double value = static_cast<double>(mantissa) / kPowersOfTen[-exponent];
    return tree_.Double(negative ? -value : value);
  }

  /// The general conversion, for numbers that number() has verified.
  bool converted(const char* first) {
    const std::string_view text(first, static_cast<std::size_t>(at_ - first));
    if (std::int64_t integer = 0; converts(text, integer)) return tree_.Int64(integer);
    if (std::uint64_t integer = 0; converts(text, integer)) return tree_.Uint64(integer);
    double number = 0.0;
    if (!converts(text, number)) number = std::strtod(std::string(text).c_str(), nullptr);  // underflow or overflow
    return std::isfinite(number) && tree_.Double(number);
  }

  /// Quotients of integers up to 2^53 and of these powers, both exact, are rounded once: they are the nearest doubles.
  static constexpr std::uint64_t kExactInteger = std::uint64_t{1} << 53;
  static constexpr int kExactPowers = 22;
  static constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                            1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

  const char* at_;
  const char* const end_;
  JsonBuilder& tree_;
  std::size_t depth_ = 0;
  std::string unescaped_;
};

}  // namespace

JsonOutcome read_json(std::string_view text, JsonBuilder& tree) { return JsonReader(text, tree).read(); }

}  // namespace sinew
