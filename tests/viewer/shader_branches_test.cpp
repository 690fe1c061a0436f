// SPDX-License-Identifier: MIT
// No shader may branch on uniforms alone, because software drivers recompile a shader for each value of such a uniform.
// Features of frame, draw and material are specialisation constants instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "viewer/device/shader_loader.h"

namespace sinew::viewer {
namespace {

using Words = std::span<const std::uint32_t>;

/// Kinds of inputs that a value depends on; higher ones win.
enum class Source { constants, uniforms, varying };

/// Numbers of the SPIR-V specification.
enum Op : std::uint32_t {
  op_ext_inst = 12,
  op_constant_true = 41,
  op_spec_constant_op = 52,
  op_function_parameter = 55,
  op_function_call = 57,
  op_variable = 59,
  op_load = 61,
  op_store = 62,
  op_access_chain = 65,
  op_vector_shuffle = 79,
  op_composite_construct = 80,
  op_composite_extract = 81,
  op_composite_insert = 82,
  op_transpose = 84,
  op_first_image = 86,
  op_last_image = 107,
  op_first_arithmetic = 109,
  op_last_derivative = 215,
  op_phi = 245,
  op_branch_conditional = 250,
  op_switch = 251
};
enum StorageClass : std::uint32_t { storage_uniform = 2, storage_push_constant = 9 };

using Sources = std::map<std::uint32_t, Source>;

Source source_of(const Sources& known, Words ids) {
  Source most = Source::constants;
  for (const std::uint32_t id : ids)
    if (const auto at = known.find(id); at != known.end()) most = std::max(most, at->second);
  return most;
}

/// Source of the result of an instruction of the form: operation, type, result, operands.
Source source_of(const Sources& known, std::uint32_t op, Words operands) {
  if (op >= op_constant_true && op <= op_spec_constant_op) return Source::constants;
  switch (op) {
    case op_variable: {
      const bool uniform = operands[0] == storage_uniform || operands[0] == storage_push_constant;
      return uniform ? Source::uniforms : Source::varying;
    }
    case op_function_parameter:
    case op_function_call: return Source::varying;
    case op_ext_inst: return source_of(known, operands.subspan(2));
    case op_vector_shuffle:
    case op_composite_insert: return source_of(known, operands.first(2));
    case op_composite_extract: return source_of(known, operands.first(1));
    case op_phi: {
      std::vector<std::uint32_t> values;
      for (std::size_t i = 0; i < operands.size(); i += 2) values.push_back(operands[i]);
      return source_of(known, values);
    }
    default: break;
  }
  return op >= op_first_image && op <= op_last_image ? Source::varying : source_of(known, operands);
}

bool has_result(std::uint32_t op) {
  return (op >= op_constant_true && op <= op_spec_constant_op) || op == op_ext_inst || op == op_function_parameter ||
         op == op_function_call || op == op_variable || op == op_load || op == op_access_chain || op == op_phi ||
         (op >= op_vector_shuffle && op <= op_transpose) || (op >= op_first_image && op <= op_last_derivative);
}

template <class Visit>
void for_each_instruction(Words module, const Visit& visit) {
  for (std::size_t at = 5; at < module.size(); at += module[at] >> 16)
    visit(module[at] & 0xffffu, module.subspan(at + 1, (module[at] >> 16) - 1));
}

/// Branches whose condition depends on uniforms and on nothing that varies within a draw.
int uniform_branches(Words module) {
  Sources known;
  for (bool changed = true; changed;) {  // values of loops depend on later instructions
    changed = false;
    for_each_instruction(module, [&](std::uint32_t op, Words words) {
      if (!has_result(op)) return;
      const Source source = source_of(known, op, words.subspan(2));
      const auto [at, added] = known.try_emplace(words[1], source);
      changed = changed || added || at->second < source;
      at->second = std::max(at->second, source);
    });
  }
  int found = 0;
  for_each_instruction(module, [&](std::uint32_t op, Words words) {
    if (op == op_branch_conditional || op == op_switch) found += source_of(known, words.first(1)) == Source::uniforms;
  });
  return found;
}

TEST(shader_branches, no_shader_branches_on_uniforms_alone) {
  for (int shader = 0; shader <= static_cast<int>(Shader::line_frag); ++shader)
    EXPECT_EQ(uniform_branches(code_of(static_cast<Shader>(shader))), 0) << "Shader " << shader;
}

/// A module that loads a variable of this storage class (2 uniform, 1 input), adds a constant and branches on the sum.
std::vector<std::uint32_t> branching_module(std::uint32_t storage_class) {
  return {0x07230203,
          0x00010600,
          0,
          20,
          0,
          4u << 16 | 43u,
          1,
          2,
          7,  // OpConstant
          4u << 16 | op_variable,
          1,
          3,
          storage_class,
          4u << 16 | op_load,
          1,
          4,
          3,
          5u << 16 | 129u,
          1,
          5,
          4,
          2,  // OpFAdd
          4u << 16 | op_branch_conditional,
          5,
          8,
          9};
}

TEST(shader_branches, the_search_finds_a_branch_on_a_uniform_and_no_other) {
  EXPECT_EQ(uniform_branches(branching_module(storage_uniform)), 1);
  EXPECT_EQ(uniform_branches(branching_module(storage_push_constant)), 1);
  EXPECT_EQ(uniform_branches(branching_module(1)), 0);
}

}  // namespace
}  // namespace sinew::viewer
