// SPDX-License-Identifier: MIT
// Help, manual page and completions are made of one text, and each of them says all of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>

#include "importer/tool/help/help.h"
#include "importer/tool/wrapped_text.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The first words of the lines of a section of a help, which ends with an empty line.
std::vector<std::string> first_words(const std::string& help, const std::string& section) {
  std::vector<std::string> words;
  bool inside = false;
  for (const std::string& line : lines_of(help)) {
    if (line == section + ":") inside = true;
    if (line.empty()) inside = false;
    if (inside && line.size() > 2 && line.starts_with("  ") && line[2] != ' ')
      words.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return words;
}

std::vector<std::string> commands() { return first_words(run_tool({"--help"}).out, "Commands"); }

/// The names of all options of a command: "-o,--output" are two.
std::vector<std::string> options_of(const std::string& command) {
  std::vector<std::string> names;
  for (std::string names_of_one : first_words(run_tool({command, "--help"}).out, "Options")) {
    std::replace(names_of_one.begin(), names_of_one.end(), ',', '\n');
    for (const std::string& name : lines_of(names_of_one)) names.push_back(name);
  }
  return names;
}

tool::Program program_about(const std::string& about, const std::string& ending = "") {
  return {tool::Command("", about), "sinew 1.2.3", ending, {}};
}

TEST(man_page, writes_characters_that_are_commands_of_roff_as_themselves) {
  EXPECT_THAT(tool::man_page(program_about("Reads C:\\files - all of them")),
              HasSubstr("sinew \\- Reads C:\\efiles \\- all of them\n"));
}

TEST(wrapped_text, flows_words_and_keeps_lines_that_begin_with_a_space) {
  EXPECT_EQ(tool::wrapped("a b\nc", 2, 2), "a b c");
  EXPECT_EQ(tool::wrapped("a\n\nb", 2, 2), "a\n\n  b");
  EXPECT_EQ(tool::wrapped("a\n   as   it is\nb", 0, 0), "a\n   as   it is\nb");
  const std::string word(30, 'x');
  EXPECT_EQ(tool::wrapped(word + ' ' + word + ' ' + word + ' ' + word, 4, 10),
            word + ' ' + word + '\n' + "    " + word + ' ' + word);
  EXPECT_EQ(tool::wrapped("a\n\n" + word + ' ' + word + ' ' + word + ' ' + word, 4, 70),
            "a\n\n    " + word + ' ' + word + ' ' + word + '\n' + "    " + word)
      << "where a paragraph begins does not count for the next";
  const std::string endless(150, 'x');
  EXPECT_EQ(tool::wrapped("a " + endless, 0, 0), "a\n" + endless);
}

TEST(help, no_line_is_wider_than_100_columns_and_none_ends_in_spaces) {
  std::vector<std::vector<std::string>> helps{{"--help"}};
  for (const std::string& command : commands()) helps.push_back({command, "--help"});
  ASSERT_GE(helps.size(), 9u);
  for (const auto& arguments : helps) {
    const CommandOutcome help = run_tool(arguments);
    EXPECT_EQ(help.status, 0);
    EXPECT_THAT(help.err, IsEmpty());
    for (const std::string& line : lines_of(help.out)) {
      EXPECT_LE(line.size(), 100u) << arguments[0] << ": " << line;
      EXPECT_FALSE(line.ends_with(' ')) << arguments[0] << ": " << line;
    }
  }
}

TEST(help, has_columns_as_wide_as_the_widest_name_that_is_not_too_wide) {
  tool::Command command("thing", "Does a thing.");
  std::string value;
  command.argument("FILE", &value, "Which one.");
  command.option("-o,--output", "OUT", &value, "Where it goes.");
  command.option("--with-a-name-of-27-letters", "", &value, "Too wide.");
  command.option("--with-a-name-of-26-letter", "", &value, "Just wide enough.");
  const std::string text = tool::help_text(command);
  EXPECT_THAT(lines_of(text), Contains("  FILE  Which one."));
  EXPECT_THAT(lines_of(text), Contains("  -o,--output OUT             Where it goes."));
  EXPECT_THAT(lines_of(text), Contains("  --with-a-name-of-26-letter  Just wide enough."));
  EXPECT_THAT(lines_of(text), Contains("  --with-a-name-of-27-letters"));
  EXPECT_THAT(lines_of(text), Contains("                              Too wide."));
}

TEST(help, begins_with_lines_that_use_the_whole_width) {
  const std::string line = "a hundred letters " + std::string(82, 'x');
  const std::string about = line + " and more\n" + line + " and details";
  const std::string text = tool::help_text(tool::Command("thing", about));
  EXPECT_EQ(lines_of(text).at(0), line);
  EXPECT_EQ(lines_of(text).at(1), "and more");
  EXPECT_EQ(lines_of(text).at(3), line);
  EXPECT_EQ(lines_of(text).at(4), "and details");
  const std::string whole = tool::help_text(program_about("x\n" + line + " and details", line + " and an ending"));
  EXPECT_THAT(lines_of(whole), Contains(line).Times(2));
  EXPECT_EQ(lines_of(whole).back(), "and an ending");
}

TEST(help, has_a_line_for_each_command_and_everything_about_one_in_its_own) {
  const std::string help = run_tool({"--help"}).out;
  EXPECT_LE(lines_of(help).size(), 44u) << "fits a screen";
  std::size_t at = 0;
  for (const std::string& line : lines_of(help)) {
    if (line == "Commands:") at = 1;
    if (at == 0 || line == "Commands:") continue;
    if (line.empty()) break;
    EXPECT_NE(line[2], ' ') << "one line: " << line;
    ++at;
  }
  EXPECT_EQ(at, commands().size() + 1);
  for (const std::string& command : commands()) {
    const std::string own = run_tool({command, "--help"}).out;
    EXPECT_THAT(own, HasSubstr("Usage: sinew " + command + " [OPTIONS]"));
    EXPECT_THAT(first_words(own, "Options"), testing::Contains("-h,--help")) << command;
    EXPECT_THAT(own, Not(HasSubstr("Examples:"))) << command << ": of the program";
    EXPECT_THAT(own, Not(HasSubstr("TEXT"))) << command << ": a value without a name";
    EXPECT_THAT(own, Not(HasSubstr("FLOAT"))) << command;
  }
}

TEST(help, says_what_an_option_takes_and_what_happens_without_it) {
  const std::string help = run_tool({"sample", "--help"}).out;
  EXPECT_THAT(help, HasSubstr("Usage: sinew sample [OPTIONS] FILE"));
  EXPECT_THAT(help, HasSubstr("  -o,--output OUT "));
  EXPECT_THAT(help, HasSubstr("  --clip INDEX|NAME|none"));
  const std::string plan = run_tool({"plan", "--help"}).out;
  EXPECT_THAT(plan, HasSubstr("One of: "));
  EXPECT_THAT(plan, HasSubstr("hidden-meshes"));
  EXPECT_THAT(run_tool({"bake", "--help"}).out, HasSubstr("(default: 30)"));
  for (const char* command : {"compile", "bake", "convert", "verify", "plan"}) {
    std::string text = run_tool({command, "--help"}).out;
    std::replace(text.begin(), text.end(), '\n', ' ');
    text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == ' ' && b == ' '; }), text.end());
    EXPECT_THAT(text, HasSubstr("0.01% (of the model's size)")) << command;
  }
}

