// SPDX-License-Identifier: MIT
#include "importer/tool/wrapped_text.h"

namespace sinew::tool {
namespace {

/// Calls `use` with each part of a text between separators.
template <class Use>
void for_each_part(std::string_view text, char separator, const Use& use) {
  for (std::size_t end = 0; end != text.npos; text.remove_prefix(end == text.npos ? text.size() : end + 1)) {
    end = text.find(separator);
    use(text.substr(0, end));
  }
}

/// Adds words to lines that begin with `indent` spaces.
void flow(std::string_view text, std::size_t indent, std::size_t& at, std::string& out) {
  bool begins_line = true;
  for_each_part(text, ' ', [&](std::string_view word) {
    if (word.empty()) return;
    if (!begins_line && at + 1 + word.size() > kHelpWidth) {
      out += '\n' + std::string(indent, ' ');
      at = indent;
    } else if (!begins_line) {
      out += ' ';
      ++at;
    }
    out += word;
    at += word.size();
    begins_line = false;
  });
}

}  // namespace

std::vector<Paragraph> paragraphs(std::string_view text) {
  std::vector<Paragraph> out;
  bool goes_on = false, after_gap = false;
  for_each_part(text, '\n', [&](std::string_view line) {
    const bool verbatim = line.starts_with(' ');
    if (goes_on && !line.empty() && !verbatim)
      out.back().text.append(" ").append(line);
    else if (!line.empty())
      out.push_back({std::string(line), verbatim, after_gap && !out.empty()});
    goes_on = !line.empty() && !verbatim;
    after_gap = line.empty();
  });
  return out;
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t at) {
  std::string out;
  bool is_first = true;
  for (const Paragraph& paragraph : paragraphs(text)) {
    if (!is_first) {
      out += (paragraph.after_gap ? "\n\n" : "\n") + std::string(indent, ' ');
      at = indent;
    }
    is_first = false;
    if (paragraph.verbatim)
      out += paragraph.text;
    else
      flow(paragraph.text, indent, at, out);
  }
  return out;
}

}  // namespace sinew::tool
