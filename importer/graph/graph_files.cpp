// SPDX-License-Identifier: MIT
#include "importer/graph/graph_files.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "importer/graph/json_path.h"
#include "importer/platform/files.h"

namespace sinew {
namespace {

constexpr std::uintmax_t kMostBytes = 16u << 20;
constexpr std::size_t kMostReferences = 1000;

/// Reads a graph file, and for each of its references the file that it names.
class FileReader {
 public:
  std::string fault;
  std::vector<std::string> files;

  std::optional<JoinedGraph> read(const std::string& file) {
    auto document = read_graph_alone(file);
    if (!document) return refuse(document.error());
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
    JoinedGraph joined{std::move(*document), {}};
    open_.push_back(identity_of(file));
    std::vector<std::string> references;
    for (const auto& [name, node] : joined.document.nodes)
      if (node.kind == GraphDocument::NodeKind::graph) references.push_back(name);
    for (const std::string& name : references)
      if (!follow(joined, name, file)) return std::nullopt;
    open_.pop_back();
    return joined;
  }

 private:
  static std::filesystem::path identity_of(const std::string& file) {
    std::error_code error;
    const std::filesystem::path path = platform::path_of(file), whole = std::filesystem::weakly_canonical(path, error);
    return error ? path : whole;
  }

  std::nullopt_t refuse(std::string sentence) {
    fault = std::move(sentence);
    return std::nullopt;
  }

  bool follow(JoinedGraph& joined, const std::string& name, const std::string& file) {
    const auto refused = [&](const std::string& sentence) {
      const JsonPath root, nodes(&root, "nodes"), node(&nodes, name);
      refuse(fault_text(file, {JsonPath(&node, "file").text(), sentence}));
      return false;
    };
    const std::string& named = joined.document.nodes.at(name).file;
    const std::string other = platform::text_of(platform::path_of(file).parent_path() / platform::path_of(named));
    const auto at = std::find(open_.begin(), open_.end(), identity_of(other));
    if (at != open_.end()) {
      std::string chain;
      for (auto i = at; i != open_.end(); ++i) chain += platform::text_of(i->filename()) + " refers to ";
      return refused("graphs that refer to themselves: " + chain + platform::text_of(at->filename()));
    }
    if (++references_ > kMostReferences) return refused("more than 1,000 graphs are referred to");
    const auto inner = read(other);
    if (!inner) return false;
    if (const auto join_fault = join_graph(joined, name, *inner, other)) {
      refuse(fault_text(file, *join_fault));
      return false;
    }
    return true;
  }

  std::vector<std::filesystem::path> open_;  // from the first file to the one that is being read
  std::size_t references_ = 0;
};

}  // namespace

std::string fault_text(const std::string& file, const GraphTextFault& fault) {
  return file + ": " + (fault.json_pointer.empty() ? "" : fault.json_pointer + ": ") + fault.sentence;
}

tl::expected<std::string, std::string> read_json_file(const std::string& file) {
  const std::filesystem::path path = platform::path_of(file);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return tl::unexpected(file + ": is no file");
  if (std::filesystem::file_size(path, error) > kMostBytes) return tl::unexpected(file + ": is larger than 16 MB");
  std::ifstream stream{path, std::ios::binary};
  if (!stream) return tl::unexpected(file + ": cannot be read");
  return std::string{std::istreambuf_iterator<char>(stream), {}};
}

tl::expected<GraphDocument, std::string> read_graph_alone(const std::string& file) {
  const auto text = read_json_file(file);
  if (!text) return tl::unexpected(text.error());
  auto document = read_graph(*text);
  if (!document) return tl::unexpected(fault_text(file, document.error()));
  return std::move(*document);
}

tl::expected<GraphOfFiles, std::string> read_graph_files(const std::string& file) {
  FileReader reader;
  auto joined = reader.read(file);
  if (!joined) return tl::unexpected(reader.fault);
  return GraphOfFiles{std::move(*joined), std::move(reader.files)};
}

std::string GraphOfFiles::text_of(const GraphTextFault& fault) const {
  const std::string& pointer = fault.json_pointer;
  const std::size_t list = pointer.find('/', 1);
  const std::size_t end = list == pointer.npos ? pointer.size() : std::min(pointer.find('/', list + 1), pointer.size());
  const auto found = joined.origins.find(pointer.substr(0, end));
  if (found == joined.origins.end()) return fault_text(files.front(), fault);
  return fault_text(found->second.file, {found->second.json_pointer + pointer.substr(end), fault.sentence});
}

}  // namespace sinew
