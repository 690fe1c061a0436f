// SPDX-License-Identifier: MIT
#pragma once
/// Errors. A bad call or a bad number returns an ErrorCode, or a Result: a value or an ErrorCode. A reader of files
/// returns an error type of its own, which names the place in the file. A bug of the program breaks a contract: a
/// handler is called, then the program ends.
///
///     const sinew::ErrorCode code = run_plan(plan, input, frame);
///     if (code != sinew::ErrorCode::ok) log(describe(code));
#include <tl/expected.hpp>

#include "runtime/base/contract.h"
#include "runtime/base/result.h"
