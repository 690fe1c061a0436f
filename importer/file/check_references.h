// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// The entries of the lists of a document that something refers to. A list is known by its address.
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

/// Proves that every index of the document names an existing entry and that the nodes form a forest, so that later code
/// can index without checks (T1, G55). It does not recurse, so deep trees are no problem.
/// err      reference, node-parents, node-cycle
/// warning  scene-root, accessor-empty
/// out      referenced   where not null: what glTF's own members refer to, those of extensions not
/// cost     O(document)
void check_references(const gltf::Document& document, IssueLog& log, ReferencedEntries* referenced = nullptr);

}  // namespace sinew
