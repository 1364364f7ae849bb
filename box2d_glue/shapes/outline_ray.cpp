// SPDX-License-Identifier: MIT
#include "shapes/outline_ray.h"

#include "convex32/convex32_pieces.h"
#include "shapes/outline_record.h"

namespace bmr {

namespace {

const bmr_convex32_block &BlockOf(registry::Handle piece) {
    return *registry::Find(piece).block.load(std::memory_order_relaxed);
}

} // namespace

bool EntersOutline(registry::Handle piece, bmr_vec32 p1, bmr_vec32 p2, uint32_t edge, float *fraction,
                   bmr_vec32 *normal) {
    // (A piece has a reference to the record, and so to all pieces.)
    const auto &record =
        static_cast<const OutlineRecord &>(*registry::Find(piece).group.load(std::memory_order_relaxed));
    const bmr_piece_ray32 ray = bmr_convex32_piece_ray(p1, p2, record.reach);
    double at = static_cast<double>(*fraction);
    bmr_vec32 corner;
    const bmr_entry32 entry = bmr_convex32_entry(&BlockOf(piece), &ray, edge, &at, &corner);
    if (entry != BMR_ENTRY_CORNER)
        return entry == BMR_ENTRY_FACE;
    for (uint32_t i = 0; i < record.pieceCount; ++i)
        if (record.pieces[i] != piece && bmr_convex32_comes_through(&BlockOf(record.pieces[i]), &ray, at))
            return false;
    double against = 0.0;
    for (uint32_t i = 0; i < record.pieceCount; ++i)
        bmr_convex32_face_against(&BlockOf(record.pieces[i]), &ray, corner, &against, normal);
    *fraction = static_cast<float>(at);
    return against < 0.0;
}

} // namespace bmr
