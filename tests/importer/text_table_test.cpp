// SPDX-License-Identifier: MIT
#include "importer/tool/text_table.h"

#include <gtest/gtest.h>

namespace sinew::tool {
namespace {

TEST(text_table, aligns_numbers_to_the_right_and_other_text_to_the_left) {
  TextTable table({"name", "count", "size", "list"});
  table.add({"a", "-1", "12.5 kB", "1, 2"});
  table.add({"longer", "-234", "3 B", "1: 20"});
  table.add({"c", "", "", "x"});
  EXPECT_EQ(table.text(),
            "  name    count     size  list\n"
            "  a          -1  12.5 kB  1, 2\n"
            "  longer   -234      3 B  1: 20\n"
            "  c                       x\n");
}

TEST(text_table, a_column_with_one_word_is_text) {
  TextTable table({"n", "x"});
  table.add({"100", "-"});
  table.add({"7", "1"});
  table.add({"-b", "2"});
  EXPECT_EQ(table.text(),
            "  n    x\n"
            "  100  -\n"
            "  7    1\n"
            "  -b   2\n");
}

TEST(text_table, leaves_out_empty_columns_and_tables_without_rows) {
  TextTable table({"a", "b", "c"});
  EXPECT_EQ(table.text(), "");
  table.add({"1", "", "3"});
  EXPECT_EQ(table.text(),
            "  a  c\n"
            "  1  3\n");
}

TEST(text_table, counts_letters_of_more_than_one_byte_once) {
  TextTable table({"µ", "x"});
  table.add({"äöü", "1"});
  table.add({"ab", "2"});
  EXPECT_EQ(table.text(),
            "  µ    x\n"
            "  äöü  1\n"
            "  ab   2\n");
}

}  // namespace
}  // namespace sinew::tool