TEST(help, hides_options_for_the_build_and_for_shells) {
  EXPECT_THAT(run_tool({"--help"}).out, Not(testing::AnyOf(HasSubstr("--man-page"), HasSubstr("--complete"))));
}

/// The words that shells offer in place of the last one.
std::vector<std::string> candidates(std::vector<std::string> words) {
  words.insert(words.begin(), "--complete");
  std::vector<std::string> out;
  for (const std::string& line : lines_of(run_tool(words).out)) out.push_back(line.substr(0, line.find('\t')));
  return out;
}

TEST(completion, offers_every_option_of_every_command) {
  EXPECT_THAT(candidates({""}), testing::IsSupersetOf(commands()));
  for (const std::string& command : commands()) {
    EXPECT_GE(options_of(command).size(), 2u);
    EXPECT_THAT(candidates({command, "--"}), testing::IsSubsetOf(options_of(command)));
    EXPECT_THAT(candidates({command, "-"}), testing::UnorderedElementsAreArray(options_of(command)));
  }
}

TEST(completion, offers_choices_of_options_and_says_what_options_do) {
  EXPECT_THAT(candidates({"sample", "x.glb", "--format", "n"}), ElementsAre("npy", "npz"));
  EXPECT_THAT(candidates({"plan", "x.glb", "--needs", "joints,pal"}), ElementsAre("joints,palettes"));
  EXPECT_THAT(run_tool({"--complete", "sample", "--ver"}).out, testing::MatchesRegex("--vertices\t.+\n"));
}

