// SPDX-License-Identifier: MIT
#include "importer/tool/text_table.h"

#include <algorithm>

namespace sinew::tool {
namespace {

/// Number of characters in UTF-8 text: bytes that do not continue another one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

/// "12.5 kB" counts as a number; "1: 20" and "1, 2" are lists.
bool is_number(const std::string& cell) {
  if (cell.find_first_of(":,") != cell.npos) return false;
  const std::size_t first = cell.starts_with('-') ? 1 : 0;
  return cell.empty() || (cell.size() > first && cell[first] >= '0' && cell[first] <= '9');
}

struct Column {
  std::size_t width = 0;
  bool numbers = true, empty = true;
};

std::vector<Column> measure(const std::vector<std::vector<std::string>>& rows) {
  std::vector<Column> columns(rows.front().size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      columns[c].width = std::max(columns[c].width, width_of(rows[r][c]));
      if (r == 0) continue;
      columns[c].numbers = columns[c].numbers && is_number(rows[r][c]);
      columns[c].empty = columns[c].empty && rows[r][c].empty();
    }
  return columns;
}

}  // namespace

std::string TextTable::text() const {
  if (rows_.size() < 2) return {};
  const auto columns = measure(rows_);
  std::string out;
  for (const auto& row : rows_) {
    std::string line = " ";
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].empty) continue;
      const std::string padding(columns[c].width - width_of(row[c]), ' ');
      line += c == 0 ? " " : "  ";
      line += columns[c].numbers ? padding + row[c] : row[c] + padding;
    }
    line.resize(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

}  // namespace sinew::tool
