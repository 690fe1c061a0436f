// SPDX-License-Identifier: MIT
// The description of a command with options of every kind, and the texts that are made from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "importer/tool/command.h"
#include "importer/tool/help/help.h"

namespace sinew::tool {
namespace {

using testing::ElementsAre;

class CommandTexts : public testing::Test {
 protected:
  CommandTexts() {
    command_.argument("FILE", &many_, "What to paint").required();
    command_.argument("LAST", &one_, "Where to begin");
    command_.option("-o,--output", "OUT.png", &out_, "Where to").required();
    command_.option("--rule", "RULE", &rule_, "How (default: wet)").one_of({"wet", "dry"});
    command_.option("--list", "A,B", &list_, "Some, by default none").list();
    command_.option("--thick", "[N]", &thick_, "How thick").bare("3");
    command_.flag("--quick", quick_, "In a hurry");
  }

  const Option& option(const std::string& name) const {
    for (const Option& o : command_.options)
      if (!o.is_argument() ? o.names.back() == name : o.value == name) return o;
    throw std::runtime_error("no option " + name);
  }

  Command command_{"paint", "Paint files\nIn colours.\nTwice."};
  std::vector<std::string> many_, list_;
  std::string one_, out_, rule_, thick_;
  bool quick_ = false;
};

TEST_F(CommandTexts, first_line_is_the_summary) {
  EXPECT_EQ(command_.name, "paint");
  EXPECT_EQ(command_.summary, "Paint files");
  EXPECT_EQ(command_.details, "In colours.\nTwice.");
  EXPECT_EQ(Command("", "All there is").details, "");
}

TEST_F(CommandTexts, usage_has_arguments_and_the_options_that_are_needed) {
  EXPECT_EQ(usage(command_), "sinew paint [OPTIONS] FILE... [LAST] -o OUT.png");
}

TEST_F(CommandTexts, names_and_values) {
  EXPECT_EQ(names_and_value(option("FILE")), "FILE...");
  EXPECT_EQ(names_and_value(option("LAST")), "LAST");
  EXPECT_THAT(option("--output").names, ElementsAre("-o", "--output"));
  EXPECT_EQ(names_and_value(option("--output")), "-o,--output OUT.png");
  EXPECT_EQ(names_and_value(option("--quick")), "--quick");
}

TEST_F(CommandTexts, only_an_argument_with_a_list_takes_many) {
  EXPECT_TRUE(option("FILE").takes_many());
  EXPECT_FALSE(option("LAST").takes_many());
  EXPECT_FALSE(option("--list").takes_many());
}

TEST_F(CommandTexts, the_name_of_a_value_tells_paths) {
  EXPECT_TRUE(is_path(option("FILE")) && is_path(option("--output")));
  EXPECT_FALSE(is_path(option("LAST")) || is_path(option("--list")) || is_path(option("--quick")));
}

TEST_F(CommandTexts, choices_and_bare_values_are_named_once) {
  EXPECT_EQ(full_text(option("--rule")), "How (default: wet). One of: wet, dry");
  EXPECT_EQ(full_text(option("--thick")), "How thick (without a value: 3)");
  Option how;
  how.about = "How: wet or dry";
  how.choices = {"wet", "dry"};
  EXPECT_EQ(full_text(how), "How: wet or dry");
  how.choices.emplace_back("oil");
  EXPECT_EQ(full_text(how), "How: wet or dry. One of: wet, dry, oil");
  how.value = "oil";
  EXPECT_EQ(full_text(how), "How: wet or dry");
}

}  // namespace
}  // namespace sinew::tool