TEST(completion, leaves_files_and_unknown_commands_to_the_shell) {
  EXPECT_THAT(candidates({"info", "fo"}), IsEmpty());
  EXPECT_THAT(candidates({"sample", "x.glb", "-o", "-"}), IsEmpty());
  EXPECT_THAT(candidates({"nothing", "-"}), IsEmpty());
  EXPECT_THAT(candidates({}), IsEmpty());
}

TEST(shell_files, the_manual_has_the_text_of_the_help) {
  const std::string man = run_tool({"--man-page"}).out;
  const auto plain = [](std::string text) {
    std::string out;
    for (const char c : text)
      if (c != '\\' && c != '\n' && c != ' ') out += c;
    return out;
  };
  EXPECT_THAT(plain(man), HasSubstr(plain("Everything that the file says is carried: extras, extensions")));
  const std::size_t at = man.find(".SS \\fBsinew convert");
  ASSERT_NE(at, man.npos);
  const std::string part = man.substr(at, man.find(".SS ", at + 1) - at);
  EXPECT_THAT(part, HasSubstr("\n.B \\-\\-budget ")) << "an option and its value are two words";
  for (const std::string& option : options_of("convert")) EXPECT_THAT(plain(part), HasSubstr(option));
  std::size_t begun = 0, ended = 0;
  for (const std::string& line : lines_of(man)) {
    begun += line == ".nf";
    ended += line == ".fi";
    EXPECT_TRUE(begun == ended || begun == ended + 1) << "blocks of lines end before the next one";
  }
  EXPECT_EQ(begun, ended);
  EXPECT_GT(begun, 0u);
  EXPECT_THAT(part, HasSubstr(".PP\nEverything that the file says")) << "a paragraph of its own";
}

