// SPDX-License-Identifier: MIT
// Fragment shaders read dFdx and textures of neighbouring pixels: after a discard those are undefined.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

/// True if a shader continues after it may have discarded its pixel.
bool goes_on_after_discard(const std::string& text) {
  static const std::regex last(R"(\bdiscard\s*;\s*\}\s*$)");
  const std::string code = without_comments(text);
  const std::regex any(R"(\bdiscard\b)");
  const auto count = std::distance(std::sregex_iterator(code.begin(), code.end(), any), std::sregex_iterator());
  return count > 1 || (count == 1 && !std::regex_search(code, last));
}

TEST(shader_quads, nothing_follows_a_discard) {
  std::vector<std::string> found;
  int discarding = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(SINEW_SOURCE_DIR) / "viewer/shaders")) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    discarding += text.find("discard;") != std::string::npos;
    if (goes_on_after_discard(text)) found.push_back(entry.path().filename());
  }
  EXPECT_THAT(found, testing::IsEmpty());
  EXPECT_GE(discarding, 2) << "the passes with an alpha test";
}

TEST(shader_quads, finds_code_after_a_discard) {
  EXPECT_TRUE(goes_on_after_discard("void main() { if (a < b) discard; c = texture(d, e); }\n"));
  EXPECT_TRUE(goes_on_after_discard("void f() { discard; }\nvoid main() { f(); c = dFdx(d); }\n"));
  EXPECT_FALSE(goes_on_after_discard("void main() { c = texture(d, e); if (a < b) discard; }\n"));
  EXPECT_FALSE(goes_on_after_discard("void main() { c = d; }  // no discard here\n"));
}

}  // namespace
}  // namespace sinew::test
