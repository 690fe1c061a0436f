// SPDX-License-Identifier: MIT
#include "importer/file/parse_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

namespace sinew {
namespace {

constexpr unsigned kFlags =
    rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseValidateEncodingFlag | rapidjson::kParseIterativeFlag;

/// Converts the whole text to a number; false if T cannot represent it.
template <class T>
bool converts(std::string_view text, T& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size();
}

/// Forwards the reader's events to the tree. Numbers arrive as text, because the reader's own conversion is not exact.
class TreeEvents {
 public:
  TreeEvents(JsonBuilder& tree, std::string_view source, const rapidjson::MemoryStream& stream)
      : tree_(tree), source_(source), stream_(stream) {}

  bool Null() { return tree_.Null(); }
  bool Bool(bool value) { return tree_.Bool(value); }
  bool String(const char* text, rapidjson::SizeType size, bool) {
    if (!is_utf8({text, size})) return false;
    const std::string_view here = just_read(size);
    return here == std::string_view(text, size) ? tree_.String(here.data(), size, false)
                                                : tree_.String(text, size, true);
  }
  bool Key(const char* text, rapidjson::SizeType size, bool copy) { return String(text, size, copy); }
  bool StartObject() { return enter() && tree_.StartObject(); }
  bool EndObject(rapidjson::SizeType count) {
    --depth_;
    return tree_.EndObject(count);
  }
  bool StartArray() { return enter() && tree_.StartArray(); }
  bool EndArray(rapidjson::SizeType count) {
    --depth_;
    return tree_.EndArray(count);
  }

  bool RawNumber(const char* text, rapidjson::SizeType size, bool) {
    if (std::int64_t integer = 0; converts({text, size}, integer)) return tree_.Int64(integer);
    if (std::uint64_t integer = 0; converts({text, size}, integer)) return tree_.Uint64(integer);
    double number = 0.0;
    if (!converts({text, size}, number))
      number = std::strtod(std::string(text, size).c_str(), nullptr);  // underflow or overflow
    if (!std::isfinite(number)) return fail("number overflow");
    return tree_.Double(number);
  }

  // Never called: the reader passes numbers as text.
  bool Int(int) { return false; }
  bool Uint(unsigned) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }

  bool too_deep() const noexcept { return depth_ > kMaxJsonDepth; }
  const char* reason() const noexcept { return reason_; }

 private:
  bool enter() { return ++depth_ <= kMaxJsonDepth; }
  bool fail(const char* reason) {
    reason_ = reason;
    return false;
  }

  /// Rejects lone surrogates, which encode as ED A0..BF: the reader accepts them in escapes.
  bool is_utf8(std::string_view text) {
    for (std::size_t at = text.find('\xed'); at != text.npos; at = text.find('\xed', at + 1))
      if (at + 1 < text.size() && static_cast<unsigned char>(text[at + 1]) >= 0xa0)
        return fail("half a surrogate pair");
    return true;
  }

  /// The last `size` bytes of the source before the closing quote. If they equal the string (nothing was escaped), the
  /// tree refers to them without a copy: data URIs can be as long as the file.
  std::string_view just_read(std::size_t size) const noexcept {
    const std::size_t end = stream_.Tell() - 1;
    return size < end ? source_.substr(end - size, size) : std::string_view();
  }

  JsonBuilder& tree_;
  std::string_view source_;
  const rapidjson::MemoryStream& stream_;
  std::size_t depth_ = 0;
  const char* reason_ = nullptr;
};

std::string describe_place(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 = 0 on the first line
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1) + ": ";
}

}  // namespace

std::unique_ptr<JsonTree> parse_json(std::span<const std::byte> bytes, IssueLog& log) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xEF\xBB\xBF")) {
    log.report(Rule::json_bom, "", "the text starts with a byte order mark, which is skipped");
    text.remove_prefix(3);
  }
  constexpr std::size_t kSmallest = 2048, kLargest = std::size_t{1} << 18;
  auto out = std::make_unique<JsonTree>(std::clamp(text.size(), kSmallest, kLargest));
  JsonBuilder tree(&out->pool, 256, &out->memory);
  rapidjson::MemoryStream stream(text.data(), text.size());
  TreeEvents events(tree, text, stream);
  rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, JsonMemory> reader(&out->memory);
  rapidjson::ParseResult result;
  auto parse = [&](JsonBuilder&) { return !(result = reader.Parse<kFlags>(stream, events)).IsError(); };
  tree.Populate(parse);
  if (events.too_deep()) {
    log.report(Rule::json_depth, "", "nested more than " + std::to_string(kMaxJsonDepth) + " deep");
    return nullptr;
  }
  if (result.IsError()) {
    const char* reason = events.reason() != nullptr ? events.reason() : rapidjson::GetParseError_En(result.Code());
    const bool encoding = result.Code() == rapidjson::kParseErrorStringInvalidEncoding;
    log.report(
        Rule::json_syntax, "",
        describe_place(text, result.Offset()) + reason + (encoding ? " The text is not UTF-8; save it as UTF-8." : ""));
    return nullptr;
  }
  out->root.Swap(tree);
  return out;
}

}  // namespace sinew
