// SPDX-License-Identifier: MIT
#include "runtime/base/contract.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace sinew {
namespace {

void tell(const BrokenContract& broken) {
  std::fprintf(stderr, "the engine heard of '%s' in %s\n", broken.condition, broken.file);
}

void leave(const BrokenContract&) { std::_Exit(7); }

void throw_away(const BrokenContract&) { throw 7; }

/// Sets a contract handler for its lifetime.
class With {
 public:
  explicit With(ContractHandler handler) : before_(set_contract_handler(handler)) {}
  ~With() { set_contract_handler(before_); }
  With(const With&) = delete;
  With& operator=(const With&) = delete;

 private:
  ContractHandler before_;
};

TEST(contract, nothing_happens_where_it_holds) {
  const With handler(leave);
  CONTRACT(1 + 1 == 2);
}

TEST(contract, without_a_handler_the_condition_is_printed_and_the_program_ends) {
  EXPECT_EXIT(CONTRACT(1 + 1 == 3), testing::KilledBySignal(SIGABRT), "contract broken: 1 \\+ 1 == 3 .*contract_test");
}

TEST(contract, the_engines_handler_hears_of_it_and_the_program_ends_when_that_returns) {
  const With handler(tell);
  EXPECT_EXIT(CONTRACT(1 + 1 == 3), testing::KilledBySignal(SIGABRT),
              "the engine heard of '1 \\+ 1 == 3' in .*contract_test");
}

TEST(contract, a_handler_may_end_the_program_in_its_own_way_but_not_throw) {
  const With handler(leave);
  EXPECT_EXIT(CONTRACT(false), testing::ExitedWithCode(7), "");
  const With thrower(throw_away);
  EXPECT_EXIT(CONTRACT(false), testing::KilledBySignal(SIGABRT), "");
}

TEST(contract, a_handler_is_for_all_threads) {
  const With handler(leave);
  EXPECT_EXIT(std::thread([] { CONTRACT(false); }).join(), testing::ExitedWithCode(7), "");
}

TEST(contract, setting_a_handler_answers_the_one_before) {
  const ContractHandler before = set_contract_handler(tell);
  EXPECT_EQ(set_contract_handler(leave), &tell);
  EXPECT_EQ(set_contract_handler(nullptr), &leave);
  EXPECT_EQ(set_contract_handler(before), nullptr);
}

}  // namespace
}  // namespace sinew
