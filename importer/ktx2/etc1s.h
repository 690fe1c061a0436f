// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "importer/ktx2/basis_bits.h"

namespace sinew {

/// Color and intensity table of an ETC1S block (Khronos Data Format Specification, "ETC1S").
struct Etc1sEndpoint {
  std::uint8_t color[3]{};  ///< 5 bits each
  std::uint8_t table = 0;   ///< [0, 8)
};

/// Data that all ETC1S blocks of a file share: lists of endpoints and selectors, and the codes of their indices.
struct Etc1sCodebook {
  std::vector<Etc1sEndpoint> endpoints;
  std::vector<std::uint32_t> selectors;  ///< 16 texels of 2 bits, row by row from the lowest bit
  HuffmanCode prediction, endpoint_delta, selector, run_length;
  std::uint32_t history_size = 0;  ///< recent selectors that a code can name
};

/// One block: indices into the lists of the codebook.
struct Etc1sBlock {
  std::uint16_t endpoint = 0, selector = 0;
};

/// Reads the lists and codes of BasisLZ global data.
/// source   KTX File Format Specification 2.0, appendix "BasisLZ/ETC1S Bitstream Specification"
/// out      empty if the data are damaged
/// cost     O(entries); at most 65535 entries of each list
std::optional<Etc1sCodebook> read_etc1s_codebook(std::uint32_t endpoint_count, std::uint32_t selector_count,
                                                 std::span<const std::byte> endpoints,
                                                 std::span<const std::byte> selectors,
                                                 std::span<const std::byte> tables);

/// Decodes the blocks of one slice of a picture that is no frame of a video, row by row.
/// out    empty if the slice is damaged
/// cost   O(blocks)
std::optional<std::vector<Etc1sBlock>> decode_etc1s_slice(const Etc1sCodebook& codebook,
                                                          std::span<const std::byte> slice, std::uint32_t blocks_x,
                                                          std::uint32_t blocks_y);

/// Color of one texel of a block.
/// eq    c = clamp(c5 * 8 + c5 / 4 + modifier(table, selector), 0, 255)
/// in    texel   column + 4 * row
void etc1s_texel(const Etc1sCodebook& codebook, Etc1sBlock block, unsigned texel, std::uint8_t* rgb) noexcept;

}  // namespace sinew
