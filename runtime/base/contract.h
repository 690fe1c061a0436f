// SPDX-License-Identifier: MIT
#pragma once

namespace sinew {

/// A broken contract: the text of the condition that was false, and where it is checked.
struct BrokenContract {
  const char* condition;
  const char* file;
  int line;
};

/// Called with the broken contract before the program ends, for example to log it or to write a crash report.
using ContractHandler = void (*)(const BrokenContract& broken);

/// Sets the function that is called when a contract is broken; nullptr = the default, which prints one line to stderr.
/// Contracts are checked in every build. They catch bugs of the calling program only: bad files and bad numbers return
/// error codes. Data cannot be trusted after a broken contract, so std::abort follows when the handler returns, and
/// std::terminate when it throws. A handler that must keep the process alive ends its thread or blocks for ever. The
/// handler is the only global variable of the library.
/// in   handler  may be called on any thread that uses the library, on several at the same time
/// out  the previous handler, nullptr = the default
/// Safe to call from any thread at any time: the handler is swapped atomically.
ContractHandler set_contract_handler(ContractHandler handler) noexcept;

namespace detail {
[[noreturn]] void contract_failed(const char* condition, const char* file, int line) noexcept;
}  // namespace detail

}  // namespace sinew

/// Ends the program when the condition is false. For bugs of the program, never for the contents of files.
#define CONTRACT(condition) \
  ((condition) ? static_cast<void>(0) : ::sinew::detail::contract_failed(#condition, __FILE__, __LINE__))
