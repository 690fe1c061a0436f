// SPDX-License-Identifier: MIT
#include "importer/tool/batch/captured_output.h"

#include "runtime/base/contract.h"

namespace sinew::tool {
namespace {
thread_local CapturedOutput* current_output = nullptr;
}

CapturedOutput::CapturedOutput() {
  CONTRACT(current_output == nullptr);
  current_output = this;
}

CapturedOutput::~CapturedOutput() { current_output = nullptr; }

CapturedOutput* CapturedOutput::current() noexcept { return current_output; }

}  // namespace sinew::tool
