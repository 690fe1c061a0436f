// SPDX-License-Identifier: MIT
#include "runtime/retarget/name_words.h"

namespace sinew {
namespace {

bool is_lower_case(char c) noexcept { return c >= 'a' && c <= 'z'; }
bool is_upper_case(char c) noexcept { return c >= 'A' && c <= 'Z'; }

}  // namespace

std::vector<std::string> name_words(std::string_view name) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool parts = is_upper_case(c) && i > 0 && is_lower_case(name[i - 1]);
    if ((parts || (!is_lower_case(c) && !is_upper_case(c))) && !words.back().empty()) words.emplace_back();
    if (is_lower_case(c)) words.back() += c;
    if (is_upper_case(c)) words.back() += static_cast<char>(c - 'A' + 'a');
  }
  return words;
}

}  // namespace sinew
