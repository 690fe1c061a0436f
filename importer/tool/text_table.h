// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace sinew::tool {

/// Rows of cells under a heading, printed with aligned columns: numbers to the right, other text to the left.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> heading) : rows_{std::move(heading)} {}

  /// Adds a row with as many cells as the heading has, in UTF-8.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// The table, indented by two. Columns that are empty in every row are left out; a table without rows is empty.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;  ///< the heading first
};

}  // namespace sinew::tool
