// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PALETTE_H
#define BOOMERANG_TESTBED_PALETTE_H

#include <array>
#include <cstdint>
#include <vector>

namespace testbed {

/// At most `most` colours for many pixels, by median cut: cells of like colours (five bits of each channel)
/// are split in two where half of their pixels lie, the fullest and widest first. The same pixels give the
/// same palette.
class Palette {
public:
    /// `pixels` are 0xRRGGBB, at least one; 1 <= most <= 256. O(pixels + cells log cells).
    Palette(const std::vector<uint32_t> &pixels, std::size_t most);

    const std::vector<uint32_t> &Colours() const { return m_colours; }
    /// The index of the colour that stands for a pixel, one of those that it was made for. O(1).
    uint8_t IndexOf(uint32_t pixel) const { return m_index[CellOf(pixel)]; }

private:
    static constexpr std::size_t kCells = 1U << 15;
    static std::size_t CellOf(uint32_t pixel) {
        return (pixel >> 9 & 0x7c00) | (pixel >> 6 & 0x3e0) | (pixel >> 3 & 0x1f);
    }

    std::vector<uint32_t> m_colours;
    std::array<uint8_t, kCells> m_index = {};
};

} // namespace testbed

#endif
