// SPDX-License-Identifier: MIT
#include "convex32_pieces.h"
#include "edge_points.h"
#include "piece_faces.h"

/// One polygon against the other.
typedef struct side {
    const bmr_convex32 *polygon;
    const bmr_transform32 *pose;
    bool is_b;
} side;

/// The face of largest separation that the other polygon admits.
typedef struct candidate {
    edge_view view;
    bool found;
} candidate;

static bool is_admitted(const edge_search *search, const edge_view *view, float tolerance) {
    return bmr_convex32_admits(search->other, view->vertex, negative(view->normal), tolerance);
}

/// `best` is the edge of largest separation of all, most often a face. Otherwise O(n) edges are looked at.
static candidate best_face(const edge_search *search, const edge_view *best, float tolerance) {
    candidate c = {*best, is_face(search->reference, best->edge) && is_admitted(search, best, tolerance)};
    if (c.found)
        return c;
    uint32_t hint = best->vertex;
    for (uint32_t i = 0; i < search->reference->count; ++i) {
        if (!is_face(search->reference, i))
            continue;
        const edge_view view = bmr_convex32_look(search, i, hint);
        hint = view.vertex;
        if ((c.found && !(view.separation > c.view.separation)) || !is_admitted(search, &view, tolerance))
            continue;
        c.view = view;
        c.found = true;
    }
    return c;
}

/// Is the other polygon's vertex that is deepest below this face within the piece, as far as its inner edges
/// tell? Then no piece behind one of them has the answer.
static bool is_in_this_piece(const edge_search *search, const candidate *c) {
    const bmr_convex32 *const piece = search->reference;
    if (!c->found || !piece->seams)
        return false;
    const bmr_vec32 deepest = move_back(&search->frame, c->view.nearest);
    for (uint32_t i = 0; i < piece->count; ++i)
        if (!is_face(piece, i) && dot(piece->normals[i], minus(deepest, piece->vertices[i])) > 0.0f)
            return false;
    return true;
}

static float separation_of(const candidate *c) {
    return c->found ? c->view.separation : -FLT_MAX;
}

/// Whose face is the reference: a's, unless b's separates more.
static int first_of(const candidate *faces, float tolerance) {
    return separation_of(&faces[1]) > separation_of(&faces[0]) + tolerance ? 1 : 0;
}

static void make_points(bmr_manifold32 *manifold, const side *reference, const edge_view *found,
                        const side *incident, float radius_sum) {
    const uint32_t best =
        edge_facing(reference->polygon, reference->pose, found, incident->polygon, incident->pose);
    const bmr_vec32 normal =
        turn_back(incident->pose, turn(reference->pose, reference->polygon->normals[found->edge]));
    const uint32_t facing = face_facing(incident->polygon, best, found->vertex, normal);
    points_between(manifold, reference->polygon, reference->pose, found->edge, incident->polygon,
                   incident->pose, facing, radius_sum, reference->is_b);
}

void bmr_convex32_collide_pieces(bmr_manifold32 *manifold, const bmr_convex32 *a,
                                 const bmr_transform32 *pose_a, const bmr_convex32 *b,
                                 const bmr_transform32 *pose_b, float radius_sum, float tolerance,
                                 bmr_convex32_memory *memory) {
    manifold->count = 0;
    const edge_search of_a = edge_search_of(a, b, bmr_exact32_relative(pose_b, pose_a), 0.0f),
                      of_b = edge_search_of(b, a, bmr_exact32_relative(pose_a, pose_b), 0.0f);
    const bmr_vec32 axis = axis_to_begin(a, pose_a, b, pose_b, memory);
    edge_found best_a, best_b;
    bmr_convex32_seek(&of_a, edge_towards(a, turn_back(pose_a, axis), memory->support_a), memory->support_b,
                      -FLT_MAX, &best_a);
    remember(memory, best_a.best.edge, best_a.best.vertex, turn(pose_a, a->normals[best_a.best.edge]));
    if (!(best_a.best.separation <= radius_sum))
        return;
    bmr_convex32_seek(&of_b, best_a.best.vertex, best_a.best.edge, -FLT_MAX, &best_b);
    if (!(best_b.best.separation <= radius_sum)) {
        remember(memory, best_b.best.vertex, best_b.best.edge,
                 negative(turn(pose_b, b->normals[best_b.best.edge])));
        return;
    }

    const float nearest = fmaxf(best_a.best.separation, best_b.best.separation);
    candidate faces[2] = {best_face(&of_a, &best_a.best, rounding_of_turn),
                          best_face(&of_b, &best_b.best, rounding_of_turn)};
    // Where two straight stretches with seams lie on each other, each says that the direction is the other's.
    if (a->seams && b->seams &&
        nearest > fmaxf(separation_of(&faces[0]), separation_of(&faces[1])) + radius_sum) {
        faces[0] = best_face(&of_a, &best_a.best, nearly_straight);
        faces[1] = best_face(&of_b, &best_b.best, nearly_straight);
    }
    const float of_faces = fmaxf(separation_of(&faces[0]), separation_of(&faces[1]));
    const piece_answer answer = answer_of(nearest, of_faces, radius_sum);
    int first = first_of(faces, tolerance);
    // A tip between two pieces is beside each of them by less than the skins, however deep it is: each would
    // leave it to the other.
    const bool tip = answer != BY_FACES && !(nearest > of_faces + deepest_tip * radius_sum) &&
                     is_in_this_piece(first == 0 ? &of_a : &of_b, &faces[first]);
    if (!tip && answer == BY_OTHER_PIECE)
        return;
    if (!tip && answer == AS_ANY_POLYGON) {
        if (!(has_faces(a) && has_faces(b)))
            return;
        const candidate any_a = {best_a.best, true}, any_b = {best_b.best, true};
        faces[0] = any_a;
        faces[1] = any_b;
        first = first_of(faces, tolerance);
    }

    const side sides[2] = {{a, pose_a, false}, {b, pose_b, true}};
    if (tip || !(separation_of(&faces[first]) < nearest - radius_sum))
        make_points(manifold, &sides[first], &faces[first].view, &sides[1 - first], radius_sum);
    // No points: the short edge that faces the first face may lie beyond its end.
    if (manifold->count == 0 && !tip && !(separation_of(&faces[1 - first]) < nearest - radius_sum))
        make_points(manifold, &sides[1 - first], &faces[1 - first].view, &sides[first], radius_sum);
}
