// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace sinew::tool {

/// One file and the command that runs on it.
struct Unit {
  std::string name;                ///< path of the file below the folder or manifest that named it
  std::string path;                ///< path of the file
  std::vector<std::string> words;  ///< command and arguments, with paths filled in
  std::string id;                  ///< hash of all that the result depends on (id_of); 16 hexadecimal digits
};

/// Splits a command as a shell does: at blanks, with "..." and '...' around words that hold some.
/// err  a quotation mark without its partner
tl::expected<std::vector<std::string>, std::string> split_words(const std::string& command);

/// Lists the units of a folder, of a manifest, or of one model. A folder stands for its models, sorted by name, and for
/// those of its folders. A manifest is a text file with a path in each line, relative to its own folder. Lines that are
/// empty or begin with # do not count.
/// in   command  words; {in} stands for the file, {out} for a path below `out` without an extension, {name} for the
///               file's name without its extension
/// err  a sentence for the user: an input that cannot be read, two files with one output
tl::expected<std::vector<Unit>, std::string> list_units(const std::string& input,
                                                        const std::vector<std::string>& command,
                                                        const std::filesystem::path& out);

/// Hashes what the result of a unit depends on: the version of sinew, the command, the file, and the files that it
/// names. For `verify`, `check`, `info` and `plan` also the files that the command names, such as goldens.
/// in   command  words before paths were filled in
/// out  empty if the file cannot be read; running the unit then says why
std::string id_of(const Unit& unit, const std::vector<std::string>& command);

}  // namespace sinew::tool
