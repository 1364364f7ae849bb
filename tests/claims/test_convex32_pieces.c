// SPDX-License-Identifier: MIT
// Pieces of outlines: what they know of their seams, where they leave contacts to their neighbours, and how
// rays come into them, and past the ends of their inner edges.
#include "checks.h"
#include "convex32/convex32_pieces.h"
#include "convex32_poses.h"

static const float skins = 0.02f, tolerance = 0.0005f;
static const bmr_transform32 here = {{0.0f, 0.0f}, 0.0f, 1.0f};

/// `inner`: so is the edge that begins here. The outline goes on to (to_x, to_y) where the piece does not.
static bmr_piece_corner32 corner(float x, float y, bool inner, float to_x, float to_y) {
    const bmr_piece_corner32 c = {{x, y}, {to_x, to_y}, inner};
    return c;
}

static bmr_convex32_block *made_piece(const bmr_piece_corner32 *corners, size_t count) {
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, count, NULL, &block), BMR_OK);
    return block;
}

/// The right one of two squares of a flat ground, or of one that goes on to the left at another height: its
/// left side is inner. The outline goes on from its upper left corner to (-1, before), and comes to its lower
/// one from as far the other way.
static bmr_convex32_block *right_half(float before) {
    const bmr_piece_corner32 corners[] = {
        corner(0.0f, -1.0f, false, -1.0f, -1.0f - before), corner(1.0f, -1.0f, false, 0.0f, 0.0f),
        corner(1.0f, 0.0f, false, 0.0f, 0.0f), corner(0.0f, 0.0f, true, -1.0f, before)};
    return made_piece(corners, 4);
}

/// The manifold of the piece and another polygon; its normal in the world, from the piece.
static bmr_manifold32 collide(const bmr_convex32_block *piece, const bmr_convex32_block *other,
                              bmr_transform32 pose, bmr_vec32 *normal) {
    bmr_manifold32 m;
    memset(&m, 0, sizeof m);
    bmr_convex32_memory memory = {0, 0, 0, 0};
    bmr_convex32_collide(&m, &piece->polygon, &here, &other->polygon, &pose, skins, tolerance, &memory);
    const float sign = m.type == BMR_MANIFOLD_FACE_A ? 1.0f : -1.0f;
    normal->x = sign * m.normal.x;
    normal->y = sign * m.normal.y;
    return m;
}

static bmr_manifold32 touch_circle(const bmr_convex32_block *piece, float x, float y, float radius) {
    bmr_manifold32 m;
    memset(&m, 0, sizeof m);
    bmr_convex32_memory memory = {0, 0, 0, 0};
    const bmr_vec32 centre = {x, y};
    bmr_convex32_collide_circle(&m, &piece->polygon, &here, centre, &here, radius + 0.5f * skins, &memory);
    return m;
}

TEST(corners_turn_as_the_outline_does) {
    const bmr_vec32 up = {0.0f, 1.0f}, left_up = {-0.6f, 0.8f}, left = {-1.0f, 0.0f}, down = {0.0f, -1.0f};
    const bmr_vec32 left_down = {-0.6f, -0.8f};
    bmr_convex32_block *flat = right_half(0.0f), *falling = right_half(-2.0f), *rising = right_half(2.0f);
    for (int i = 0; i < 3; ++i) {
        const bmr_convex32_block *const block = i == 0 ? flat : i == 1 ? falling : rising;
        assert_int_equal(block->polygon.count, 4);
        assert_true(bmr_convex32_admits(&block->polygon, 3, up, 1e-3f));
        assert_int_equal(bmr_convex32_admits(&block->polygon, 3, left_up, 1e-3f), i == 1);
        assert_false(bmr_convex32_admits(&block->polygon, 3, left, 1e-3f));
        assert_true(bmr_convex32_admits(&block->polygon, 0, down, 1e-3f));
        assert_int_equal(bmr_convex32_admits(&block->polygon, 0, left_down, 1e-3f), i == 1);
        const bmr_vec32 right_down = {0.6f, -0.8f};
        assert_false(bmr_convex32_admits(&block->polygon, 0, right_down, 1e-3f));
        // The corner between two faces is as of any polygon; the inner edge is the last.
        const bmr_vec32 right_up = {0.6f, 0.8f};
        assert_true(bmr_convex32_admits(&block->polygon, 2, right_up, 1e-3f));
        assert_int_equal(block->seams.inner[3], 1);
        assert_int_equal(block->seams.inner[0] + block->seams.inner[1] + block->seams.inner[2], 0);
        bmr_convex32_destroy((bmr_convex32_block *)block, NULL);
    }
}