bool is_installed(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// Output of a shell command, both streams together; its status must be 0.
std::string printed(const ToolModelFile& folder, const std::string& command) {
  const std::string out = folder.beside("printed");
  EXPECT_EQ(std::system(("( " + command + " ) >" + out + " 2>&1").c_str()), 0) << command;
  std::ifstream stream(out);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The command that makes a shell find this build of sinew.
const std::string kPath = "PATH=" SINEW_TOOL_FOLDER ":$PATH; export PATH; ";
const std::string kShells = SINEW_SHELL_FILES;

TEST(shell_files, roff_takes_the_manual_page_without_a_warning) {
  if (!is_installed("groff")) GTEST_SKIP() << "no groff";
  const ToolModelFile folder;
  const std::string page = folder.beside("sinew.1");
  std::ofstream(page) << run_tool({"--man-page"}).out;
  EXPECT_EQ(printed(folder, "groff -man -ww -z -Tutf8 " + page), "");
  const std::string text = printed(folder, "groff -man -Tascii -P-cbou " + page);
  for (const char* words : {"SINEW(1)", "NAME", "SYNOPSIS", "--output", "sinew sample"})
    EXPECT_THAT(text, HasSubstr(words));
}

/// Bash's completions of the last word of a command line.
std::vector<std::string> offered(const ToolModelFile& folder, const std::string& words) {
  std::string text = printed(folder, kPath + "bash -c 'source " + kShells + "/sinew.bash; COMP_WORDS=(" + words +
                                         "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _sinew; printf \"%s\\n\" "
                                         "\"${COMPREPLY[@]}\"'");
  return lines_of(text);
}

TEST(shell_files, bash_completes_commands_options_and_values) {
  const ToolModelFile folder;
  EXPECT_THAT(offered(folder, "sinew co"), testing::IsSupersetOf({"convert", "compile"}));
  EXPECT_THAT(offered(folder, "sinew sample --ver"), ElementsAre("--vertices"));
  EXPECT_THAT(offered(folder, "sinew sample x.glb --format n"), ElementsAre("npy", "npz"));
  EXPECT_THAT(offered(folder, "sinew plan x.glb --needs joints,pal"), ElementsAre("joints,palettes"));
  EXPECT_THAT(offered(folder, "sinew info fo"), ElementsAre("")) << "bash itself completes files then";
  EXPECT_THAT(offered(folder, "sinew sample x.glb -o ou"), ElementsAre(""));
}

/// Zsh's list after Tab, in an interactive shell on its own terminal. It is ready for keys once it edits a line:
/// before, the terminal is not raw and takes them itself.
std::string listed_by_zsh(const ToolModelFile& folder, const std::string& words) {
  const std::string script = folder.beside("tab.zsh");
  std::ofstream(script) << R"(zmodload zsh/zpty
zpty tab zsh -f -i
zpty -w tab 'PS1=; TERM=dumb; unsetopt zle_bracketed_paste prompt_cr prompt_sp; stty -echo cols 200 rows 500'
zpty -w tab "fpath=($1 \$fpath); autoload -U compinit; compinit -D -u; LISTMAX=0"
zpty -w tab 'tab() { zle list-choices; zle -R; print -n "li""sted" }; zle -N tab; bindkey "^I" tab'
zpty -w tab 'zle-line-init() { print -n "rea""dy" }; zle -N zle-line-init'
zpty -r tab before '*ready*'
zpty -w -n tab "$2"$'\t'
zpty -r tab listed '*listed*'
print -r -- $listed
zpty -d tab
)";
  const std::string shown =
      printed(folder, kPath + "timeout 600 zsh -f " + script + " " + kShells + " '" + words + "' </dev/null");
  const std::size_t first = shown.find(words), again = shown.find(words, first + 1);  // as they were typed, drawn again
  EXPECT_NE(first, shown.npos) << shown;
  if (first == shown.npos || again == shown.npos) return {};
  return shown.substr(first + words.size(), again - first - words.size());
}

TEST(shell_files, zsh_completes_commands_options_values_and_files) {
  if (!is_installed("zsh")) GTEST_SKIP() << "no zsh";
  const ToolModelFile folder;
  EXPECT_EQ(printed(folder, "zsh -n " + kShells + "/_sinew"), "");
  const std::string all = listed_by_zsh(folder, "sinew ");
  for (const std::string& command : commands()) EXPECT_THAT(all, HasSubstr("\n" + command + " "));
  const std::string option = listed_by_zsh(folder, "sinew sample --v");
  EXPECT_THAT(option, HasSubstr("--vertices"));
  EXPECT_THAT(option, Not(HasSubstr("--version")));
  const std::string values = listed_by_zsh(folder, "sinew sample x.glb --format n");
  EXPECT_THAT(values, HasSubstr("npy  npz"));
  EXPECT_THAT(values, Not(HasSubstr("csv")));
  EXPECT_THAT(listed_by_zsh(folder, "sinew plan x.glb --needs joints,p"), HasSubstr("palettes"));
  const std::string model = listed_by_zsh(folder, "sinew info " + folder.beside("mod"));
  EXPECT_THAT(model, HasSubstr("model.gltf"));
  EXPECT_THAT(listed_by_zsh(folder, "sinew sample x.glb -o " + folder.beside("mod")), HasSubstr("model.gltf"));
}

TEST(shell_files, fish_completes_commands_and_values) {
  if (!is_installed("fish")) GTEST_SKIP() << "no fish";
  const ToolModelFile folder;
  EXPECT_EQ(printed(folder, "fish --no-execute " + kShells + "/sinew.fish"), "");
  const std::string values = printed(folder, kPath + "fish --no-config -c 'source " + kShells +
                                                 "/sinew.fish; complete -C \"sinew sample --format \"'");
  for (const char* format : {"json", "csv", "npy", "npz"}) EXPECT_THAT(values, HasSubstr(format));
  const std::string commands_of_fish =
      printed(folder, kPath + "fish --no-config -c 'source " + kShells + "/sinew.fish; complete -C \"sinew \"'");
  for (const std::string& command : commands()) EXPECT_THAT(commands_of_fish, HasSubstr(command));
}

}  // namespace
}  // namespace sinew::test
