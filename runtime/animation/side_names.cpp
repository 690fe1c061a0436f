// SPDX-License-Identifier: MIT
#include "runtime/animation/side_names.h"

#include <map>
#include <numeric>
#include <optional>

namespace sinew {
namespace {

bool is_small(char c) noexcept { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) noexcept { return c >= 'A' && c <= 'Z'; }
bool is_letter(char c) noexcept { return is_small(c) || is_capital(c); }
bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
char small(char c) noexcept { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; }
char capital(char c) noexcept { return is_small(c) ? static_cast<char>(c - 'a' + 'A') : c; }

/// A part of a name that tells the side.
struct SidePlace {
  std::size_t at = 0, length = 0;
  Side side = Side::none;
};

/// The first and last character of a part of a name, and the characters before and after it. At the ends of the name
/// these count as separators.
struct Around {
  char before, first, last, after;

  Around(std::string_view name, std::size_t at, std::size_t length)
      : before(at == 0 ? ' ' : name[at - 1]),
        first(name[at]),
        last(name[at + length - 1]),
        after(at + length == name.size() ? ' ' : name[at + length]) {}

  bool starts_word() const noexcept { return !is_letter(before) || (is_small(before) && is_capital(first)); }
  bool ends_word() const noexcept { return !is_letter(after) || (is_small(last) && is_capital(after)); }
  bool stands_alone() const noexcept { return !is_letter(before) && !is_digit(before) && !is_letter(after); }
};

bool is_word(std::string_view name, std::size_t at, std::string_view word) noexcept {
  if (name.size() - at < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (small(name[at + i]) != word[i]) return false;
  const Around around(name, at, word.size());
  return around.starts_word() || around.ends_word();
}

Side side_of_letter(char c) noexcept {
  if (small(c) == 'l') return Side::left;
  return small(c) == 'r' ? Side::right : Side::none;
}

bool is_joined_letter(const Around& around) noexcept {
  const bool leads = !is_letter(around.before) && is_capital(around.after);
  const bool trails = is_capital(around.first) && is_small(around.before) && !is_letter(around.after);
  return leads || trails;
}

/// All marks of a side in a name: first whole words, then letters that stand alone, then letters joined to a word.
std::vector<SidePlace> side_places(std::string_view name) {
  std::vector<SidePlace> words, letters, joined;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (is_word(name, i, "left")) words.push_back({i, 4, Side::left});
    if (is_word(name, i, "right")) words.push_back({i, 5, Side::right});
    const Side side = side_of_letter(name[i]);
    if (side == Side::none) continue;
    const Around around(name, i, 1);
    if (around.stands_alone())
      letters.push_back({i, 1, side});
    else if (is_joined_letter(around))
      joined.push_back({i, 1, side});
  }
  words.insert(words.end(), letters.begin(), letters.end());
  words.insert(words.end(), joined.begin(), joined.end());
  return words;
}

/// The word for the other side, in the same case.
std::string turned(std::string_view word, Side side) {
  std::string other = side == Side::left ? "right" : "left";
  if (word.size() == 1) other.resize(1);
  if (is_capital(word[0])) other[0] = capital(other[0]);
  if (word.size() > 1 && is_capital(word[1]))
    for (char& c : other) c = capital(c);
  return other;
}

/// The name without a separator and number at its end, which exporters append.
std::string_view without_number(std::string_view name) noexcept {
  std::size_t end = name.size();
  while (end > 0 && is_digit(name[end - 1])) --end;
  const bool has_number = end < name.size() && end > 1 && !is_letter(name[end - 1]);
  return has_number ? name.substr(0, end - 1) : name;
}

/// Finds the index of a name, unless the name occurs twice.
class UniqueNames {
 public:
  void add(std::string_view name, std::uint32_t index) {
    const auto [place, is_new] = places_.try_emplace(std::string(name), index);
    if (!is_new) place->second = std::nullopt;
  }
  std::optional<std::uint32_t> find(const std::string& name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? std::nullopt : found->second;
  }

 private:
  std::map<std::string, std::optional<std::uint32_t>> places_;
};

}  // namespace

Side side_of(std::string_view name) {
  const std::vector<SidePlace> places = side_places(name);
  return places.empty() ? Side::none : places.front().side;
}

std::vector<std::string> other_sides(std::string_view name) {
  std::vector<std::string> others;
  for (const SidePlace& place : side_places(name)) {
    std::string other(name);
    other.replace(place.at, place.length, turned(name.substr(place.at, place.length), place.side));
    others.push_back(std::move(other));
  }
  return others;
}

std::vector<std::uint32_t> name_partners(std::span<const std::string> names) {
  UniqueNames whole, unnumbered;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    whole.add(names[i], i);
    unnumbered.add(without_number(names[i]), i);
  }
  std::vector<std::uint32_t> partner(names.size());
  std::iota(partner.begin(), partner.end(), 0u);
  const auto pair_up = [&](const UniqueNames& known, auto key_of) {
    for (std::uint32_t i = 0; i < names.size(); ++i)
      for (const std::string& other : other_sides(key_of(names[i]))) {
        const auto found = known.find(other);
        if (partner[i] != i || !found || partner[*found] != *found || *found == i) continue;
        if (known.find(std::string(key_of(names[i]))) != i) continue;  // the name occurs twice
        partner[i] = *found;
        partner[*found] = i;
      }
  };
  pair_up(whole, [](std::string_view name) { return name; });
  pair_up(unnumbered, without_number);
  return partner;
}

}  // namespace sinew
