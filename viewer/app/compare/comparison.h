// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "viewer/app/compare/compare_views.h"
#include "viewer/app/compare/vertex_distance.h"
#include "viewer/app/pictures/picture_maker.h"

namespace sinew::viewer {

/// Two to four evaluations of one moment, side by side. Below each stands its distance from the first one as colours,
/// and below the first one the scale: blue 0, red `full_m`.
class Comparison : public PictureSource {
 public:
  struct Row {
    std::string label;
    double worst_m = 0.0, mean_m = 0.0;  ///< distance of vertices from the first view
    double evaluation_us = 0.0;          ///< median of one evaluation on one core, without drawing
    std::string worst_place;             ///< mesh and vertex; empty for the first view
  };

  /// in   loaded_scenes  must outlive this, with centers of rotation where a view needs them
  ///      clip           of the first scene; other files play their clip of the same name
  /// err  one sentence: files whose meshes differ, a file without that clip
  static tl::expected<std::unique_ptr<Comparison>, std::string> make(Device& device, const Options& options,
                                                                     const std::vector<LoadedScene>& loaded_scenes,
                                                                     const std::vector<CompareView>& views,
                                                                     std::uint32_t clip);

  Picture at(double time_s, double turn_rad) override;
  Picture in_sequence(std::uint32_t picture, const std::function<double(std::uint32_t)>& time_of) override;
  std::string fault() const override { return views_.front().maker->fault(); }

  /// Of the last picture.
  const std::vector<Row>& rows() const noexcept { return rows_; }
  double full_m() const noexcept { return full_m_; }

 private:
  struct View {
    std::string label;
    std::unique_ptr<LoadedScene> own;  ///< null = a loaded scene of the caller
    const LoadedScene* loaded = nullptr;
    std::unique_ptr<PictureMaker> maker;
  };
  Comparison(Device& device, const Options& options) : device_(device), options_(options) {}
  Picture compose(std::vector<Picture> views, double time_s);

  Device& device_;
  Options options_;
  std::vector<View> views_;
  std::vector<Row> rows_;
  double full_m_ = 0.0;
};

/// The table of the last picture: each view with millimetres, place and microseconds.
std::string describe(const Comparison& comparison);

}  // namespace sinew::viewer
