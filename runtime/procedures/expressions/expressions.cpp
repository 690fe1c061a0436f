// SPDX-License-Identifier: MIT
#include "runtime/procedures/expressions/expressions.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

namespace sinew {
namespace {

float value_of(const Expression& expression, float given) noexcept {
  return expression.is_binary ? (given > 0.5f ? 1.0f : 0.0f) : given;
}

float held_back(Expression::Override rule, float value) noexcept {
  if (rule == Expression::Override::block) return value > 0.0f ? 1.0f : 0.0f;
  return rule == Expression::Override::blend ? value : 0.0f;
}

/// Factors of the parts of a face, by Expression::Part.
struct Factors {
  float of[4] = {1.0f, 1.0f, 1.0f, 1.0f};
};

Factors factors_of(const ExpressionsJob& job) noexcept {
  Factors factors;
  for (std::size_t e = 0; e < job.expressions.size(); ++e) {
    const Expression& expression = job.expressions[e];
    const float value = value_of(expression, job.values[e]);
    factors.of[static_cast<std::size_t>(Expression::Part::blink)] -= held_back(expression.blink, value);
    factors.of[static_cast<std::size_t>(Expression::Part::look_at)] -= held_back(expression.look_at, value);
    factors.of[static_cast<std::size_t>(Expression::Part::mouth)] -= held_back(expression.mouth, value);
  }
  for (float& factor : factors.of) factor = (std::max)(factor, 0.0f);
  return factors;
}

}  // namespace

Expression::Part part_of_preset(const std::string& preset) noexcept {
  constexpr std::string_view kMouth[] = {"aa", "ih", "ou", "ee", "oh"};
  if (preset == "blink" || preset == "blinkLeft" || preset == "blinkRight") return Expression::Part::blink;
  if (preset == "lookUp" || preset == "lookDown" || preset == "lookLeft" || preset == "lookRight")
    return Expression::Part::look_at;
  const bool speaks = std::find(std::begin(kMouth), std::end(kMouth), preset) != std::end(kMouth);
  return speaks ? Expression::Part::mouth : Expression::Part::other;
}

ErrorCode check(const ExpressionsJob& job) noexcept {
  if (job.values.size() != job.expressions.size() || !have_memory(job.expressions, job.values, job.weights))
    return ErrorCode::size_mismatch;
  for (const float value : job.values)
    if (!(value >= 0.0f && value <= 1.0f)) return ErrorCode::not_a_fraction;
  for (const Expression& expression : job.expressions)
    for (const ExpressionBind& bind : expression.binds)
      if (bind.weight >= job.weights.size()) return ErrorCode::index_out_of_range;
  return ErrorCode::ok;
}

void run_unchecked(const ExpressionsJob& job) noexcept {
  const Factors factors = factors_of(job);
  for (std::size_t e = 0; e < job.expressions.size(); ++e) {
    const Expression& expression = job.expressions[e];
    float value = value_of(expression, job.values[e]) * factors.of[static_cast<std::size_t>(expression.part)];
    if (expression.is_binary && value < 1.0f) value = 0.0f;
    for (const ExpressionBind& bind : expression.binds) job.weights[bind.weight] += bind.value * value;
  }
}

}  // namespace sinew
