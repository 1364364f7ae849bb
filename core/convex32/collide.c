// SPDX-License-Identifier: MIT
#include "piece_faces.h"

static inline edge_ends edge_ends_of(const bmr_convex32 *polygon, uint32_t first) {
    const uint32_t second = convex32_next(polygon, first);
    const edge_ends ends = {polygon->vertices + first, polygon->vertices + second, (int32_t)(first & 0xffu),
                            (int32_t)(second & 0xffu)};
    return ends;
}

/// One polygon against the other.
typedef struct posed_side {
    const bmr_convex32 *polygon;
    const bmr_transform32 *pose;
    bool is_b;
} posed_side;

/// The products of one unit normal with two others may come out in the wrong order if they differ by less
/// than this: each is off by at most 4 times 2^-24, the turning included.
static const float noise_of_cosine = 0x1p-21f;

uint32_t bmr_convex32_edge_against(const bmr_convex32 *polygon, const bmr_transform32 *turned,
                                   bmr_vec32 normal, uint32_t hint) {
    const uint32_t start = edge_towards(polygon, turn_back(turned, negative(normal)), hint);
    uint32_t found = start;
    float least = dot(normal, turn(turned, polygon->normals[start]));
    for (int side = 0; side < 2; ++side) {
        uint32_t j = start;
        for (uint32_t steps = 1; steps < polygon->count; ++steps) {
            j = side == 0 ? convex32_next(polygon, j) : convex32_previous(polygon, j);
            const float d = dot(normal, turn(turned, polygon->normals[j]));
            if (d < least || (d == least && j < found)) {
                least = d;
                found = j;
            }
            if (!(d <= least + noise_of_cosine))
                break;
        }
    }
    return found;
}

/// The points of two edges: the face `found` of the reference, and the edge of the incident polygon that
/// faces it.
static void make_points(bmr_manifold32 *manifold, const posed_side *reference, const edge_view *found,
                        const posed_side *incident, float radius_sum) {
    const bmr_vec32 normal =
        turn_back(incident->pose, turn(reference->pose, reference->polygon->normals[found->edge]));
    const uint32_t best =
        bmr_convex32_edge_against(incident->polygon, &bmr_convex32_here, normal, found->vertex);
    const uint32_t facing = face_facing(incident->polygon, best, found->vertex, normal);
    manifold->type = reference->is_b ? BMR_MANIFOLD_FACE_B : BMR_MANIFOLD_FACE_A;
    const edge_ends face = edge_ends_of(reference->polygon, found->edge),
                    facing_ends = edge_ends_of(incident->polygon, facing);
    clip_edges(manifold, face, load4(&reference->pose->p.x), facing_ends, load4(&incident->pose->p.x),
               radius_sum, reference->is_b);
}

/// Where the search for the least separated edges begins: from a to b, in the world.
static inline bmr_vec32 axis_to_begin(const bmr_convex32 *a, const bmr_transform32 *pose_a,
                                      const bmr_convex32 *b, const bmr_transform32 *pose_b,
                                      const bmr_convex32_memory *memory) {
    return remembers_axis(memory) ? remembered_axis(memory)
                                  : minus(move(pose_b, about_middle(b)), move(pose_a, about_middle(a)));
}

