// SPDX-License-Identifier: MIT
#include "importer/tool/cost/report_json.h"

#include <string_view>

#include <fmt/format.h>

#include "importer/file/base64.h"

namespace sinew::cost {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kPageTemplate =
#include "report_page.inc"
    ;

OrderedJson point_json(const Group& group, const Point& point) {
  OrderedJson out = {{"name", point.name},
                     {"error", point.error},
                     {"error_unit", group.error_unit},
                     {"time", point.time_ns},
                     {"time_unit", "ns/" + group.item},
                     {"spread", point.spread},
                     {"noisy", point.noisy},
                     {"pareto", point.pareto},
                     {"default", point.is_default},
                     {"other_aim", point.other_aim}};
  if (point.size) {
    out["size"] = *point.size;
    out["size_unit"] = group.size_unit;
  }
  out["values"] = OrderedJson::array();
  for (const Value& value : point.values)
    out["values"].push_back({{"name", value.name}, {"value", value.value}, {"unit", value.unit}});
  out["note"] = point.note;
  return out;
}

OrderedJson group_json(const Group& group) {
  OrderedJson out = {{"name", group.name}, {"title", group.title}, {"question", group.question}};
  if (!group.left_out.empty()) out["left_out"] = group.left_out;
  out["about"] = group.about;
  out["findings"] = group.findings;
  out["error_name"] = group.error_name;
  out["error_unit"] = group.error_unit;
  out["rounding"] = group.rounding;
  out["cost"] = group.size_unit.empty() ? "time" : "size";
  out["cost_unit"] = group.size_unit.empty() ? "ns a " + group.item : group.size_unit;
  out["points"] = OrderedJson::array();
  for (const Point& point : group.points) out["points"].push_back(point_json(group, point));
  return out;
}

/// Quotes a cell as RFC 4180 says.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// A number as JSON writes it: the shortest text that reads back as the same double.
std::string csv_number(double value) { return fmt::format("{}", value); }

std::string csv_row(const Group& group, const Point& point) {
  std::string more;
  for (const Value& value : point.values)
    more += fmt::format("{}{}={}{}{}", more.empty() ? "" : "; ", value.name, csv_number(value.value),
                        value.unit.empty() ? "" : " ", value.unit);
  const auto truth = [](bool b) { return b ? "true" : "false"; };
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(group.name), csv_cell(point.name),
                     csv_number(point.error), csv_cell(group.error_unit), csv_number(point.time_ns),
                     csv_cell("ns/" + group.item), csv_number(point.spread), truth(point.noisy), truth(point.pareto),
                     truth(point.is_default), truth(point.other_aim), point.size ? csv_number(*point.size) : "",
                     csv_cell(group.size_unit), csv_cell(more), csv_cell(point.note));
}

/// JSON that is safe inside a script element: it contains no "</script" and no "<!--".
std::string inside_script(const OrderedJson& json) {
  std::string safe;
  for (const char c : json.dump(-1, ' ', true, OrderedJson::error_handler_t::replace))
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

OrderedJson parts_json(const std::vector<FramePart>& parts) {
  OrderedJson out = OrderedJson::array();
  for (const FramePart& part : parts) out.push_back({{"name", part.name}, {"us", part.us}});
  return out;
}

OrderedJson choice_json(const Choice& choice) {
  OrderedJson out = {{"group", choice.group},
                     {"title", choice.title},
                     {"now", choice.now},
                     {"other", choice.other},
                     {"takes_other", choice.takes_other},
                     {"why", choice.why},
                     {"us_change", choice.us_change},
                     {"error_unit", choice.error_unit},
                     {"error_now", choice.error_now},
                     {"error_other", choice.error_other},
                     {"picture_note", choice.picture_note}};
  if (choice.size_ratio) out["size_ratio"] = *choice.size_ratio;
  if (choice.budget) out["budget"] = *choice.budget;
  return out;
}

OrderedJson overview_json(const Overview& overview) {
  OrderedJson out = {{"size_m", overview.size_m},
                     {"odd_unit", overview.odd_unit},
                     {"evaluation", parts_json(overview.evaluation)},
                     {"drawing", parts_json(overview.drawing)},
                     {"not_drawn", overview.not_drawn},
                     {"command", overview.command}};
  out["choices"] = OrderedJson::array();
  for (const Choice& choice : overview.choices) out["choices"].push_back(choice_json(choice));
  return out;
}

}  // namespace

OrderedJson report_json(const Report& report) {
  OrderedJson machine = OrderedJson::object();
  for (const auto& [name, value] : report.machine) machine[name] = value;
  OrderedJson out = {
      {"subject", report.subject}, {"machine", machine}, {"command", report.command}, {"noisy_from", kNoisySpread}};
  if (report.overview) out["overview"] = overview_json(*report.overview);
  out["groups"] = OrderedJson::array();
  for (const Group& group : report.groups) out["groups"].push_back(group_json(group));
  return out;
}

std::string report_csv(const Report& report) {
  std::string out =
      "group,name,error,error_unit,time,time_unit,spread,noisy,pareto,default,other_aim,size,size_unit,values,note\n";
  for (const Group& group : report.groups)
    for (const Point& point : group.points) out += csv_row(group, point);
  return out;
}

std::string report_page(const Report& report) {
  constexpr std::string_view kPlace = "@REPORT@";
  std::string page(kPageTemplate);
  OrderedJson json = report_json(report);
  for (std::size_t i = 0; report.overview && i < report.overview->choices.size(); ++i)
    if (const std::string& png = report.overview->choices[i].picture; !png.empty())
      json["overview"]["choices"][i]["picture"] = "data:image/png;base64," + encode_base64(png);
  page.replace(page.find(kPlace), kPlace.size(), inside_script(json));
  return page;
}

}  // namespace sinew::cost
