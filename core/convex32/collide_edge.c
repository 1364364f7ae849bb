// SPDX-License-Identifier: MIT
#include "piece_faces.h"

// Box2D's own: a face of the polygon is the reference where it separates by this much more than the edge, and
// one-sided edges leave directions to their neighbours that lie this far (a sine) beyond their normals.
static const float relative_tolerance = 0.98f, absolute_tolerance = 0.001f, region_tolerance = 0.1f;

/// The line along which the two are least deep in each other.
typedef struct axis32 {
    bmr_vec32 normal; ///< in the edge's frame
    float separation;
    uint32_t edge; ///< of the polygon
    bool of_polygon;
} axis32;

/// The least value of the polygon's vertices along an axis, with the rounding of the edge's frame.
static float least_along(const bmr_convex32 *polygon, const bmr_transform32 *frame, bmr_vec32 axis,
                         bmr_vec32 origin, uint32_t *vertex) {
    const uint32_t start = farthest32(polygon, turn_back(frame, negative(axis)), *vertex);
    float least = FLT_MAX, noise = 0.0f;
    for (int side = 0; side < 2; ++side) {
        uint32_t j = start;
        for (uint32_t steps = 0; steps < polygon->count; ++steps) {
            const bmr_vec32 v = polygon->vertices[j];
            const float s = dot(axis, minus(move(frame, v), origin));
            if (steps == 0) // a vertex that was moved, and its product: as noise_of_size in max_separation.c
                noise = 0x1p-20f * (convex32_size(v) + convex32_size(frame->p) + convex32_size(origin));
            if (s < least) {
                least = s;
                *vertex = j;
            }
            if (!(s <= least + noise))
                break;
            j = side == 0 ? convex32_next(polygon, j) : convex32_previous(polygon, j);
        }
    }
    return least;
}

/// The edge's normal to one or the other side.
static axis32 axis_of_edge(const bmr_convex32 *polygon, const bmr_transform32 *frame, bmr_vec32 first,
                           bmr_vec32 normal, uint32_t *vertex) {
    axis32 axis = {normal, least_along(polygon, frame, normal, first, vertex), 0, false};
    uint32_t far = (*vertex + polygon->count / 2) % polygon->count;
    const float other = least_along(polygon, frame, negative(normal), first, &far);
    if (other > axis.separation) {
        axis.normal = negative(normal);
        axis.separation = other;
        *vertex = far;
    }
    return axis;
}

static axis32 axis_of_polygon(const edge_view *best) {
    const axis32 axis = {negative(best->normal), best->separation, best->edge, true};
    return axis;
}

/// How far beyond its neighbours' normals (a sine) a one-sided edge is pushed. Past 8 vertices by no more
/// than the polygon turns at its face: one of two adjacent faces is always that near to the real direction.
static float region_of(const bmr_convex32 *polygon, const axis32 *primary) {
    if (polygon->count <= 8 || !primary->of_polygon)
        return region_tolerance;
    const uint32_t last = convex32_previous(polygon, primary->edge),
                   next = convex32_next(polygon, primary->edge);
    const bmr_vec32 before = polygon->normals[last], face = polygon->normals[primary->edge],
                    after = polygon->normals[next];
    if (dot(before, face) <= 0.0f || dot(face, after) <= 0.0f)
        return region_tolerance;
    const float turns = fmaxf(cross(before, face), cross(face, after)) + 4.0f * FLT_EPSILON;
    return fminf(turns, region_tolerance);
}

/// May a one-sided edge answer along this axis? False where the direction belongs to one of its neighbours.
/// Otherwise `primary` becomes the axis that is left to it.
static bool admit(const bmr_edge32 *edge, bmr_vec32 along, const bmr_convex32 *polygon, const axis32 *of_edge,
                  axis32 *primary) {
    const bool at_first = dot(primary->normal, along) <= 0.0f;
    const bmr_vec32 neighbour =
        direction(at_first ? minus(edge->first, edge->before) : minus(edge->after, edge->second));
    const bool convex = (at_first ? cross(neighbour, along) : cross(along, neighbour)) >= 0.0f;
    if (!convex) {
        *primary = *of_edge;
        return true;
    }
    const bmr_vec32 its_normal = quarter_right(neighbour), normal = quarter_right(along);
    const bmr_vec32 inner = at_first ? primary->normal : its_normal,
                    outer = at_first ? its_normal : primary->normal;
    if (!(cross(inner, outer) > region_of(polygon, primary)))
        return true;
    // A sharp vertex on a joint that is nearly flat: both edges would leave it to each other.
    const float bend = at_first ? cross(its_normal, normal) : cross(normal, its_normal);
    if (polygon->count <= 8 || !primary->of_polygon || !(bend <= region_tolerance) ||
        dot(normal, its_normal) <= 0.0f)
        return false;
    *primary = *of_edge;
    return true;
}

