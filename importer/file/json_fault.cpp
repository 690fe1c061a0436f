// SPDX-License-Identifier: MIT
#include "importer/file/json_fault.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include "importer/file/json_tree.h"

namespace sinew {
namespace {

constexpr unsigned kFlags =
    rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseValidateEncodingFlag | rapidjson::kParseIterativeFlag;

/// Refuses what RapidJSON's reader lets pass: half a surrogate pair in escapes, numbers beyond double.
class FaultFinder : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, FaultFinder> {
 public:
  bool Default() { return true; }
  bool String(const char* text, rapidjson::SizeType size, bool) { return is_utf8({text, size}); }
  bool Key(const char* text, rapidjson::SizeType size, bool) { return is_utf8({text, size}); }
  bool RawNumber(const char* text, rapidjson::SizeType size, bool) {
    return std::isfinite(std::strtod(std::string(text, size).c_str(), nullptr)) || fail("number overflow");
  }

  const char* reason() const noexcept { return reason_; }

 private:
  bool fail(const char* reason) {
    reason_ = reason;
    return false;
  }

  /// Surrogates encode as ED A0..BF.
  bool is_utf8(std::string_view text) {
    for (std::size_t at = text.find('\xed'); at != text.npos; at = text.find('\xed', at + 1))
      if (at + 1 < text.size() && static_cast<unsigned char>(text[at + 1]) >= 0xa0)
        return fail("half a surrogate pair");
    return true;
  }

  const char* reason_ = nullptr;
};

std::string describe_place(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 = 0 on the first line
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1) + ": ";
}

}  // namespace

std::string describe_json_fault(std::string_view text) {
  rapidjson::MemoryStream stream(text.data(), text.size());
  JsonMemory memory;
  rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, JsonMemory> reader(&memory);
  FaultFinder finder;
  const rapidjson::ParseResult result = reader.Parse<kFlags>(stream, finder);
  if (!result.IsError()) return {};
  const char* reason = finder.reason() != nullptr ? finder.reason() : rapidjson::GetParseError_En(result.Code());
  const bool encoding = result.Code() == rapidjson::kParseErrorStringInvalidEncoding;
  return describe_place(text, result.Offset()) + reason + (encoding ? " The text is not UTF-8; save it as UTF-8." : "");
}

}  // namespace sinew
