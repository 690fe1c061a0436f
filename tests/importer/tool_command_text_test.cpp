// SPDX-License-Identifier: MIT
// What help, manual page and completions are made of, of a command with options of every kind.
#include "importer/tool/help/command_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace sinew::tool {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class CommandTexts : public testing::Test {
 protected:
  CommandTexts() : command_(*program_.add_subcommand("paint", "Paint files\nIn colours.\nTwice.")) {
    program_.footer("The end.");
    command_.set_help_flag();
    command_.add_option("FILE", many_, "What to paint")->required()->type_name("")->expected(1, -1);
    command_.add_option("LAST", one_, "Where to begin")->type_name("");
    command_.add_option("-o,--output", out_, "Where to")->required()->type_name("OUT.png");
    command_.add_option("--rule", rule_, "How")
        ->type_name("RULE")
        ->check(CLI::IsMember({"wet", "dry"}))
        ->default_str("wet");
    command_.add_option("--list", list_, "Some, by default none")
        ->type_name("A,B")
        ->delimiter(',')
        ->default_str("none");
    command_.add_option("--thick", thick_, "How thick")->type_name("[N]")->expected(0, 1)->default_str("3");
    command_.add_flag("--quick", quick_, "In a hurry");
    command_.add_option("--secret", rule_, "Nobody knows")->group("");
  }

  CommandText text() const { return text_of(command_); }
  const OptionText& option(const CommandText& of, const std::string& name) const {
    for (const OptionText& o : of.options)
      if (o.names.back() == name) return o;
    throw std::runtime_error("no option " + name);
  }

  CLI::App program_{"All there is", "sinew"};
  CLI::App& command_;
  std::vector<std::string> many_, list_;
  std::string one_, out_, rule_, thick_;
  bool quick_ = false;
};

TEST_F(CommandTexts, first_line_is_the_summary) {
  const CommandText of = text();
  EXPECT_EQ(of.name, "paint");
  EXPECT_EQ(of.summary, "Paint files");
  EXPECT_EQ(of.details, "In colours.\nTwice.");
  EXPECT_EQ(of.ending, "") << "that of the program alone";
  EXPECT_EQ(text_of(program_).ending, "The end.");
  EXPECT_EQ(text_of(program_).details, "");
  EXPECT_EQ(commands_of(program_).size(), 1u);
}

TEST_F(CommandTexts, usage_has_arguments_and_the_options_that_are_needed) {
  EXPECT_EQ(text().usage(), "sinew paint [OPTIONS] FILE... [LAST] -o OUT.png");
}

TEST_F(CommandTexts, arguments) {
  const CommandText of = text();
  ASSERT_EQ(of.arguments.size(), 2u);
  const OptionText &file = of.arguments[0], &last = of.arguments[1];
  EXPECT_EQ(file.value, "FILE");
  EXPECT_TRUE(file.is_required && file.takes_many && file.names_path);
  EXPECT_EQ(last.value, "LAST");
  EXPECT_FALSE(last.is_required || last.takes_many || last.names_path);
  EXPECT_EQ(names_and_value(file), "FILE...");
  EXPECT_EQ(names_and_value(last), "LAST");
}

TEST_F(CommandTexts, options) {
  const CommandText of = text();
  ASSERT_EQ(of.options.size(), 5u) << "what is hidden is left out";
  const OptionText& output = option(of, "--output");
  EXPECT_THAT(output.names, ElementsAre("-o", "--output"));
  EXPECT_EQ(output.value, "OUT.png");
  EXPECT_TRUE(output.is_required && output.names_path);
  EXPECT_FALSE(output.takes_many || output.is_list || output.value_is_optional);
  EXPECT_EQ(names_and_value(output), "-o,--output OUT.png");
  const OptionText& rule = option(of, "--rule");
  EXPECT_EQ(rule.value, "RULE");
  EXPECT_THAT(rule.choices, testing::UnorderedElementsAre("wet", "dry"));
  EXPECT_EQ(rule.about, "How (default: wet)");
  EXPECT_THAT(full_text(rule),
              testing::AnyOf("How (default: wet). One of: wet, dry", "How (default: wet). One of: dry, wet"));
  const OptionText& list = option(of, "--list");
  EXPECT_TRUE(list.is_list);
  EXPECT_FALSE(list.is_required || list.takes_many || list.names_path);
  EXPECT_EQ(list.value, "A,B");
  EXPECT_THAT(list.choices, IsEmpty());
  EXPECT_EQ(list.about, "Some, by default none") << "it names its default";
  EXPECT_EQ(full_text(list), list.about);
  const OptionText& thick = option(of, "--thick");
  EXPECT_TRUE(thick.value_is_optional);
  EXPECT_EQ(thick.about, "How thick (without a value: 3)");
  const OptionText& quick = option(of, "--quick");
  EXPECT_EQ(quick.value, "");
  EXPECT_FALSE(quick.value_is_optional || quick.is_required || quick.names_path);
  EXPECT_EQ(names_and_value(quick), "--quick");
}

TEST_F(CommandTexts, choices_that_the_text_names_are_not_listed_again) {
  OptionText option;
  option.about = "How: wet or dry";
  option.choices = {"wet", "dry"};
  EXPECT_EQ(full_text(option), "How: wet or dry");
  option.choices.emplace_back("oil");
  EXPECT_EQ(full_text(option), "How: wet or dry. One of: wet, dry, oil");
  option.value = "oil";
  EXPECT_EQ(full_text(option), "How: wet or dry");
}

}  // namespace
}  // namespace sinew::tool