TEST(a_corner_between_inner_edges_admits_nothing) {
    const bmr_piece_corner32 corners[] = {corner(0.0f, 0.0f, true, 0.0f, 0.0f),
                                          corner(1.0f, 0.0f, false, 0.0f, -1.0f),
                                          corner(0.0f, 1.0f, true, -1.0f, 0.0f)};
    own_convex32 *block = made_piece(corners, 3);
    for (int i = 0; i < 16; ++i) {
        const bmr_vec32 d = {cosf(0.4f * (float)i), sinf(0.4f * (float)i)};
        assert_false(bmr_convex32_admits(&block->polygon, 0, d, 1e-3f));
    }
}

TEST(straight_corners_are_left_out_and_faces_stay_faces) {
    // Below an inner edge and a face in one line, above a face and an inner edge; on the right two inner
    // edges.
    const bmr_piece_corner32 corners[] = {
        corner(0.0f, 0.0f, true, 0.0f, -1.0f), corner(1.0f, 0.0f, false, 1.0f, -1.0f),
        corner(2.0f, 0.0f, true, 3.0f, 0.0f),  corner(2.0f, 1.0f, true, 0.0f, 0.0f),
        corner(2.0f, 2.0f, false, 3.0f, 2.0f), corner(1.0f, 2.0f, true, 1.0f, 3.0f),
        corner(0.0f, 2.0f, false, -1.0f, 2.0f)};
    bmr_convex32_block *block = NULL;
    assert_int_equal(bmr_convex32_create_piece(corners, 7, NULL, &block), BMR_OK);
    assert_int_equal(block->polygon.count, 4);
    const uint8_t inner[] = {0, 1, 0, 0};
    assert_memory_equal(block->seams.inner, inner, 4);
    bmr_convex32_destroy(block, NULL);
    // Also where the list begins in the middle of a line.
    for (size_t first = 1; first < 7; ++first) {
        bmr_piece_corner32 turned[7];
        memcpy(turned, corners + first, (7 - first) * sizeof *turned);
        memcpy(turned + 7 - first, corners, first * sizeof *turned);
        assert_int_equal(bmr_convex32_create_piece(turned, 7, NULL, &block), BMR_OK);
        assert_int_equal(block->polygon.count, 4);
        for (uint32_t i = 0; i < 4; ++i)
            assert_int_equal(block->seams.inner[i], block->polygon.normals[i].x > 0.5f);
        bmr_convex32_destroy(block, NULL);
    }
}

TEST(what_is_no_piece_is_an_error) {
    bmr_convex32_block *block = NULL, *const before = block;
    const bmr_piece_corner32 line[] = {corner(0.0f, 0.0f, false, 0.0f, 0.0f),
                                       corner(1.0f, 0.0f, false, 0.0f, 0.0f),
                                       corner(2.0f, 0.0f, true, 0.0f, 0.0f)};
    bmr_piece_corner32 odd[3];
    memcpy(odd, line, sizeof odd);
    odd[1].vertex.y = NAN;
    assert_int_equal(bmr_convex32_create_piece(line, 3, NULL, &block), BMR_ERROR_TOO_FEW_POINTS);
    assert_int_equal(bmr_convex32_create_piece(line, 2, NULL, &block), BMR_ERROR_TOO_FEW_POINTS);
    assert_int_equal(bmr_convex32_create_piece(odd, 3, NULL, &block), BMR_ERROR_NOT_FINITE);
    odd[1].vertex.y = 1e10f;
    assert_int_equal(bmr_convex32_create_piece(odd, 3, NULL, &block), BMR_ERROR_OUT_OF_RANGE);
    assert_int_equal(bmr_convex32_create_piece(line, 70000, NULL, &block), BMR_ERROR_TOO_MANY_POINTS);
    assert_ptr_equal(block, before);
}

