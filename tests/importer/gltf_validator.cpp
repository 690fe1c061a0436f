// SPDX-License-Identifier: MIT
#include "tests/importer/gltf_validator.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace sinew::test {
namespace {

constexpr const char* kScript = R"(
const validator = require(process.env.SINEW_GLTF_VALIDATOR || 'gltf-validator'), fs = require('fs');  // a folder, or by NODE_PATH
const path = require('path');
const beside = file => async uri => new Uint8Array(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri))));
const most = Number(process.argv[2]);
if (process.argv.length > 3) (async () => {
  const out = {};
  for (const file of process.argv.slice(3)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)),
                                                 {maxIssues: 100000, externalResourceFunction: beside(file)});
    out[file] = report.issues.messages.filter(m => m.severity <= most).map(m => [m.code, m.pointer + ' ' + m.message]);
  }
  console.log(JSON.stringify(out));
})();
)";

}  // namespace

std::optional<nlohmann::json> issues_by_validator(const ToolModelFile& folder, const std::vector<std::string>& files,
                                                  int most_severity) {
  const std::string script = folder.beside("validate.js"), report = folder.beside("report.json");
  std::ofstream(script) << kScript;
  if (std::system(("node " + script + " >/dev/null 2>&1").c_str()) != 0) return std::nullopt;
  std::string command = "node " + script + " " + std::to_string(most_severity);
  for (const std::string& file : files) command += " '" + file + "'";
  EXPECT_EQ(std::system((command + " >" + report).c_str()), 0);
  std::ifstream stream(report);
  return nlohmann::json::parse(stream);
}

}  // namespace sinew::test
