// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>

#include "importer/import_error.h"
#include "runtime/base/result.h"

namespace sinew::python {

/// A file that cannot be used. Python gets `sinew.FileError` with file, pointer, rule and all issues.
class FileFailure : public std::runtime_error {
 public:
  explicit FileFailure(ImportError error)
      : std::runtime_error(describe(error.file, error.issue)), error_(std::move(error)) {}
  const ImportError& error() const noexcept { return error_; }

 private:
  ImportError error_;
};

/// Throws std::invalid_argument, which becomes ValueError, unless the code is `ok`.
inline void require_ok(ErrorCode code, const char* call) {
  if (code != ErrorCode::ok) throw std::invalid_argument(std::string(call) + ": " + std::string(describe(code)));
}

/// Throws std::invalid_argument with this text unless `holds`.
inline void require(bool holds, const std::string& text) {
  if (!holds) throw std::invalid_argument(text);
}

}  // namespace sinew::python