/// The polygon's edge, or its face where `faces_alone`, cut at the ends of the edge.
static void points_on_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge, bmr_vec32 along,
                           const axis32 *primary, const bmr_convex32 *polygon, const bmr_transform32 *frame,
                           float radius_sum, uint32_t hint, bool faces_alone) {
    manifold->type = BMR_MANIFOLD_FACE_A;
    const uint32_t best = bmr_convex32_edge_against(polygon, frame, primary->normal, hint);
    const uint32_t facing =
        faces_alone ? face_facing(polygon, best, hint, turn_back(frame, primary->normal)) : best;
    const uint32_t next = convex32_next(polygon, facing);
    clip_corner corners[2] = {corner_of(move(frame, polygon->vertices[facing]), (int32_t)facing, 0),
                              corner_of(move(frame, polygon->vertices[next]), (int32_t)next, 0)};
    const bmr_vec32 back = negative(along);
    if (!cut(corners, back, dot(back, edge->first), 0) || !cut(corners, along, dot(along, edge->second), 1))
        return;
    manifold->normal = primary->normal;
    manifold->plane_point = edge->first;
    for (int i = 0; i < 2; ++i)
        if (dot(primary->normal, minus(corners[i].v, edge->first)) <= radius_sum)
            keep(manifold, move_back(frame, corners[i].v), corners[i].feature, false);
}

/// The edge, cut at the sides of the polygon's face; where the two touch around an end of a short one,
/// nothing of the edge may lie above it, and what is nearest to it counts.
static void points_on_polygon(bmr_manifold32 *manifold, const bmr_edge32 *edge, uint32_t face,
                              const bmr_convex32 *polygon, const bmr_transform32 *frame, float radius_sum) {
    const uint32_t second = convex32_next(polygon, face);
    const bmr_vec32 v1 = move(frame, polygon->vertices[face]), v2 = move(frame, polygon->vertices[second]);
    const bmr_vec32 normal = turn(frame, polygon->normals[face]);
    const bmr_vec32 side = quarter_right(normal), other_side = negative(side);
    const clip_corner whole[2] = {{edge->second, {1, (uint8_t)face, BMR_FEATURE_VERTEX, BMR_FEATURE_FACE}},
                                  {edge->first, {0, (uint8_t)face, BMR_FEATURE_VERTEX, BMR_FEATURE_FACE}}};
    manifold->type = BMR_MANIFOLD_FACE_B;
    const int passes = polygon->count > 8 ? 2 : 1;
    for (int pass = 0; pass < passes && manifold->count == 0; ++pass) {
        const float wider = pass == 0 ? 0.0f : radius_sum;
        clip_corner corners[2] = {whole[0], whole[1]};
        if (!cut(corners, side, dot(side, v1) + wider, (int32_t)face) ||
            !cut(corners, other_side, dot(other_side, v2) + wider, (int32_t)second))
            continue;
        manifold->normal = polygon->normals[face];
        manifold->plane_point = polygon->vertices[face];
        float nearest = FLT_MAX;
        for (int i = 0; i < 2; ++i) {
            const bmr_vec32 point = corners[i].v;
            if (!(dot(normal, minus(point, v1)) <= radius_sum))
                continue;
            if (pass == 1) {
                const float outside = fmaxf(dot(side, minus(point, v1)), dot(other_side, minus(point, v2)));
                if (!(outside < nearest))
                    continue;
                nearest = outside;
                manifold->count = 0;
            }
            keep(manifold, point, corners[i].feature, true);
        }
    }
}

