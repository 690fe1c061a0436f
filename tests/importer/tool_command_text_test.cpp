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

TEST_F(CommandTexts, explains_arguments_and_options_in_order) {
  using Row = std::pair<std::string, std::string>;
  EXPECT_THAT(option("--output").names, ElementsAre("-o", "--output"));
  std::vector<std::string> names;
  for (const Row& row : explained(command_, true)) names.push_back(row.first);
  for (const Row& row : explained(command_, false)) names.push_back(row.first);
  EXPECT_THAT(names, testing::IsSupersetOf({"FILE...", "LAST", "-o,--output OUT.png", "--quick"}));
  EXPECT_EQ(names.front(), "FILE...");
}

TEST_F(CommandTexts, only_an_argument_with_a_list_takes_many) {
  EXPECT_TRUE(option("FILE").takes_many());
  EXPECT_FALSE(option("LAST").takes_many());
  EXPECT_FALSE(option("--list").takes_many());
}

TEST_F(CommandTexts, choices_and_bare_values_are_named_once) {
  Command command("mix", "Mix");
  command.option("--oil", "KIND", &one_, "How: wet or dry").one_of({"wet", "dry", "oil"});
  command.option("--water", "KIND", &one_, "How: wet or dry").one_of({"wet", "dry"});
  command.option("--thick", "N", &one_, "How thick").bare("3");
  std::vector<std::string> texts;
  for (const auto& row : explained(command, false)) texts.push_back(row.second);
  EXPECT_THAT(texts, testing::IsSupersetOf({"How: wet or dry. One of: wet, dry, oil", "How: wet or dry",
                                            "How thick (without a value: 3)"}));
}

}  // namespace
}  // namespace sinew::tool
