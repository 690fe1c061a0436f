// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "importer/import_error.h"
#include "importer/tool/poses/pose.h"
#include "importer/tool/poses/pose_input.h"

namespace sinew::tool {

/// Follows the events of a JSON reader (a handler in RapidJSON's sense) through a pose file, and hands out each pose
/// when it is complete. Holds one pose and the path to the place in the document, and nothing else of the file. After a
/// wrong value it hands out no more poses, but the reader goes on: text that is no JSON is the worse fault.
class PoseEvents {
 public:
  explicit PoseEvents(const PoseSink& sink) : sink_(sink) {}

  std::optional<ImportIssue> issue;  ///< the first wrong value
  PoseSummary summary;
  bool stopped = false;  ///< the sink wants no more poses

  bool Null() { return scalar({.is_null = true}); }
  bool Bool(bool) { return scalar({}); }
  bool String(const char* text, unsigned size, bool);
  bool RawNumber(const char* text, unsigned size, bool);
  bool Key(const char* text, unsigned size, bool);
  bool StartObject() { return enter(false); }
  bool EndObject(unsigned) { return leave(); }
  bool StartArray() { return enter(true); }
  bool EndArray(unsigned) { return leave(); }

  // The reader gives numbers as text only.
  bool Int(int) { return false; }
  bool Uint(unsigned) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }

  /// The objects and arrays of a pose file. Other members are skipped.
  enum class Place : std::uint8_t {
    file,
    document,
    clips,
    clip,
    samples,
    sample,
    bits,
    nodes,
    node,
    world,
    weight_list,
    weights_node,
    weights,
    skinned,
    primitive,
    vertices,
    values,
    value
  };

 private:
  struct Level {
    Place place = Place::file;
    bool is_array = false;
    std::uint32_t seen = 0;  ///< bits of kRequired: keys that are there
    std::size_t index = 0;   ///< in an array: index of the next element
    std::string key;         ///< in an object: key of the next value
  };
  struct Scalar {
    bool is_null = false;
    std::optional<double> number;
    std::optional<std::uint32_t> index;
    std::optional<std::string_view> text;
  };
  struct Step;
  static const Step kSteps[];
  static const Step* step_from(const Level& level);

  bool enter(bool is_array);
  bool leave();
  bool scalar(const Scalar& value);
  void read(const Level& level, const Scalar& value);
  void read_of_pose(const Level& level, const Scalar& value);
  void begin(Place place);
  void finish(const Level& level);
  void finish_sample();
  void finish_primitive();
  void finish_numbers(Place place);
  void summarize();

  double number(const Scalar& value);
  double rounded(const Scalar& value);
  std::uint32_t index(const Scalar& value);
  std::size_t width() const;
  void end_of_value();
  std::string pointer(std::size_t without_last = 0) const;
  void report(std::string pointer, std::string detail);
  void report_type(const Step& step);

  const PoseSink& sink_;
  std::vector<Level> levels_{Level{}};
  std::size_t skipped_ = 0;      // levels of a part that the format does not know
  std::size_t kind_ = 0;         // index of the vertex array that is being read
  std::uint32_t kinds_ = 0;      // bits: the vertex arrays of the primitive
  std::vector<double> numbers_;  // numbers of the matrix or vector that is being read
  Pose pose_;
};

}  // namespace sinew::tool