/// `axis` points from a to b, in the world.
static inline void remember(bmr_convex32_memory *memory, uint32_t vertex_a, uint32_t vertex_b,
                            bmr_vec32 axis) {
    memory->support_a = (uint16_t)vertex_a;
    memory->support_b = (uint16_t)vertex_b;
    remember_axis(memory, axis);
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

/// Of two polygons at least one of which is a piece.
static void collide_pieces(bmr_manifold32 *manifold, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                           const bmr_convex32 *b, const bmr_transform32 *pose_b, float radius_sum,
                           float tolerance, bmr_convex32_memory *memory) {
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

    const posed_side sides[2] = {{a, pose_a, false}, {b, pose_b, true}};
    if (tip || !(separation_of(&faces[first]) < nearest - radius_sum))
        make_points(manifold, &sides[first], &faces[first].view, &sides[1 - first], radius_sum);
    // No points: the short edge that faces the first face may lie beyond its end.
    if (manifold->count == 0 && !tip && !(separation_of(&faces[1 - first]) < nearest - radius_sum))
        make_points(manifold, &sides[1 - first], &faces[1 - first].view, &sides[first], radius_sum);
}

/// B's edges, from where A's best one was found.
static void seek_of_b(const bmr_convex32 *a, const bmr_transform32 *pose_a, const bmr_convex32 *b,
                      const bmr_transform32 *pose_b, const edge_view *best_a, float floor, edge_found *of_b) {
    const edge_search search = edge_search_of(b, a, bmr_exact32_relative(pose_a, pose_b), 0.0f);
    bmr_convex32_seek(&search, best_a->vertex, best_a->edge, floor, of_b);
}

void bmr_convex32_collide(bmr_manifold32 *manifold, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                          const bmr_convex32 *b, const bmr_transform32 *pose_b, float radius_sum,
                          float tolerance, bmr_convex32_memory *memory) {
    if (a->seams || b->seams) {
        collide_pieces(manifold, a, pose_a, b, pose_b, radius_sum, tolerance, memory);
        return;
    }
    manifold->count = 0;
    const posed_side side_a = {a, pose_a, false}, side_b = {b, pose_b, true};
    const bmr_vec32 axis = axis_to_begin(a, pose_a, b, pose_b, memory);
    edge_found of_a, of_b;
    const edge_search edges_of_a = edge_search_of(a, b, bmr_exact32_relative(pose_b, pose_a), tolerance);
    bmr_convex32_seek(&edges_of_a, edge_towards(a, turn_back(pose_a, axis), memory->support_a),
                      memory->support_b, -FLT_MAX, &of_a);
    const edge_view *const best_a = &of_a.best;
    remember(memory, best_a->edge, best_a->vertex, turn(pose_a, a->normals[best_a->edge]));
    if (!(best_a->separation <= radius_sum))
        return;

    // B's edges matter only if one separates by more than the skins, or by `tolerance` more than A's best. An
    // edge of B that lies along A's best one separates by as much, up to rounding (`along`); of the others
    // `rest` is a bound.
    const float enough = best_a->separation + tolerance;
    const float floor = enough < radius_sum ? enough : radius_sum;
    const edge_view *const best_b = &of_b.best;
    const float along = best_a->separation + 2.0f * best_a->noise, rest = of_a.rest + 2.0f * best_a->noise;
    if (rest >= floor || along >= floor) {
        seek_of_b(a, pose_a, b, pose_b, best_a, floor, &of_b);
        const bool beyond = best_b->separation > radius_sum, reference = best_b->separation > enough;
        if (beyond || reference)
            remember(memory, best_b->vertex, best_b->edge, negative(turn(pose_b, b->normals[best_b->edge])));
        if (beyond)
            return;
        if (reference) {
            make_points(manifold, &side_b, best_b, &side_a, radius_sum);
            return;
        }
    }
    make_points(manifold, &side_a, best_a, &side_b, radius_sum);

    // No points: the short edge of B that faces A's face may lie beyond A's corner. With B's face as the
    // reference there are some.
    if (manifold->count == 0 && (a->count > 8 || b->count > 8)) {
        seek_of_b(a, pose_a, b, pose_b, best_a, -FLT_MAX, &of_b);
        make_points(manifold, &side_b, best_b, &side_a, radius_sum);
    }
}

static bool same(bmr_feature32 a, bmr_feature32 b) {
    return a.index_a == b.index_a && a.index_b == b.index_b && a.type_a == b.type_a && a.type_b == b.type_b;
}

static int points_of(const bmr_manifold32 *manifold) {
    return manifold->count < 2 ? manifold->count : 2;
}

void bmr_convex32_keep_features(bmr_manifold32 *manifold, const bmr_manifold32 *old, float distance) {
    const int count = points_of(manifold), old_count = points_of(old);
    const bool same_side = manifold->type == old->type;
    bool kept[2] = {false, false}, used[2] = {false, false};
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < old_count && !kept[i]; ++j)
            if (!used[j] && same(manifold->points[i].feature, old->points[j].feature))
                kept[i] = used[j] = true;
    for (int i = 0; i < count && same_side; ++i) {
        if (kept[i])
            continue;
        int nearest = -1;
        float least = distance * distance;
        for (int j = 0; j < old_count; ++j) {
            const float x = manifold->points[i].point.x - old->points[j].point.x;
            const float y = manifold->points[i].point.y - old->points[j].point.y;
            if (!used[j] && x * x + y * y <= least) {
                least = x * x + y * y;
                nearest = j;
            }
        }
        if (nearest >= 0) {
            manifold->points[i].feature = old->points[nearest].feature;
            used[nearest] = true;
        }
    }
    // The one point may have taken over the feature that the other point has by itself. Any other number will
    // do for the other.
    if (count == 2 && same(manifold->points[0].feature, manifold->points[1].feature))
        manifold->points[kept[0] ? 1 : 0].feature.index_b ^= 0x80u;
}

