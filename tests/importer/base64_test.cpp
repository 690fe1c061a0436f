// SPDX-License-Identifier: MIT
// Decoding base64: the vectors of RFC 4648, random bytes of every length, and each character that does not belong.
#include "importer/file/base64.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/importer/tiny_gltf.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

std::string decoded(const std::string& text) {
  const auto bytes = decode_base64(text);
  return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "none";
}

TEST(base64, decodes_the_test_vectors_of_rfc_4648) {
  EXPECT_EQ(decoded(""), "");
  EXPECT_EQ(decoded("Zg=="), "f");
  EXPECT_EQ(decoded("Zm8="), "fo");
  EXPECT_EQ(decoded("Zm9v"), "foo");
  EXPECT_EQ(decoded("Zm9vYg=="), "foob");
  EXPECT_EQ(decoded("Zm9vYmE="), "fooba");
  EXPECT_EQ(decoded("Zm9vYmFy"), "foobar");
  EXPECT_EQ(decoded("Zg"), "f") << "padding is optional";
  EXPECT_EQ(decoded("Zm8"), "fo");
  EXPECT_EQ(decoded("Zh=="), "f") << "bits behind the last byte are ignored";
}

TEST(base64, bytes_of_every_length_come_back) {
  FixedRandom random(11);
  for (std::size_t size = 0; size < 300; ++size) {
    std::vector<std::byte> bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.below(256));
    EXPECT_EQ(decode_base64(base64(bytes)), bytes) << size;
    EXPECT_EQ(encode_base64({reinterpret_cast<const char*>(bytes.data()), size}), base64(bytes)) << size;
  }
}

TEST(base64, refuses_every_character_that_is_not_in_the_alphabet_at_every_place) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const std::size_t size : {16u, 35u}) {
    for (std::size_t at = 0; at < size; ++at)
      for (int c = 0; c < 256; ++c) {
        std::string text(size, 'Q');
        text[at] = static_cast<char>(c);
        const bool padding = c == '=' && at + 1 == size;
        const bool good = padding || kAlphabet.find(static_cast<char>(c)) != kAlphabet.npos;
        EXPECT_EQ(decode_base64(text).has_value(), good) << c << " at " << at << " of " << size;
      }
  }
  EXPECT_EQ(decoded("A"), "none");
  EXPECT_EQ(decoded("AAAAA"), "none");
  EXPECT_EQ(decoded("===="), "none");
}

}  // namespace
}  // namespace sinew::test
