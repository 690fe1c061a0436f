// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace sinew::cost {

/// A part of the time of a frame.
struct FramePart {
  std::string name;
  double us = 0.0;
};

/// A choice of the first screen: what sinew does by default, and one other way.
struct Choice {
  std::string group;  ///< Group::name: the chart with all ways
  std::string title;
  std::string now, other;  ///< names of the default point, and of the other one
  bool takes_other = false;
  std::string why;                   ///< one sentence: why the recommendation takes `now` or `other`
  double us_change = 0.0;            ///< time of a frame with `other` minus that with `now`
  std::optional<double> size_ratio;  ///< bytes of `other` / bytes of `now`
  std::optional<double> budget;      ///< error budget that makes `other`, in percent of the model
  std::string error_unit;            ///< "% of the model" for lengths, else the unit of the group
  double error_now = 0.0, error_other = 0.0;
  std::string picture;       ///< PNG with the errors on the model; empty = there is none
  std::string picture_note;  ///< its legend, or why it could not be drawn
};

/// The first screen of a report: the whole frame of a model, the choices that matter for it, and a recommendation.
struct Overview {
  double size_m = 0.0;                ///< longest side of the model
  bool odd_unit = false;              ///< the file's unit is hardly a metre: sizes read better in percent of the model
  std::vector<FramePart> evaluation;  ///< on one core; empty = nothing moves
  std::vector<FramePart> drawing;     ///< by sinew-viewer, 1280 x 720
  std::string not_drawn;              ///< why `drawing` is empty; else empty
  std::vector<Choice> choices;
  std::string command;  ///< command lines that follow the recommendation
};

}  // namespace sinew::cost
