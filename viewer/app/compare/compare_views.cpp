// SPDX-License-Identifier: MIT
#include "viewer/app/compare/compare_views.h"

#include "viewer/app/option_text.h"

namespace sinew::viewer {
namespace {

constexpr double kMillimetre = 1e-3, kMostMillimetres = 1e6;

tl::expected<CompareView, std::string> parse_view(std::string_view text) {
  CompareView view;
  view.label = text;
  if (text == "linear") return view;
  if (text == "dual-quaternion") {
    view.skinning = Skinning::dual_quaternion;
    return view;
  }
  if (text == "center-of-rotation") {
    view.skinning = Skinning::center_of_rotation;
    return view;
  }
  if (text.starts_with("compiled=")) {
    const auto budget = number<double>(text.substr(9));
    if (!budget || *budget <= 0.0 || *budget > kMostMillimetres)
      return tl::unexpected("'" + std::string(text) + "' is not compiled=MM with millimetres above 0");
    view.kind = CompareView::Kind::compiled;
    view.budget_m = *budget * kMillimetre;
    return view;
  }
  return tl::unexpected("'" + std::string(text) +
                        "' is none of linear, dual-quaternion, center-of-rotation, compiled=MM, files");
}

}  // namespace

tl::expected<std::vector<CompareView>, std::string> parse_views(std::string_view text, std::size_t file_count) {
  std::vector<CompareView> views;
  if (text == "files") {
    for (std::size_t file = 0; file < file_count; ++file) {
      CompareView view;
      view.kind = CompareView::Kind::file;
      view.file = file;
      views.push_back(view);
    }
  } else {
    for (std::size_t at = 0; at != std::string_view::npos;) {
      const std::size_t comma = text.find(',', at);
      auto view = parse_view(text.substr(at, comma == std::string_view::npos ? comma : comma - at));
      if (!view) return tl::unexpected(view.error());
      views.push_back(*std::move(view));
      at = comma == std::string_view::npos ? comma : comma + 1;
    }
  }
  if (views.size() < kFewestViews || views.size() > kMostViews)
    return tl::unexpected("'" + std::string(text) + "' makes " + std::to_string(views.size()) +
                          " views; two to four can be compared");
  return views;
}

}  // namespace sinew::viewer