TEST(straight_stretches_with_seams_carry_each_other) {
    // Two such grounds lie on each other, the upper one a little askew: each piece's corner at its seam
    // belongs to a straight stretch.
    own_convex32 *ground = right_half(0.0f);
    const bmr_piece_corner32 corners[] = {
        corner(-0.5f, 0.0f, false, -1.5f, 0.0f), corner(0.5f, 0.0f, false, 0.0f, 0.0f),
        corner(0.5f, 1.0f, false, 0.0f, 0.0f), corner(-0.5f, 1.0f, true, -1.5f, 1.0f)};
    own_convex32 *upper = made_piece(corners, 4);
    for (int i = -4; i <= 4; ++i) {
        const float turn = 0.004f * (float)i;
        const bmr_transform32 pose = {{0.4f, 0.005f}, sinf(turn), cosf(turn)};
        bmr_vec32 normal;
        assert_true(collide(ground, upper, pose, &normal).count > 0);
        assert_true(normal.y > 0.99f);
    }
}

TEST(a_circle_is_pushed_by_faces_and_corners_of_the_outline) {
    own_convex32 *flat = right_half(0.0f), *falling = right_half(-2.0f);
    assert_int_equal(touch_circle(flat, 0.1f, 0.3f, 0.3f).count, 1);
    assert_int_equal(touch_circle(flat, -0.1f, 0.28f, 0.3f).count, 0);
    const bmr_manifold32 m = touch_circle(falling, -0.1f, 0.28f, 0.3f);
    assert_int_equal(m.count, 1);
    assert_true(m.normal.x < -0.3f && m.normal.y > 0.9f);
    // Beside the inner edge there is nothing, and its middle is not pushed out of it.
    assert_int_equal(touch_circle(flat, -0.1f, -0.5f, 0.3f).count, 0);
    const bmr_manifold32 inside = touch_circle(flat, 0.02f, -0.1f, 0.3f);
    assert_int_equal(inside.count, 1);
    assert_true(inside.normal.y > 0.99f);
    // But what is far below the surface is not thrown up to it.
    const bmr_manifold32 far_below = touch_circle(flat, 0.02f, -0.45f, 0.3f);
    assert_int_equal(far_below.count, 1);
    assert_true(far_below.normal.x < -0.99f);
}

TEST(an_edge_is_touched_by_faces_alone) {
    // The piece as a body on an edge, upside down: its inner side is on the right.
    own_convex32 *piece = right_half(0.0f);
    const bmr_transform32 upside_down = {{0.0f, 0.01f}, 0.0f, -1.0f};
    const bmr_edge32 floor = {{6.0f, 0.0f}, {5.0f, 0.0f}, {-5.0f, 0.0f}, {-6.0f, 0.0f}, true};
    const bmr_edge32 wall = {{0.0f, 0.0f}, {0.01f, 0.5f}, {0.01f, 3.0f}, {0.0f, 0.0f}, false};
    const bmr_vec32 middle = {0.5f, -0.5f};
    bmr_manifold32 m;
    memset(&m, 0, sizeof m);
    bmr_convex32_memory memory = {0, 0, 0, 0};
    bmr_convex32_collide_edge(&m, &floor, &here, &piece->polygon, middle, &upside_down, skins, &memory);
    assert_int_equal(m.count, 2);
    assert_true(fabsf(m.normal.y) > 0.99f);
    bmr_convex32_collide_edge(&m, &wall, &here, &piece->polygon, middle, &upside_down, skins, &memory);
    assert_int_equal(m.count, 0);
    bmr_convex32_block plain = *piece; // the control
    plain.polygon.seams = NULL;
    bmr_convex32_collide_edge(&m, &wall, &here, &plain.polygon, middle, &upside_down, skins, &memory);
    assert_true(m.count > 0);
}

// ---- rays ----

