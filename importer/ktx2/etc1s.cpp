// SPDX-License-Identifier: MIT
#include "importer/ktx2/etc1s.h"

#include <algorithm>

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;

/// Change of all channels for selectors 0 to 3 (ETC1, "Intensity modifier sets").
constexpr int kModifiers[8][4] = {{-8, -2, 2, 8},     {-17, -5, 5, 17},   {-29, -9, 9, 29},     {-42, -13, 13, 42},
                                  {-60, -18, 18, 60}, {-80, -24, 24, 80}, {-106, -33, 33, 106}, {-183, -47, 47, 183}};

/// Prediction of a block's endpoint.
enum Prediction : std::uint32_t { kLeft = 0, kAbove = 1, kAboveLeft = 2, kDelta = 3 };
constexpr std::uint32_t kRepeatPrediction = 256, kLeastPredictionRun = 3;  // the symbol above all of 4 x 2 bits
constexpr std::uint32_t kLeastSelectorRun = 3, kLongSelectorRun = 63;

bool read_endpoints(Bytes bytes, std::uint32_t count, std::vector<Etc1sEndpoint>& out) {
  BasisBits bits(bytes);
  const auto low = HuffmanCode::read(bits), middle = HuffmanCode::read(bits), high = HuffmanCode::read(bits);
  const auto tables = HuffmanCode::read(bits);
  if (!low || !middle || !high || !tables) return false;
  const unsigned channels = bits.take(1) != 0 ? 1 : 3;
  Etc1sEndpoint last{{16, 16, 16}, 0};
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t table = tables->next(bits);
    if (table == HuffmanCode::kNone) return false;
    last.table = static_cast<std::uint8_t>((last.table + table) & 7u);
    for (unsigned c = 0; c < channels; ++c) {
      const HuffmanCode& code = last.color[c] <= 9 ? *low : last.color[c] <= 21 ? *middle : *high;
      const std::uint32_t delta = code.next(bits);
      if (delta == HuffmanCode::kNone) return false;
      last.color[c] = static_cast<std::uint8_t>((last.color[c] + delta) & 31u);
    }
    if (channels == 1) last.color[1] = last.color[2] = last.color[0];
    out.push_back(last);
    if (bits.overrun()) return false;
  }
  return true;
}

bool read_selectors(Bytes bytes, std::uint32_t count, std::vector<std::uint32_t>& out) {
  BasisBits bits(bytes);
  if (bits.take(2) != 0) return false;  // reserved
  const bool plain = bits.take(1) != 0;
  const auto deltas = plain ? HuffmanCode{} : HuffmanCode::read(bits);
  if (!deltas) return false;
  std::uint32_t last = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (unsigned row = 0; row < 4; ++row) {
      const bool is_delta = !plain && i > 0;
      const std::uint32_t value = is_delta ? deltas->next(bits) : bits.take(8);
      if (value > 255) return false;
      const std::uint32_t kept = is_delta ? last : last & ~(255u << 8 * row);
      last = kept ^ value << 8 * row;
    }
    out.push_back(last);
    if (bits.overrun()) return false;
  }
  return true;
}

/// Selectors used lately. A used one moves to half its place, so frequent ones are in front.
class SelectorHistory {
 public:
  explicit SelectorHistory(std::uint32_t size) : entries_(size), next_(size / 2) {}

  void add(std::uint16_t selector) noexcept {
    if (entries_.empty()) return;
    entries_[next_++] = selector;
    if (next_ == entries_.size()) next_ = entries_.size() / 2;
  }

  /// in   place < size of the history
  std::uint16_t use(std::uint32_t place) noexcept {
    const std::uint16_t selector = entries_[place];
    std::swap(entries_[place / 2], entries_[place]);
    return selector;
  }

  std::size_t size() const noexcept { return entries_.size(); }

 private:
  std::vector<std::uint16_t> entries_;
  std::size_t next_ = 0;
};

/// Decodes a slice block by block, with the state that the codes refer to.
class SliceDecoder {
 public:
  SliceDecoder(const Etc1sCodebook& codebook, Bytes slice)
      : codebook_(codebook), bits_(slice), history_(codebook.history_size) {}

  bool decode(std::uint32_t blocks_x, std::uint32_t blocks_y, std::vector<Etc1sBlock>& out) {
    std::vector<std::uint32_t> below((blocks_x + 1) / 2);  // predictions of odd rows, read with the row above
    for (std::uint32_t y = 0; y < blocks_y; ++y) {
      std::uint32_t predictions = 0;
      for (std::uint32_t x = 0; x < blocks_x; ++x) {
        if (x % 2 == 0) {
          predictions = y % 2 == 0 ? next_predictions() : below[x / 2];
          if (y % 2 == 0) below[x / 2] = predictions >> 4;
        }
        const auto above = y > 0 ? out.data() + out.size() - blocks_x : nullptr;
        const std::uint32_t endpoint = next_endpoint(predictions & 3u, x, above);
        predictions >>= 2;
        if (endpoint >= codebook_.endpoints.size()) return false;
        const std::uint32_t selector = next_selector();
        if (selector >= codebook_.selectors.size() || bits_.overrun()) return false;
        last_endpoint_ = endpoint;
        out.push_back({static_cast<std::uint16_t>(endpoint), static_cast<std::uint16_t>(selector)});
      }
    }
    return true;
  }

