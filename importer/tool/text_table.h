// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace sinew::tool {

/// Rows of cells under a heading, as text with aligned columns: numbers to the right, others to the left.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> heading) : rows_{std::move(heading)} {}

  /// As many cells as the heading has; UTF-8.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// Indented by two; columns that are empty in every row are left out, and so is a table without rows.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;  ///< the heading first
};

}  // namespace sinew::tool