/// How a ray comes in that hits edge `edge` of the piece at half of its way, if nothing else is given.
typedef struct entry_found {
    bmr_entry32 entry;
    double fraction;
    bmr_vec32 corner;
} entry_found;

static entry_found enter(const bmr_convex32_block *piece, float x1, float y1, float x2, float y2,
                         uint32_t edge) {
    const bmr_vec32 p1 = {x1, y1}, p2 = {x2, y2};
    const bmr_piece_ray32 ray = bmr_convex32_piece_ray(p1, p2, 2.0f);
    entry_found found = {BMR_ENTRY_FACE, 0.5, {9.0f, 9.0f}};
    found.entry = bmr_convex32_entry(piece, &ray, edge, &found.fraction, &found.corner);
    return found;
}

TEST(a_ray_comes_in_by_faces_and_past_ends_of_inner_edges) {
    own_convex32 *piece = right_half(0.0f);
    assert_int_equal(enter(piece, 0.5f, 0.5f, 0.5f, -0.5f, 2).entry, BMR_ENTRY_FACE);
    assert_int_equal(enter(piece, -0.5f, -0.5f, 0.5f, -0.5f, 3).entry, BMR_ENTRY_INNER);
    assert_int_equal(enter(piece, -0.5f, 0.499f, 0.5f, -0.501f, 3).entry, BMR_ENTRY_INNER);
    const entry_found through = enter(piece, -0.5f, 0.5f, 0.5f, -0.5f, 3);
    assert_int_equal(through.entry, BMR_ENTRY_CORNER);
    assert_true(through.corner.x == 0.0f && through.corner.y == 0.0f && through.fraction == 0.5);
    // Along the inner edge rounding says anything of where; it comes in at the end that is first.
    const entry_found down = enter(piece, 0.0f, 0.25f, 0.0f, -1.25f, 3);
    assert_int_equal(down.entry, BMR_ENTRY_CORNER);
    assert_true(down.corner.y == 0.0f && fabs(down.fraction - 1.0 / 6.0) < 1e-12);
    // From afar rounding is more.
    assert_int_equal(enter(piece, -1e5f, 1e5f + 0.1f, 1e5f, -1e5f + 0.1f, 3).entry, BMR_ENTRY_CORNER);
    // It passes the far end, after it has come in far from any.
    assert_int_equal(enter(piece, -4.5e-6f, 0.0f, 4.5e-6f, -1.5f, 3).entry, BMR_ENTRY_INNER);
    assert_int_equal(enter(piece, -0.5f, 0.0f, 0.5f, -2.0f, 3).entry, BMR_ENTRY_CORNER);
    assert_int_equal(enter(piece, -1.0f, 0.0f, 1.0f, -0.5f, 3).entry, BMR_ENTRY_INNER);
}

TEST(a_ray_comes_through_what_is_inside_of_faces_or_beside_seams) {
    own_convex32 *piece = right_half(0.0f);
    const bmr_vec32 beside[] = {{-1e-6f, -0.5f}, {1e-6f, -0.5f}, {0.5f, -1e-6f}, {0.5f, 1e-6f},
                                {0.5f, -0.5f},   {-0.1f, -0.5f}, {0.5f, 0.1f}};
    const bool through[] = {true, true, false, false, true, false, false};
    for (size_t i = 0; i < sizeof beside / sizeof *beside; ++i) {
        const bmr_vec32 far_on = {5.0f, -5.0f};
        const bmr_piece_ray32 ray = bmr_convex32_piece_ray(beside[i], far_on, 2.0f);
        // At its begin: nothing before that is asked.
        assert_int_equal(bmr_convex32_comes_through(piece, &ray, 0.0), through[i]);
        assert_int_equal(bmr_convex32_comes_through(piece, &ray, 1e-6), through[i]);
    }
}

