// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::tool {

inline constexpr std::size_t kHelpWidth = 100;  ///< no line of any help is longer

/// A part of a text: words that flow, or a line that stands as it is.
struct Paragraph {
  std::string text;
  bool verbatim = false;
  bool after_gap = false;  ///< an empty line is before it
};

/// Takes a text apart. Line ends inside a paragraph mean nothing; an empty line ends it and stays, and a line that
/// begins with a space stands for itself.
std::vector<Paragraph> paragraphs(std::string_view text);

/// The lines of a text, each at most kHelpWidth wide. Lines but the first begin with `indent` spaces.
/// in   at   where the first line begins, when something stands before it
std::string wrapped(std::string_view text, std::size_t indent, std::size_t at);

}  // namespace sinew::tool
