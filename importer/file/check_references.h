// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// The set of referenced list entries of a document. Lists are identified by address.
class ReferencedEntries {
 public:
  void mark(const void* list, std::size_t index) {
    std::vector<bool>& marks = marks_[list];
    if (marks.size() <= index) marks.resize(index + 1, false);
    marks[index] = true;
  }
  bool holds(const void* list, std::size_t index) const {
    const auto marks = marks_.find(list);
    return marks != marks_.end() && index < marks->second.size() && marks->second[index];
  }

 private:
  std::map<const void*, std::vector<bool>> marks_;
};

/// Verifies that every index refers to an existing entry and that the nodes form a forest, so that later code can index
/// without checks. Not recursive, so deep trees cannot overflow the stack.
/// err      reference, node-parents, node-cycle
/// warning  scene-root, accessor-empty
/// out      referenced   if not null: the entries referenced by core glTF members, not by extensions
/// cost     O(document)
void check_references(const gltf::Document& document, IssueLog& log, ReferencedEntries* referenced = nullptr);

}  // namespace sinew
