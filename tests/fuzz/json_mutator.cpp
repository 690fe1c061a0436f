// SPDX-License-Identifier: MIT
#include "tests/fuzz/json_mutator.h"

#include <array>
#include <iterator>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/fixed_random.h"

namespace sinew::fuzz {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostValues = 4096, kDeepest = 64;

/// Every value of the document, parents before children.
void list_values(Json& value, std::size_t depth, std::vector<Json*>& out) {
  if (out.size() >= kMostValues || depth > kDeepest) return;
  out.push_back(&value);
  if (value.is_structured())
    for (Json& entry : value) list_values(entry, depth + 1, out);
}

Json odd_value(test::FixedRandom& random) {
  static const std::array<Json, 22> kOdd{0,
                                         1,
                                         -1,
                                         2,
                                         3,
                                         4,
                                         7,
                                         15,
                                         16,
                                         255,
                                         256,
                                         65535,
                                         65536,
                                         2147483647,
                                         4294967295,
                                         9007199254740993,
                                         1e30,
                                         0.5,
                                         -0.0,
                                         nullptr,
                                         Json::array(),
                                         Json::object()};
  return kOdd[random.below(static_cast<std::uint32_t>(kOdd.size()))];
}

void change_number(Json& value, test::FixedRandom& random) {
  if (random.below(3) == 0)
    value = odd_value(random);
  else if (value.is_number_integer())
    value = value.get<std::int64_t>() / 2 + static_cast<std::int64_t>(random.below(9)) - 4;
  else
    value = value.get<double>() * random.in(-2, 2);
}

void change_string(Json& value, const MutateBytes& mutate_bytes) {
  std::string text = value.get<std::string>();
  const std::size_t size = text.size();
  text.resize(size + 16);
  text.resize(mutate_bytes(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
  value = std::move(text);
}

void change_array(Json& value, test::FixedRandom& random) {
  if (value.empty()) return value.push_back(odd_value(random));
  const auto at = [&] { return value.begin() + random.below(static_cast<std::uint32_t>(value.size())); };
  switch (random.below(3)) {
    case 0: value.erase(at()); break;
    case 1: value.push_back(Json(*at())); break;
    default: std::swap(*at(), *at()); break;
  }
}

void change_object(Json& value, test::FixedRandom& random) {
  if (value.empty()) return;
  const auto at = [&] { return std::next(value.begin(), random.below(static_cast<std::uint32_t>(value.size()))); };
  if (random.below(2) == 0)
    value.erase(at());
  else
    std::swap(*at(), *at());
}

}  // namespace

std::string mutate_json(const std::string& text, std::uint64_t seed, const MutateBytes& mutate_bytes) {
  Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return text;
  test::FixedRandom random(seed);
  for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
    std::vector<Json*> values;
    list_values(document, 0, values);
    const auto any = [&]() -> Json& { return *values[random.below(static_cast<std::uint32_t>(values.size()))]; };
    Json& value = any();
    if (random.below(8) == 0)
      value = Json(any());
    else if (value.is_number())
      change_number(value, random);
    else if (value.is_string())
      change_string(value, mutate_bytes);
    else if (value.is_array())
      change_array(value, random);
    else if (value.is_object())
      change_object(value, random);
    else
      value = odd_value(random);
  }
  return document.dump(-1, ' ', false, Json::error_handler_t::ignore);
}

}  // namespace sinew::fuzz
