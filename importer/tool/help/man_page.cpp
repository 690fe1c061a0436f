// SPDX-License-Identifier: MIT
#include "importer/tool/help/man_page.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "importer/tool/help/command_text.h"
#include "importer/tool/help/wrapped_text.h"

namespace sinew::tool {
namespace {

/// Text that roff takes as it is: its own characters escaped, no line a request.
std::string escaped(std::string_view text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text)
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + escaped(text) + "\\fR"; }

void put_paragraphs(std::string& out, std::string_view text) {
  bool in_block = false;
  for (const Paragraph& paragraph : paragraphs(text)) {
    if (paragraph.verbatim != in_block) out += in_block ? ".fi\n" : ".PP\n.nf\n";
    if (!paragraph.verbatim) out += ".PP\n";
    in_block = paragraph.verbatim;
    out += escaped(paragraph.text) + '\n';
  }
  if (in_block) out += ".fi\n";
}

void put_option(std::string& out, const OptionText& option) {
  out += ".TP\n";
  for (std::size_t i = 0; i < option.names.size(); ++i) out += (i ? ", " : "") + bold(option.names[i]);
  if (!option.names.empty() && !option.value.empty()) out += ' ';
  if (!option.value.empty()) out += italic(option.value + (option.takes_many ? "..." : ""));
  out += '\n' + escaped(full_text(option)) + '\n';
}

void put_command(std::string& out, const CommandText& command) {
  out += ".SS " + bold("sinew " + command.name) + '\n' + escaped(command.summary) + '\n';
  put_paragraphs(out, command.details);
  out += ".PP\n" + escaped(command.usage()) + '\n';
  for (const OptionText& argument : command.arguments) put_option(out, argument);
  for (const OptionText& option : command.options) put_option(out, option);
}

}  // namespace

std::string man_page(const CLI::App& program) {
  const CommandText text = text_of(program);
  std::string out = ".TH SINEW 1 \"\" \"" + escaped(program.version()) + "\" \"User Commands\"\n.SH NAME\nsinew \\- ";
  out += escaped(text.summary) + "\n.SH SYNOPSIS\n.B sinew\n.I COMMAND\n[\\fIOPTIONS\\fR] ...\n.SH DESCRIPTION\n";
  put_paragraphs(out, text.details);
  for (const OptionText& option : text.options) put_option(out, option);
  out += ".SH COMMANDS\n";
  for (const CommandText& command : commands_of(program)) put_command(out, command);
  out += ".SH NOTES\n";
  put_paragraphs(out, text.ending);
  return out;
}

}  // namespace sinew::tool