/// A piece instead: faces alone, and the edge alone where the piece admits it. `best` is the piece's edge of
/// largest separation, `vertex` where it is least separated from the edge. False: as of any polygon.
static bool collide_piece(bmr_manifold32 *manifold, const bmr_edge32 *edge, bmr_vec32 along,
                          const axis32 *of_edge, uint32_t vertex, const edge_search *search,
                          const edge_view *best, float radius_sum) {
    const bmr_convex32 *const polygon = search->reference;
    const bool edge_is_admitted = bmr_convex32_admits(
        polygon, vertex, negative(turn_back(&search->frame, of_edge->normal)), nearly_straight);
    const candidate face = best_face(search, best, 0.0f); // the edge, as the other, admits every direction
    const float of_faces = fmaxf(edge_is_admitted ? of_edge->separation : -FLT_MAX,
                                 face.found ? face.view.separation : -FLT_MAX);
    const float nearest = fmaxf(of_edge->separation, best->separation);
    const piece_answer answer = answer_of(nearest, of_faces, radius_sum);
    if (answer == AS_ANY_POLYGON)
        return !face.found;
    if (answer == BY_OTHER_PIECE)
        return true;
    const float enough = relative_tolerance * (of_edge->separation - radius_sum) + absolute_tolerance;
    axis32 primary = *of_edge;
    if (face.found && (!edge_is_admitted || face.view.separation - radius_sum > enough))
        primary = axis_of_polygon(&face.view);
    if (edge->one_sided && !admit(edge, along, polygon, of_edge, &primary))
        return true;
    if (primary.separation < nearest - radius_sum) // at a notch of a chain
        return false;
    if (primary.of_polygon)
        points_on_polygon(manifold, edge, primary.edge, polygon, &search->frame, radius_sum);
    else if (edge_is_admitted)
        points_on_edge(manifold, edge, along, &primary, polygon, &search->frame, radius_sum, vertex, true);
    return true;
}

void bmr_convex32_collide_edge(bmr_manifold32 *manifold, const bmr_edge32 *edge,
                               const bmr_transform32 *pose_edge, const bmr_convex32 *polygon,
                               bmr_vec32 centroid, const bmr_transform32 *pose_polygon, float radius_sum,
                               bmr_convex32_memory *memory) {
    manifold->count = 0;
    const bmr_transform32 frame = bmr_exact32_relative(pose_edge, pose_polygon);
    const bmr_vec32 along = direction(minus(edge->second, edge->first)), normal = quarter_right(along);
    if (edge->one_sided && dot(normal, minus(move(&frame, centroid), edge->first)) < 0.0f)
        return;

    uint32_t vertex = memory->support_b;
    const axis32 of_edge = axis_of_edge(polygon, &frame, edge->first, normal, &vertex);
    memory->support_b = (uint16_t)vertex;
    if (!(of_edge.separation <= radius_sum))
        return;

    // Faces of the polygon count where one separates by more than the skins, or enough more than the edge.
    const float enough = relative_tolerance * (of_edge.separation - radius_sum) + absolute_tolerance;
    const float from = enough < 0.0f ? radius_sum + enough : radius_sum;
    const bmr_vec32 ends[2] = {edge->first, edge->second};
    const bmr_convex32 segment = {ends, NULL, NULL, 2, 0, {0.0f, 0.0f}, NULL};
    const edge_search search = edge_search_of(polygon, &segment, frame, 0.0f);
    edge_found found;
    const float floor = from - FLT_EPSILON * (fabsf(from) + radius_sum);
    bmr_convex32_seek(&search, vertex, 0, polygon->seams ? -FLT_MAX : floor, &found);
    if (found.best.separation > radius_sum)
        return;
    if (polygon->seams &&
        collide_piece(manifold, edge, along, &of_edge, vertex, &search, &found.best, radius_sum))
        return;
    axis32 primary = of_edge;
    if (found.best.separation - radius_sum > enough)
        primary = axis_of_polygon(&found.best);
    if (edge->one_sided && !admit(edge, along, polygon, &of_edge, &primary))
        return;
    if (primary.of_polygon) {
        points_on_polygon(manifold, edge, primary.edge, polygon, &frame, radius_sum);
        return;
    }
    points_on_edge(manifold, edge, along, &primary, polygon, &frame, radius_sum, vertex, false);

    // The short face that faces the edge may lie beyond its end, where the face at the end would have found
    // it.
    if (manifold->count == 0 && polygon->count > 8) {
        bmr_convex32_seek(&search, vertex, 0, -FLT_MAX, &found);
        primary = axis_of_polygon(&found.best);
        if ((!edge->one_sided || admit(edge, along, polygon, &of_edge, &primary)) && primary.of_polygon)
            points_on_polygon(manifold, edge, primary.edge, polygon, &frame, radius_sum);
    }
}
