// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include "importer/tool/help/help.h"
#include "importer/tool/wrapped_text.h"

namespace sinew::tool {
namespace {

/// Escapes text for roff: its special characters, and lines that would be requests.
std::string escaped(std::string_view text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return out;
}

std::string paragraphs_of(std::string_view text) {
  std::string out;
  bool in_block = false;
  for (const Paragraph& paragraph : paragraphs(text)) {
    if (paragraph.verbatim != in_block) out += in_block ? ".fi\n" : ".PP\n.nf\n";
    if (!paragraph.verbatim) out += ".PP\n";
    in_block = paragraph.verbatim;
    out += escaped(paragraph.text) + '\n';
  }
  return out + (in_block ? ".fi\n" : "");
}

std::string options_of(const Command& command, bool arguments) {
  std::string out;
  for (const auto& [name, text] : explained(command, arguments))
    out += ".TP\n.B " + escaped(name) + '\n' + escaped(text) + '\n';
  return out;
}

}  // namespace

std::string man_page(const Program& program) {
  const Command& self = program.self;
  std::string out = ".TH SINEW 1 \"\" \"" + escaped(program.version) + "\" \"User Commands\"\n.SH NAME\nsinew \\- " +
                    escaped(self.summary) +
                    "\n.SH SYNOPSIS\n.B sinew\n.I COMMAND\n[\\fIOPTIONS\\fR] ...\n.SH DESCRIPTION\n" +
                    paragraphs_of(self.details) + options_of(self, false) + ".SH COMMANDS\n";
  for (const Command& command : program.commands)
    out += ".SS \\fBsinew " + escaped(command.name) + "\\fR\n" + escaped(command.summary) + '\n' +
           paragraphs_of(command.details) + ".PP\n" + escaped(usage(command)) + '\n' + options_of(command, true) +
           options_of(command, false);
  return out + ".SH NOTES\n" + paragraphs_of(program.ending);
}

}  // namespace sinew::tool
