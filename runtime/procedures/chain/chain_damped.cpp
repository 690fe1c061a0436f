// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "runtime/math/axis_angle.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/procedures/chain/chain_tree.h"

namespace sinew::ik {
namespace {

using V = Vec3<double>;
using Matrix = Eigen::Map<Eigen::MatrixXd>;
using Vector = Eigen::Map<Eigen::VectorXd>;

constexpr std::size_t kRows = 6;     ///< rows of an effector: place and rotation
constexpr std::size_t kColumns = 6;  ///< columns of a joint: turn and move

/// Largest turn of a joint in one iteration. The linear system is a poor model of larger turns.
constexpr double kMostTurn_rad = 0.5;

/// The linear system, stored in ChainTree::numbers.
struct System {
  Eigen::Index rows, columns;
  Matrix jacobian, square;
  Vector error, step;

  explicit System(const ChainTree& tree)
      : rows(static_cast<Eigen::Index>(kRows * tree.effectors.size())),
        columns(static_cast<Eigen::Index>(kColumns * tree.moving.size())),
        jacobian(tree.numbers.data(), rows, columns),
        square(tree.numbers.data() + rows * columns, rows, rows),
        error(tree.numbers.data() + rows * columns + rows * rows, rows),
        step(tree.numbers.data() + rows * columns + rows * rows + rows, columns) {}
};

void set_column(System& system, Eigen::Index row, Eigen::Index column, const V& value) noexcept {
  for (int k = 0; k < 3; ++k) system.jacobian(row + k, column) = value[k];
}

/// Fills in the effect of a small turn or move of a joint, in the space of its parent, on an effector.
void fill(const ChainTree& tree, System& system, std::size_t part, std::size_t effector) noexcept {
  const std::uint32_t at = tree.moving[part], end = tree.effectors[effector];
  const ChainNode& node = tree.nodes[at];
  if ((node.effectors >> effector & 1) == 0) return;
  const Affined above = tree.model_above(node);
  const auto back = inverse_of(above);
  if (!back) return;
  const ChainEffector& asked = tree.goal().effectors[effector];
  const double place = std::sqrt(static_cast<double>(asked.weight)),
               turn = std::sqrt(static_cast<double>(asked.rotation_weight)) * tree.length;
  const V arm = transform_point(*back, tree.place(end)) - node.local.translation;
  const Eigen::Index row = static_cast<Eigen::Index>(kRows * effector),
                     column = static_cast<Eigen::Index>(kColumns * part);
  for (int k = 0; k < 3; ++k) {
    V axis(0.0);
    axis[k] = 1.0;
    set_column(system, row, column + k, transform_vector(above, glm::cross(axis, arm)) * place);
    set_column(system, row + 3, column + k, rotate_vector(tree.rotation_above(node), axis) * turn);
    if (tree.part(node).moves)
      set_column(system, row, column + 3 + k, transform_vector(above, axis) * (place * tree.length));
  }
}

void fill_errors(const ChainTree& tree, System& system) noexcept {
  for (std::size_t i = 0; i < tree.effectors.size(); ++i) {
    const ChainEffector& asked = tree.goal().effectors[i];
    const ChainError error = tree.error(i);
    const AxisAngleT<double> turn = axis_angle_from_quat(error.turn);
    const V place = error.way * std::sqrt(static_cast<double>(asked.weight));
    const V rotation =
        turn.axis * (turn.angle_rad * std::sqrt(static_cast<double>(asked.rotation_weight)) * tree.length);
    const Eigen::Index row = static_cast<Eigen::Index>(kRows * i);
    for (int k = 0; k < 3; ++k) {
      system.error(row + k) = place[k];
      system.error(row + 3 + k) = rotation[k];
    }
  }
}

void apply(ChainTree& tree, const System& system) noexcept {
  for (std::size_t i = 0; i < tree.moving.size(); ++i) {
    const Eigen::Index column = static_cast<Eigen::Index>(kColumns * i);
    const auto three = [&](Eigen::Index from) {
      return V(system.step(from), system.step(from + 1), system.step(from + 2));
    };
    const V turn = three(column);
    const double angle = std::min(safe_length(turn), kMostTurn_rad);
    tree.turn(tree.moving[i], quat_from_axis_angle(turn, angle));
    if (tree.goal().joints[i].moves) tree.nodes[tree.moving[i]].local.translation += three(column + 3) * tree.length;
  }
  tree.update(tree.moving.front());
}

void keep(ChainTree& tree) noexcept {
  for (std::size_t i = 0; i < tree.moving.size(); ++i) tree.saved[i] = tree.nodes[tree.moving[i]].local;
}

void go_back(ChainTree& tree) noexcept {
  for (std::size_t i = 0; i < tree.moving.size(); ++i) tree.nodes[tree.moving[i]].local = tree.saved[i];
  tree.update(tree.moving.front());
}

}  // namespace

std::size_t damped_numbers(std::size_t joints, std::size_t effectors) noexcept {
  const std::size_t rows = kRows * effectors, columns = kColumns * joints;
  return rows * columns + rows * rows + rows + columns;
}

void step_damped(ChainTree& tree, double& damping) noexcept {
  System system(tree);
  const double before = tree.errors().cost, least = 1e-6 * tree.length;
  if (damping == 0.0) damping = 0.05 * tree.length;
  system.jacobian.setZero();
  for (std::size_t part = 0; part < tree.moving.size(); ++part)
    for (std::size_t effector = 0; effector < tree.effectors.size(); ++effector) fill(tree, system, part, effector);
  keep(tree);
  constexpr int kTries = 4;
  for (int i = 0; i < kTries; ++i) {
    fill_errors(tree, system);
    system.square.noalias() = system.jacobian.lazyProduct(system.jacobian.transpose());
    system.square.diagonal().array() += damping * damping;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors(system.square);
    factors.solveInPlace(system.error);
    system.step.noalias() = system.jacobian.transpose().lazyProduct(system.error);
    apply(tree, system);
    if (tree.errors().cost < before) {
      damping = std::max(damping * 0.2, least);
      return;
    }
    damping *= 5.0;
    go_back(tree);
  }
}

}  // namespace sinew::ik