 private:
  /// Predictions of 2 x 2 blocks, 2 bits each. A code that is damaged predicts what no block may have.
  std::uint32_t next_predictions() {
    if (prediction_run_ > 0) {
      --prediction_run_;
      return last_predictions_;
    }
    const std::uint32_t symbol = codebook_.prediction.next(bits_);
    if (symbol == kRepeatPrediction) {
      prediction_run_ = bits_.take_chunks(4) + kLeastPredictionRun - 1;
    } else {
      is_valid_ = is_valid_ && symbol < kRepeatPrediction;
      last_predictions_ = symbol;
    }
    return last_predictions_;
  }

  /// in   above   the block above, null in the first row
  std::uint32_t next_endpoint(std::uint32_t prediction, std::uint32_t x, const Etc1sBlock* above) {
    if (!is_valid_) return HuffmanCode::kNone;
    switch (prediction) {
      case kLeft: return x > 0 ? last_endpoint_ : HuffmanCode::kNone;
      case kAbove: return above != nullptr ? above->endpoint : HuffmanCode::kNone;
      case kAboveLeft: return above != nullptr && x > 0 ? above[-1].endpoint : HuffmanCode::kNone;
      default: break;
    }
    const std::uint32_t delta = codebook_.endpoint_delta.next(bits_);
    if (delta == HuffmanCode::kNone) return delta;
    const std::uint32_t endpoint = last_endpoint_ + delta;
    const auto count = static_cast<std::uint32_t>(codebook_.endpoints.size());
    return endpoint >= count ? endpoint - count : endpoint;
  }

  std::uint32_t next_selector() {
    const auto count = static_cast<std::uint32_t>(codebook_.selectors.size());
    const auto history = static_cast<std::uint32_t>(history_.size());
    std::uint32_t symbol = count;  // the front of the history
    if (selector_run_ > 0) {
      --selector_run_;
    } else {
      symbol = codebook_.selector.next(bits_);
      if (symbol == count + history) {
        const std::uint32_t run = codebook_.run_length.next(bits_);
        if (run > kLongSelectorRun) return HuffmanCode::kNone;
        selector_run_ = (run == kLongSelectorRun ? bits_.take_chunks(7) : run) + kLeastSelectorRun - 1;
        symbol = count;
      }
    }
    if (symbol < count) {
      history_.add(static_cast<std::uint16_t>(symbol));
      return symbol;
    }
    return symbol - count < history ? history_.use(symbol - count) : HuffmanCode::kNone;
  }

  const Etc1sCodebook& codebook_;
  BasisBits bits_;
  SelectorHistory history_;
  std::uint32_t last_predictions_ = 0, prediction_run_ = 0, last_endpoint_ = 0, selector_run_ = 0;
  bool is_valid_ = true;
};

}  // namespace

std::optional<Etc1sCodebook> read_etc1s_codebook(std::uint32_t endpoint_count, std::uint32_t selector_count,
                                                 Bytes endpoints, Bytes selectors, Bytes tables) {
  Etc1sCodebook out;
  if (!read_endpoints(endpoints, endpoint_count, out.endpoints)) return std::nullopt;
  if (!read_selectors(selectors, selector_count, out.selectors)) return std::nullopt;
  BasisBits bits(tables);
  for (HuffmanCode* code : {&out.prediction, &out.endpoint_delta, &out.selector, &out.run_length}) {
    auto read = HuffmanCode::read(bits);
    if (!read) return std::nullopt;
    *code = std::move(*read);
  }
  out.history_size = bits.take(13);
  if (bits.overrun()) return std::nullopt;
  return out;
}

std::optional<std::vector<Etc1sBlock>> decode_etc1s_slice(const Etc1sCodebook& codebook, Bytes slice,
                                                          std::uint32_t blocks_x, std::uint32_t blocks_y) {
  std::vector<Etc1sBlock> blocks;
  blocks.reserve(std::size_t{blocks_x} * blocks_y);
  if (!SliceDecoder(codebook, slice).decode(blocks_x, blocks_y, blocks)) return std::nullopt;
  return blocks;
}

void etc1s_texel(const Etc1sCodebook& codebook, Etc1sBlock block, unsigned texel, std::uint8_t* rgb) noexcept {
  const Etc1sEndpoint& endpoint = codebook.endpoints[block.endpoint];
  const int modifier = kModifiers[endpoint.table][codebook.selectors[block.selector] >> 2 * texel & 3u];
  for (unsigned c = 0; c < 3; ++c) {
    const int base = endpoint.color[c] << 3 | endpoint.color[c] >> 2;
    rgb[c] = static_cast<std::uint8_t>(std::clamp(base + modifier, 0, 255));
  }
}

}  // namespace sinew
