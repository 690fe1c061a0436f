// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "importer/graph/graph_text.h"
#include "importer/graph/program_text.h"
#include "importer/graph/schema_reader.h"

namespace sinew {
namespace {

/// Deepest nesting of objects and lists in JSON text.
std::size_t json_depth(std::string_view text) {
  std::size_t depth = 0, deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (in_text && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      in_text = !in_text;
    else if (!in_text && (text[i] == '{' || text[i] == '['))
      deepest = std::max(deepest, ++depth);
    else if (!in_text && (text[i] == '}' || text[i] == ']') && depth > 0)
      --depth;
  }
  return deepest;
}

/// Reads a document of a known version from JSON text.
template <class Document>
GraphTextResult<Document> read_document(std::string_view text, const char* version_key, std::int32_t known) {
  constexpr std::size_t kMostDepth = 64;
  if (json_depth(text) > kMostDepth) return tl::make_unexpected(GraphTextFault{"", "is nested more than 64 deep"});
  const nlohmann::json all = nlohmann::json::parse(text, nullptr, false);
  if (!all.is_object()) return tl::make_unexpected(GraphTextFault{"", "is no JSON object"});
  const JsonPath root;
  SchemaReader reader(version_key);
  std::int32_t version = 0;
  if (!all.contains(version_key))
    reader.fail(root, std::string("has no \"") + version_key + "\", the version of the format");
  else
    reader.read(all[version_key], {&root, version_key}, version);
  if (!reader.failed && version != known) reader.fail({&root, version_key}, "is a version that is not known");
  Document document;
  if (!reader.failed) reader.read(all, root, document);
  if (reader.failed) return tl::make_unexpected(reader.fault);
  return document;
}

}  // namespace

GraphTextResult<GraphDocument> read_graph(std::string_view text) {
  return read_document<GraphDocument>(text, "graph", graph_schema::kVersion);
}

GraphTextResult<ProgramDocument> read_program(std::string_view text) {
  return read_document<ProgramDocument>(text, "program", graph_schema::kProgramVersion);
}

GraphTextResult<TraceDocument> read_trace(std::string_view text) {
  return read_document<TraceDocument>(text, "trace", graph_schema::kTraceVersion);
}

}  // namespace sinew
