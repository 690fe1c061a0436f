// SPDX-License-Identifier: MIT
#include "importer/tool/cost/run_beside.h"

#include <system_error>

#include "importer/platform/program.h"

namespace sinew::cost {

tl::expected<std::string, std::string> output_of_program_beside(const std::string& program,
                                                                const std::vector<std::string>& arguments) {
  std::error_code error;
  const std::filesystem::path folder = platform::program_folder();
  const std::filesystem::path path = folder / platform::program_file(program);
  if (folder.empty() || !std::filesystem::exists(path, error))
    return tl::unexpected("there is no program " + program + " beside this one");
  return platform::output_of(path, arguments);
}

}  // namespace sinew::cost
