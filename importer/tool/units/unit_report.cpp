// SPDX-License-Identifier: MIT
#include "importer/tool/units/unit_report.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "importer/tool/json.h"

namespace sinew::tool {
namespace {

bool has_failed(const UnitReport::Row& row) { return row.result && row.result->status != 0; }

std::string csv_cell(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      default: out += c;
    }
  return out;
}

std::string html_row(const UnitReport::Row& row) {
  const std::string name = html_text(row.name);
  if (!row.result) return fmt::format("<tr class=\"missing\"><td>{}</td><td>not run</td><td></td></tr>\n", name);
  if (row.result->status == 0)
    return fmt::format("<tr><td>{}</td><td>0</td><td>{}</td></tr>\n", name, html_text(row.result->last_line()));
  return fmt::format(
      "<tr class=\"failed\"><td>{}</td><td>{}</td><td><details open><summary>{}</summary><pre>{}</pre></details></td>"
      "</tr>\n",
      name, row.result->status, html_text(row.result->last_line()), html_text(row.result->output));
}

std::string head_of(const UnitReport& report) {
  return fmt::format("{} units, {} failed, {} not run", report.rows.size(), report.failed(), report.missing());
}

}  // namespace

std::size_t UnitReport::failed() const {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), has_failed));
}
std::size_t UnitReport::missing() const {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.result; }));
}

std::string report_json(const UnitReport& report) {
  Json units = Json::array();
  for (const UnitReport::Row& row : report.rows) {
    Json unit = {{"name", row.name}};
    if (row.result) {
      unit["status"] = row.result->status;
      unit["output"] = row.result->output;
    }
    units.push_back(unit);
  }
  const Json all = {{"command", report.command},
                    {"count", report.rows.size()},
                    {"failed", report.failed()},
                    {"not_run", report.missing()},
                    {"units", units}};
  return all.dump(1) + '\n';
}

std::string report_csv(const UnitReport& report) {
  std::string out = "name,status,last line\n";
  for (const UnitReport::Row& row : report.rows)
    out += csv_cell(row.name) + ',' + (row.result ? std::to_string(row.result->status) : "") + ',' +
           csv_cell(row.result ? row.result->last_line() : "not run") + '\n';
  return out;
}

std::string report_html(const UnitReport& report) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>sinew batch: {0}</title>\n<style>\n"
      "body{{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:70rem;padding:0 1rem;color:#222}}\n"
      "table{{border-collapse:collapse;width:100%}}td,th{{text-align:left;padding:.3rem .6rem;border-bottom:1px solid "
      "#ddd;vertical-align:top}}\n"
      ".failed td{{background:#fdecea}}.missing td{{background:#fff6e0}}pre{{white-space:pre-wrap;margin:0}}\n"
      "</style></head><body>\n<h1>{0}</h1>\n<p><code>{1}</code></p>\n<table>\n"
      "<tr><th>file</th><th>status</th><th>what it said</th></tr>\n",
      head_of(report), html_text(report.command));
  const auto add = [&](auto belongs) {
    for (const UnitReport::Row& row : report.rows)
      if (belongs(row)) out += html_row(row);
  };
  add(has_failed);
  add([](const UnitReport::Row& row) { return !row.result; });
  add([](const UnitReport::Row& row) { return row.result && row.result->status == 0; });
  return out + "</table>\n</body></html>\n";
}

}  // namespace sinew::tool