static void one_point(bmr_manifold32 *manifold, bmr_vec32 centre, bmr_vec32 normal, bmr_vec32 plane_point) {
    static const bmr_feature32 none = {0, 0, 0, 0};
    manifold->count = 1;
    manifold->type = BMR_MANIFOLD_FACE_A;
    manifold->normal = normal;
    manifold->plane_point = plane_point;
    manifold->points[0].point = centre;
    manifold->points[0].feature = none;
}

/// Unless the centre is farther than the radius from the vertex, or in a direction that is not the polygon's.
static void point_at_vertex(bmr_manifold32 *manifold, bmr_vec32 centre, bmr_vec32 local,
                            const bmr_convex32 *polygon, uint32_t at, float radius_sum) {
    const bmr_vec32 vertex = polygon->vertices[at], d = minus(local, vertex), normal = direction(d);
    if (!(dot(d, d) > radius_sum * radius_sum) && bmr_convex32_admits(polygon, at, normal, rounding_of_turn))
        one_point(manifold, centre, normal, vertex);
}

void bmr_convex32_collide_circle(bmr_manifold32 *manifold, const bmr_convex32 *polygon,
                                 const bmr_transform32 *pose_polygon, bmr_vec32 centre,
                                 const bmr_transform32 *pose_circle, float radius_sum,
                                 bmr_convex32_memory *memory) {
    manifold->count = 0;
    const bmr_vec32 local = move_back(pose_polygon, move(pose_circle, centre));
    const bmr_vec32 towards = remembers_axis(memory) ? turn_back(pose_polygon, remembered_axis(memory))
                                                     : minus(local, about_middle(polygon));
    const bmr_convex32 point = {&local, NULL, NULL, 1, 0, {0.0f, 0.0f}, NULL};
    const edge_search search = edge_search_of(polygon, &point, bmr_convex32_here, 0.0f);
    edge_found found;
    bmr_convex32_seek(&search, edge_towards(polygon, towards, memory->support_a), 0, -FLT_MAX, &found);
    uint32_t edge = found.best.edge;
    memory->support_a = (uint16_t)edge;
    remember_axis(memory, turn(pose_polygon, polygon->normals[edge]));
    if (!(found.best.separation <= radius_sum))
        return;

    const bool inside = found.best.separation < FLT_EPSILON;
    if (inside && !is_face(polygon, edge)) {
        // Nearest is an inner edge: the best face, unless it is deeper by more than the radii.
        const candidate face = best_face(&search, &found.best, 0.0f);
        if (!face.found)
            return;
        if (!(found.best.separation > face.view.separation + radius_sum))
            edge = face.view.edge;
    }
    const uint32_t second = convex32_next(polygon, edge);
    const bmr_vec32 v1 = polygon->vertices[edge], v2 = polygon->vertices[second];
    const bmr_vec32 middle = {0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y)};
    if (!inside && dot(minus(local, v1), minus(v2, v1)) <= 0.0f) {
        point_at_vertex(manifold, centre, local, polygon, edge, radius_sum);
    } else if (!inside && dot(minus(local, v2), minus(v1, v2)) <= 0.0f) {
        point_at_vertex(manifold, centre, local, polygon, second, radius_sum);
    } else if (inside || (is_face(polygon, edge) &&
                          !(dot(minus(local, middle), polygon->normals[edge]) > radius_sum))) {
        one_point(manifold, centre, polygon->normals[edge], middle);
    }
}
