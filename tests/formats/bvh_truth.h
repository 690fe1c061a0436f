// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace sinew::test {

/// World positions of the joints of a BVH file in every frame, in the file's units. An independent reading in plain
/// double precision, for valid files whose names have no blanks. It recomputes the whole frame while it walks the
/// hierarchy, and keeps no tree.
/// eq    world = parent * T(OFFSET, or its components that position channels replace) * R1 * R2 * ... in file order
class BvhTruth {
 public:
  /// in    adds   position channels are added to OFFSET
  BvhTruth(const std::string& text, bool adds) : adds_(adds) {
    const std::size_t motion = text.find("MOTION");
    std::istringstream in(text.substr(motion));
    std::string word;
    in >> word >> word >> frames_ >> word >> word >> frame_time_s_;
    for (double value; in >> value;) values_.push_back(value);
    for (std::size_t frame = 0; frame < frames_; ++frame) {
      std::istringstream tree(text.substr(0, motion));
      const double* next = values_.data() + frame * (values_.size() / frames_);
      tree >> word;
      std::vector<glm::dvec3>& out = positions.emplace_back();
      while (tree >> word) walk(tree, glm::dmat4(1.0), next, out);
    }
  }

  std::vector<std::vector<glm::dvec3>> positions;  ///< [frames][joints in file order, end sites too]
  double frame_time_s() const { return frame_time_s_; }

 private:
  static glm::dmat4 turn(char axis, double degrees) {
    const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
    const int a = axis == 'X' ? 1 : axis == 'Y' ? 2 : 0, b = axis == 'X' ? 2 : axis == 'Y' ? 0 : 1;
    glm::dmat4 out(1.0);  // turns axis a toward axis b
    out[a][a] = c;
    out[a][b] = s;
    out[b][a] = -s;
    out[b][b] = c;
    return out;
  }

  void walk(std::istringstream& tree, const glm::dmat4& parent, const double*& next, std::vector<glm::dvec3>& out) {
    std::string word;
    glm::dvec3 offset;
    tree >> word >> word >> word >> offset.x >> offset.y >> offset.z >> word;  // NAME { OFFSET x y z
    glm::dmat4 turns(1.0);
    if (word == "CHANNELS") {
      int count = 0;
      const glm::dvec3 base = adds_ ? offset : glm::dvec3(0.0);
      for (tree >> count; count-- > 0;) {
        tree >> word;
        if (word.substr(1) == "position")
          offset[word[0] - 'X'] = base[word[0] - 'X'] + *next++;
        else
          turns = turns * turn(word[0], *next++);
      }
      tree >> word;
    }
    glm::dmat4 move(1.0);
    move[3] = glm::dvec4(offset, 1.0);
    const glm::dmat4 world = parent * move * turns;
    out.emplace_back(world[3]);
    for (; word != "}"; tree >> word) walk(tree, world, next, out);
  }

  bool adds_;
  std::size_t frames_ = 0;
  double frame_time_s_ = 0.0;
  std::vector<double> values_;
};

}  // namespace sinew::test
