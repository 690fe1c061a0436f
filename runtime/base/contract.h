// SPDX-License-Identifier: MIT
#pragma once

namespace sinew {

/// A rule that the calling program broke: the condition as the source has it, and where it is checked.
struct BrokenContract {
  const char* condition;
  const char* file;
  int line;
};

/// Is told of a broken contract before the program ends: logs it, writes a crash report, shows a message.
using ContractHandler = void (*)(const BrokenContract& broken);

/// Sets what is called when a contract is broken; nullptr = the default, which prints one line to stderr.
/// Contracts hold in every build and are about bugs of the program only: bad files and bad numbers answer codes.
/// Data after a broken contract cannot be trusted, so std::abort follows when the handler returns, and std::terminate
/// when it throws. A handler that must not end the process ends its thread or waits for ever.
/// The handler is the one variable of the library; everything else lives in objects of the caller.
/// in   handler  may be called on any thread that uses the library, on several at once
/// out  the handler before this one, nullptr = the default
/// Safe to call from any thread at any time: the handler is swapped atomically.
ContractHandler set_contract_handler(ContractHandler handler) noexcept;

namespace detail {
[[noreturn]] void contract_failed(const char* condition, const char* file, int line) noexcept;
}  // namespace detail

}  // namespace sinew

/// A bug of the program, not of its input: checked in every build, never used for file contents.
#define CONTRACT(condition) \
  ((condition) ? static_cast<void>(0) : ::sinew::detail::contract_failed(#condition, __FILE__, __LINE__))
