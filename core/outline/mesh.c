// SPDX-License-Identifier: MIT
#include "outline/mesh.h"

#define NONE BMR_OUTLINE_NONE

/// Steps through both faces at once and stops at the end of the shorter one.
static bool is_shorter(const bmr_mesh *m, uint32_t half, uint32_t other) {
    uint32_t h = half, o = other;
    do {
        h = m->halves[h].next;
        o = m->halves[o].next;
    } while (h != half && o != other);
    return h == half;
}

void bmr_mesh_unite(bmr_mesh *mesh, uint32_t half) {
    bmr_half *halves = mesh->halves;
    const uint32_t twin = halves[half].twin;
    const uint32_t kept = is_shorter(mesh, half, twin) ? twin : half;
    const uint32_t gone = halves[kept].twin, face = halves[kept].face;
    mesh->faces[halves[gone].face] = NONE;
    for (uint32_t h = halves[gone].next; h != gone; h = halves[h].next)
        halves[h].face = face;
    mesh->faces[face] = halves[kept].next;
    const bmr_half a = halves[kept], b = halves[gone];
    halves[a.previous].next = b.next;
    halves[b.next].previous = a.previous;
    halves[b.previous].next = a.next;
    halves[a.next].previous = b.previous;
    halves[kept].face = halves[gone].face = NONE;
}

void bmr_mesh_unite_idle(bmr_mesh *mesh) {
    for (uint32_t h = 0; h < mesh->half_count; ++h) {
        const bmr_half *half = &mesh->halves[h];
        if (half->face != NONE && half->twin != NONE && h < half->twin && bmr_mesh_is_idle_at(mesh, h) &&
            bmr_mesh_is_idle_at(mesh, half->twin))
            bmr_mesh_unite(mesh, h);
    }
}
