// SPDX-License-Identifier: MIT
// The depth of a manifold of outline pieces, compared with the separations along all normals.
#include "checks.h"
#include "convex32_poses.h"
#include "outline_pieces.h"

static const float skins = 0.02f, tolerance = 0.0005f;
static const bmr_transform32 here = {{0.0f, 0.0f}, 0.0f, 1.0f};

/// Of 3 to 12 vertices on a circle around the origin, of which each edge is inner as often as not.
static bmr_convex32_block *random_piece(dice *d) {
    bmr_piece_corner32 corners[12];
    const uint32_t count = 3 + (uint32_t)dice_in(d, 0.0, 9.99);
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * ((double)i + dice_in(d, 0.0, 0.7)) / (double)count;
        const float x = (float)cos(angle), y = (float)sin(angle);
        const float beside = (float)dice_in(d, -2.0, 2.0), out = (float)dice_in(d, 0.5, 2.0);
        corners[i] = corner(x, y, dice_in(d, 0.0, 1.0) < 0.5, out * x - beside * y, out * y + beside * x);
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
    dice d = {1};
    own_convex32 *box = polygon_of(4, 0.6f);
    const bmr_vec32 middle = {0.0f, 0.0f};
    for (int kind = 0; kind < AGAINST_ALL; ++kind) {
        int touching = 0, far_faces = 0, tips = 0;
        for (int trial = 0; trial < 1500; ++trial) {
            own_convex32 *piece = random_piece(&d), *other = random_piece(&d);
            const double angle = dice_in(&d, 0.0, 6.283), way = dice_in(&d, 0.0, 1.7);
            const double to = dice_in(&d, 0.0, 6.283);
            const bmr_transform32 pose = {
                {(float)(way * cos(to)), (float)(way * sin(to))}, (float)sin(angle), (float)cos(angle)};
            const bmr_convex32 *const second = kind == AGAINST_PIECE ? &other->polygon : &box->polygon;
            const bmr_edge32 edge = {{-1.6f, (float)dice_in(&d, -1.0, 1.0)},
                                     {-0.8f, 0.0f},
                                     {0.8f, 0.0f},
                                     {1.6f, (float)dice_in(&d, -1.0, 1.0)},
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
