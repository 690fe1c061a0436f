// SPDX-License-Identifier: MIT
#include "runtime/base/shared_name.h"

#include <gtest/gtest.h>

#include "tests/support/allocation_counter.h"

namespace sinew {
namespace {

TEST(shared_name, copies_share_the_text_and_allocate_nothing) {
  const SharedName name(std::string(100, 'n'));
  const test::AllocationCounter allocations;
  const SharedName copy = name;
  EXPECT_EQ(allocations.count(), 0u);
  EXPECT_EQ(&copy.str(), &name.str());
  EXPECT_TRUE(copy == name);
}

TEST(shared_name, reads_as_the_string_it_was_made_of) {
  SharedName name;
  EXPECT_EQ(name.str(), "");
  EXPECT_TRUE(name == "");
  name = "lamp";
  const std::string& text = name;
  EXPECT_EQ(text, "lamp");
  EXPECT_TRUE(name == std::string("lamp"));
  EXPECT_FALSE(name == "lamps");
}

TEST(shared_name, of_a_copy_that_gets_another_text_the_first_keeps_its_own) {
  const SharedName lamp = "lamp";
  SharedName other = lamp;
  other = "eye";
  EXPECT_TRUE(lamp == "lamp");
  EXPECT_TRUE(other == "eye");
}

}  // namespace
}  // namespace sinew
