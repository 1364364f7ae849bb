// SPDX-License-Identifier: MIT
#include "exact32/exact32.h"

#include <float.h>
#include <math.h>

#include "max_edge.h"

/// The largest coordinate of 3 to 8 vectors, without sign.
static inline float largest_coordinate(const bmr_vec32 *vectors, int32_t count) {
    float4 largest = max4(abs4(load4(&vectors[0].x)), abs4(load4(&vectors[count - 2].x)));
    if (count > 4)
        largest = max4(largest, max4(abs4(load4(&vectors[2].x)), abs4(load4(&vectors[count - 4].x))));
    return most_of4(largest);
}

/// |x| + |y| of 3 to 8 vectors, the largest of each lane.
static inline float4 largest_sums(const bmr_vec32 *vectors, int32_t count) {
    const float4 first = abs4(load4(&vectors[0].x)), last = abs4(load4(&vectors[count - 2].x));
    float4 largest = add4(evens4(first, last), odds4(first, last));
    if (count > 4) {
        const float4 second = abs4(load4(&vectors[2].x)), third = abs4(load4(&vectors[count - 4].x));
        largest = max4(largest, add4(evens4(second, third), odds4(second, third)));
    }
    return largest;
}

/// What rounding may change of any separation of an edge of either from the other: 32 roundings of the
/// formulas' magnitudes, as in bmr_exact32_separates_contracted. Here one size is taken for all edges of
/// both: the largest coordinate stands for both, and of normals the sum.
static inline float margin_of(const bmr_polygon32 *a, const bmr_transform32 *pose_a, const bmr_polygon32 *b,
                              const bmr_transform32 *pose_b) {
    const float vertices =
        largest_coordinate(a->vertices, a->count) + largest_coordinate(b->vertices, b->count);
    const float normal =
        most_of4(max4(largest_sums(a->normals, a->count), largest_sums(b->normals, b->count)));
    const float turn_a = fabsf(pose_a->c) + fabsf(pose_a->s), turn_b = fabsf(pose_b->c) + fabsf(pose_b->s);
    // Of the frame of one in the other's, either way: no coordinate grows by more than this.
    const float turn = turn_a * turn_b > 1.0f ? turn_a * turn_b : 1.0f;
    const float place = fabsf(pose_a->p.x - pose_b->p.x) + fabsf(pose_a->p.y - pose_b->p.y);
    const float size = turn * normal * (turn * vertices + (turn_a > turn_b ? turn_a : turn_b) * place);
    return 32.0f * 0x1p-24f * size;
}

/// Are four edges' separations from two points (x, y, x, y) all below the limit?
static inline bool four_are_below(const bmr_vec32 *normals, const bmr_vec32 *vertices, int32_t count,
                                  float4 frame, float4 points, float4 limit) {
    const four_edges e = pose_edges(normals, vertices, count, frame);
    const float4 one = lower_by(all4(FLT_MAX), &e, splat4(points, 0), splat4(points, 1));
    const float4 both = lower_by(one, &e, splat4(points, 2), splat4(points, 3));
    return bits4(less4(only_below(count, both), limit)) == 15u;
}

/// Is every edge's separation from `other` below the limit? Asked of the two ends of one edge of `other`
/// alone, which most likely is the nearest: the least separation of all points is no more than that of some.
static inline bool all_are_below(const bmr_polygon32 *reference, float4 frame, const bmr_polygon32 *other,
                                 int32_t edge, float limit) {
    const int32_t next = edge + 1 < other->count ? edge + 1 : 0;
    const float4 ends = load_pairs4(&other->vertices[edge].x, &other->vertices[next].x), all = all4(limit);
    return four_are_below(reference->normals, reference->vertices, reference->count, frame, ends, all) &&
           (reference->count <= 4 || four_are_below(reference->normals + 4, reference->vertices + 4,
                                                    reference->count - 4, frame, ends, all));
}

/// The edge whose separation alone is more than `least`; BMR_NO_EDGE32 where several are, or none is.
static inline int32_t only_edge_above(const separations *s, float least) {
    const float4 all = all4(least);
    const unsigned hits = bits4(less4(all, s->low)) | bits4(less4(all, s->high)) << 4;
    return hits != 0u && (hits & (hits - 1u)) == 0u ? lowest_bit(hits) : BMR_NO_EDGE32;
}

int32_t bmr_exact32_face_contracted(const bmr_polygon32 *a, const bmr_transform32 *pose_a,
                                    const bmr_polygon32 *b, const bmr_transform32 *pose_b, float radius_sum,
                                    float tolerance) {
    const float margin = margin_of(a, pose_a, b, pose_b);
    const float4 at_a = load4(&pose_a->p.x), at_b = load4(&pose_b->p.x);
    const separations of_a = separate_all(a, b, relative(at_b, at_a));
    const float most_a = most_of4(max4(of_a.low, of_a.high));
    const int32_t edge_a = only_edge_above(&of_a, most_a - 2.0f * margin);
    if (most_a - margin > radius_sum && edge_a != BMR_NO_EDGE32)
        return BMR_SEPARATES32 + edge_a;
    if (!(most_a + margin < radius_sum))
        return BMR_NO_EDGE32;
    // B's is held against the sum of A's and the tolerance, which Box2D rounds, too.
    const float margins = 2.0f * margin + 0x1p-22f * tolerance;
    const float limit = most_a + tolerance - margins;
    const float4 b_in_a = relative(at_a, at_b);
    if (edge_a != BMR_NO_EDGE32 && limit + margins < radius_sum && all_are_below(b, b_in_a, a, edge_a, limit))
        return edge_a;
    const separations of_b = separate_all(b, a, b_in_a);
    const float most_b = most_of4(max4(of_b.low, of_b.high));
    const int32_t edge_b = only_edge_above(&of_b, most_b - 2.0f * margin);
    if (most_b - margin > radius_sum && edge_b != BMR_NO_EDGE32)
        return BMR_SEPARATES32 + BMR_EDGES_OF_B32 + edge_b;
    if (!(most_b + margin < radius_sum))
        return BMR_NO_EDGE32;
    if (most_b < limit)
        return edge_a; // or none
    return edge_b != BMR_NO_EDGE32 && most_b > most_a + tolerance + margins ? BMR_EDGES_OF_B32 + edge_b
                                                                            : BMR_NO_EDGE32;
}
