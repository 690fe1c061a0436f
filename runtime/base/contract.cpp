// SPDX-License-Identifier: MIT
#include "runtime/base/contract.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace sinew {
namespace {

std::atomic<ContractHandler> contract_handler{nullptr};

void print(const BrokenContract& broken) {
  std::fprintf(stderr, "sinew: contract broken: %s (%s:%d)\n", broken.condition, broken.file, broken.line);
}

}  // namespace

ContractHandler set_contract_handler(ContractHandler handler) noexcept {
  return contract_handler.exchange(handler, std::memory_order_acq_rel);
}

void detail::contract_failed(const char* condition, const char* file, int line) noexcept {
  const ContractHandler handler = contract_handler.load(std::memory_order_acquire);
  (handler != nullptr ? handler : print)({condition, file, line});
  std::abort();
}

}  // namespace sinew