TEST(a_corner_is_entered_by_the_face_that_is_run_against) {
    own_convex32 *piece = right_half(0.0f);
    const bmr_vec32 right_corner = {1.0f, 0.0f}, left_corner = {0.0f, 0.0f}, middle = {0.5f, 0.0f};
    const bmr_vec32 steep = {2.0f, 2.0f}, flat = {4.0f, 1.0f}, below = {2.0f, -1.0f}, on = {2.0f, 0.0f};
    const bmr_vec32 hardly_above = {2.0f, 1e-6f}, other_side = {-2.0f, 0.5f};
    const struct {
        bmr_vec32 p1, corner, normal; ///< {0, 0}: none is
    } cases[] = {{steep, right_corner, {0.0f, 1.0f}},     {flat, right_corner, {1.0f, 0.0f}},
                 {below, right_corner, {1.0f, 0.0f}},     {steep, left_corner, {0.0f, 1.0f}},
                 {steep, middle, {0.0f, 1.0f}},           {below, left_corner, {0.0f, 0.0f}},
                 {on, left_corner, {0.0f, 0.0f}},         {hardly_above, left_corner, {0.0f, 0.0f}},
                 {other_side, left_corner, {0.0f, 1.0f}}, {steep, {1.5f, 0.0f}, {0.0f, 0.0f}},
                 {steep, {0.5f, 0.1f}, {0.0f, 0.0f}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const bmr_vec32 p1 = cases[i].p1, c = cases[i].corner;
        const bmr_vec32 p2 = {p1.x + 2.0f * (c.x - p1.x) - 0.001f, p1.y + 2.0f * (c.y - p1.y)};
        const bmr_piece_ray32 ray = bmr_convex32_piece_ray(p1, p2, 2.0f);
        bmr_vec32 normal = {0.0f, 0.0f};
        double against = 0.0;
        bmr_convex32_face_against(piece, &ray, c, &against, &normal);
        assert_true(normal.x == cases[i].normal.x && normal.y == cases[i].normal.y);
        assert_int_equal(against < 0.0, normal.x + normal.y != 0.0f);
    }
}

// ---- depths, compared with the separations along all normals ----

/// Of 3 to 12 vertices on a circle around the origin, of which each edge is inner as often as not.
static bmr_convex32_block *random_piece(test_random *d) {
    bmr_piece_corner32 corners[12];
    const uint32_t count = 3 + (uint32_t)test_random_uniform(d, 0.0, 9.99);
    for (uint32_t i = 0; i < count; ++i) {
        const double angle =
            6.283185307179586 * ((double)i + test_random_uniform(d, 0.0, 0.7)) / (double)count;
        const float x = (float)cos(angle), y = (float)sin(angle);
        const float beside = (float)test_random_uniform(d, -2.0, 2.0),
                    out = (float)test_random_uniform(d, 0.5, 2.0);
        corners[i] =
            corner(x, y, test_random_uniform(d, 0.0, 1.0) < 0.5, out * x - beside * y, out * y + beside * x);
    }
    return made_piece(corners, count);
}

static bmr_vec32 moved(const bmr_transform32 *pose, bmr_vec32 v) {
    const bmr_vec32 m = {pose->c * v.x - pose->s * v.y + pose->p.x,
                         pose->s * v.x + pose->c * v.y + pose->p.y};
    return m;
}

/// Along the normal, of the least separated of these points, from the plane through `origin`.
static float separation_along(const bmr_vec32 *points, uint32_t count, const bmr_transform32 *pose,
                              bmr_vec32 normal, bmr_vec32 origin) {
    float least = INFINITY;
    for (uint32_t i = 0; i < count; ++i) {
        const bmr_vec32 v = moved(pose, points[i]);
        least = fminf(least, normal.x * (v.x - origin.x) + normal.y * (v.y - origin.y));
    }
    return least;
}

/// The largest separation along a polygon's normals: by every edge and every vertex.
static float largest_separation(const bmr_convex32 *polygon, const bmr_transform32 *pose,
                                const bmr_vec32 *points, uint32_t count, const bmr_transform32 *pose_points) {
    float largest = -INFINITY;
    const bmr_transform32 turned = {{0.0f, 0.0f}, pose->s, pose->c};
    for (uint32_t i = 0; i < polygon->count; ++i)
        largest =
            fmaxf(largest, separation_along(points, count, pose_points, moved(&turned, polygon->normals[i]),
                                            moved(pose, polygon->vertices[i])));
    return largest;
}

/// The separation of a manifold's deepest point; infinite without points.
static float deepest(const bmr_manifold32 *m, const bmr_transform32 *pose_a, const bmr_transform32 *pose_b) {
    const bool of_a = m->type == BMR_MANIFOLD_FACE_A;
    const bmr_transform32 *const face = of_a ? pose_a : pose_b, *const other = of_a ? pose_b : pose_a;
    const bmr_transform32 turned = {{0.0f, 0.0f}, face->s, face->c};
    float least = INFINITY;
    for (uint32_t i = 0; i < (uint32_t)m->count; ++i)
        least = fminf(least, separation_along(&m->points[i].point, 1, other, moved(&turned, m->normal),
                                              moved(face, m->plane_point)));
    return least;
}

/// Is the vertex of the other that is deepest below the manifold's face in the piece that has the face, as
/// far as its inner edges tell?
static bool is_of_a_tip(const bmr_manifold32 *m, const bmr_convex32 *a, const bmr_transform32 *pose_a,
                        const bmr_convex32 *b, const bmr_transform32 *pose_b) {
    const bool of_a = m->type == BMR_MANIFOLD_FACE_A;
    const bmr_convex32 *const piece = of_a ? a : b, *const other = of_a ? b : a;
    const bmr_transform32 *const pose = of_a ? pose_a : pose_b, *const pose_other = of_a ? pose_b : pose_a;
    const bmr_transform32 turned = {{0.0f, 0.0f}, pose->s, pose->c};
    const bmr_vec32 down = moved(&turned, m->normal);
    bmr_vec32 deepest_vertex = {0.0f, 0.0f};
    float least = INFINITY;
    for (uint32_t i = 0; i < other->count; ++i) {
        const bmr_vec32 v = moved(pose_other, other->vertices[i]);
        if (down.x * v.x + down.y * v.y < least) {
            least = down.x * v.x + down.y * v.y;
            deepest_vertex = v;
        }
    }
    if (!piece->seams)
        return false;
    for (uint32_t i = 0; i < piece->count; ++i) {
        const bmr_vec32 n = moved(&turned, piece->normals[i]), v = moved(pose, piece->vertices[i]);
        if (piece->seams->inner[i] && n.x * (deepest_vertex.x - v.x) + n.y * (deepest_vertex.y - v.y) > 1e-6f)
            return false;
    }
    return true;
}

enum { AGAINST_POLYGON, AGAINST_PIECE, AGAINST_EDGE, AGAINST_CHAIN, AGAINST_CIRCLE, AGAINST_ALL };

/// A piece pushes a shape no farther than the plain polygon does, plus one skin. A tip that ends in the piece
/// may go ten skins farther. This holds at any pose and with any seams. The control: the piece's nearest face
/// is often farther away.
TEST(no_manifold_is_deeper_than_the_plain_polygons) {
    test_random d = test_random_from(1);
    const bmr_vec32 corners[] = {{0.42f, 0.42f}, {-0.42f, 0.42f}, {-0.42f, -0.42f}, {0.42f, -0.42f}};
    own_convex32 *box = made_convex32(corners, 4);
    const bmr_vec32 middle = {0.0f, 0.0f};
    for (int kind = 0; kind < AGAINST_ALL; ++kind) {
        int touching = 0, far_faces = 0, tips = 0;
        for (int trial = 0; trial < 1500; ++trial) {
            own_convex32 *piece = random_piece(&d), *other = random_piece(&d);
            const double angle = test_random_uniform(&d, 0.0, 6.283), way = test_random_uniform(&d, 0.0, 1.7);
            const double to = test_random_uniform(&d, 0.0, 6.283);
            const bmr_transform32 pose = {
                {(float)(way * cos(to)), (float)(way * sin(to))}, (float)sin(angle), (float)cos(angle)};
            const bmr_convex32 *const second = kind == AGAINST_PIECE ? &other->polygon : &box->polygon;
            const bmr_edge32 edge = {{-1.6f, (float)test_random_uniform(&d, -1.0, 1.0)},
                                     {-0.8f, 0.0f},
                                     {0.8f, 0.0f},
                                     {1.6f, (float)test_random_uniform(&d, -1.0, 1.0)},
                                     kind == AGAINST_CHAIN};
            const bmr_vec32 ends[2] = {edge.first, edge.second}, up = {0.0f, 1.0f}, down = {0.0f, -1.0f};
            const float radii = kind == AGAINST_CIRCLE ? 0.21f : skins;
            bmr_manifold32 m, plain;
            memset(&m, 0, sizeof m);
            memset(&plain, 0, sizeof plain);
            float nearest, slack = 0.0f;
            for (int seams = 1; seams >= 0; --seams) {
                bmr_convex32 polygon = piece->polygon, against = *second;
                if (seams == 0)
                    polygon.seams = against.seams = NULL;
                bmr_manifold32 *const to_fill = seams ? &m : &plain;
                bmr_convex32_memory memory = {0, 0, 0, 0};
                if (kind == AGAINST_POLYGON || kind == AGAINST_PIECE)
                    bmr_convex32_collide(to_fill, &polygon, &here, &against, &pose, radii, tolerance,
                                         &memory);
                else if (kind == AGAINST_CIRCLE)
                    bmr_convex32_collide_circle(to_fill, &polygon, &here, middle, &pose, radii, &memory);
                else
                    bmr_convex32_collide_edge(to_fill, &edge, &here, &polygon, middle, &pose, radii, &memory);
            }
            const bmr_convex32 *const p = &piece->polygon;
            const bool by_edge = kind == AGAINST_EDGE || kind == AGAINST_CHAIN;
            const bmr_vec32 *const points = by_edge                  ? ends
                                            : kind == AGAINST_CIRCLE ? &middle
                                                                     : second->vertices;
            const uint32_t count = by_edge ? 2 : kind == AGAINST_CIRCLE ? 1 : second->count;
            const bmr_transform32 *const pose_p = by_edge ? &pose : &here, *const pose_o =
                                                                               by_edge ? &here : &pose;
            nearest = largest_separation(p, pose_p, points, count, pose_o);
            if (kind == AGAINST_POLYGON || kind == AGAINST_PIECE)
                nearest = fmaxf(nearest, largest_separation(second, pose_o, p->vertices, p->count, pose_p));
            if (by_edge) {
                nearest = fmaxf(nearest, separation_along(p->vertices, p->count, pose_p, up, edge.first));
                nearest = fmaxf(nearest, separation_along(p->vertices, p->count, pose_p, down, edge.first));
                slack = 0.001f + 0.021f * (skins - nearest); // Box2D's own of edges
            }
            // Between an edge's neighbours a plain polygon may be deeper itself.
            const float of_plain = deepest(&plain, &here, &pose), of_piece = deepest(&m, &here, &pose);
            const float beyond_plain = fminf(nearest, of_plain) - slack - 2.0f * tolerance - of_piece;
            if (beyond_plain > radii) {
                assert_true(kind == AGAINST_POLYGON || kind == AGAINST_PIECE);
                assert_true(beyond_plain <= 10.0f * radii);
                assert_true(is_of_a_tip(&m, p, &here, second, &pose));
                ++tips;
            }
            touching += m.count > 0;
            float of_faces = -INFINITY;
            for (uint32_t i = 0; i < p->count; ++i)
                if (!p->seams || !p->seams->inner[i])
                    of_faces =
                        fmaxf(of_faces,
                              separation_along(points, count, pose_o,
                                               moved(&(bmr_transform32){{0.0f, 0.0f}, pose_p->s, pose_p->c},
                                                     p->normals[i]),
                                               moved(pose_p, p->vertices[i])));
            far_faces += m.count > 0 && of_faces < nearest - radii - slack - 2.0f * tolerance;
        }
        assert_true(touching > 300);
        assert_true(far_faces > 30);
        assert_true((tips > 0) == (kind == AGAINST_POLYGON || kind == AGAINST_PIECE));
    }
}
