// SPDX-License-Identifier: MIT
#include "drawing/palette.h"

#include <algorithm>

namespace testbed {
namespace {

/// Pixels of like colour: how many, the sums of their channels, and the cell's own place in each.
struct Cell {
    std::size_t number = 0;
    uint64_t count = 0;
    std::array<uint64_t, 3> sum = {};
    unsigned At(std::size_t channel) const {
        return static_cast<unsigned>(number >> (10 - 5 * channel) & 0x1f);
    }
};

/// Cells [begin, end) that one colour may stand for.
struct Box {
    std::vector<Cell>::iterator begin, end;
    uint64_t count = 0;
    std::size_t channel = 0; ///< the one in which it is widest
    unsigned width = 0;

    Box(std::vector<Cell>::iterator from, std::vector<Cell>::iterator until) : begin(from), end(until) {
        for (auto cell = begin; cell != end; ++cell)
            count += cell->count;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax_element(
                begin, end, [i](const Cell &a, const Cell &b) { return a.At(i) < b.At(i); });
            if (high->At(i) - low->At(i) > width) {
                width = high->At(i) - low->At(i);
                channel = i;
            }
        }
    }
    uint64_t Weight() const { return count * width; }
};

} // namespace

Palette::Palette(const std::vector<uint32_t> &pixels, std::size_t most) {
    std::vector<Cell> cells(kCells);
    for (const uint32_t pixel : pixels) {
        Cell &cell = cells[CellOf(pixel)];
        ++cell.count;
        for (std::size_t i = 0; i < 3; ++i)
            cell.sum[i] += pixel >> (16 - 8 * i) & 0xff;
    }
    for (std::size_t i = 0; i < kCells; ++i)
        cells[i].number = i;
    cells.erase(std::remove_if(cells.begin(), cells.end(), [](const Cell &cell) { return cell.count == 0; }),
                cells.end());

    std::vector<Box> boxes = {Box(cells.begin(), cells.end())};
    while (boxes.size() < most) {
        const auto heaviest = std::max_element(
            boxes.begin(), boxes.end(), [](const Box &a, const Box &b) { return a.Weight() < b.Weight(); });
        if (heaviest->Weight() == 0)
            break; // a cell each
        const Box box = *heaviest;
        std::sort(box.begin, box.end, [&box](const Cell &a, const Cell &b) {
            return a.At(box.channel) != b.At(box.channel) ? a.At(box.channel) < b.At(box.channel)
                                                          : a.number < b.number;
        });
        auto middle = box.begin;
        for (uint64_t count = 0; middle != box.end - 1 && 2 * count < box.count; ++middle)
            count += middle->count;
        *heaviest = Box(box.begin, middle);
        boxes.emplace_back(middle, box.end);
    }
    for (const Box &box : boxes) {
        std::array<uint64_t, 3> sum = {};
        for (auto cell = box.begin; cell != box.end; ++cell) {
            m_index[cell->number] = static_cast<uint8_t>(m_colours.size());
            for (std::size_t i = 0; i < 3; ++i)
                sum[i] += cell->sum[i];
        }
        uint32_t colour = 0;
        for (const uint64_t channel : sum)
            colour = colour << 8 | static_cast<uint32_t>((channel + box.count / 2) / box.count);
        m_colours.push_back(colour);
    }
}

} // namespace testbed
