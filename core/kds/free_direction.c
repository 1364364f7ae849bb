// SPDX-License-Identifier: MIT
// The free direction, for the open question of section 7: at an event the closest direction, which needs to
// be no edge's normal, is fixed in one of the two bodies, and a window of two corners of tangents stands for
// the other, in a bracket as wide as a part of the gap pays for. It needs the two sorted polygons and nothing
// more, and has at most four conditions. The structures that take it are in two_lines.c.
//
// What is proved of it (in real arithmetic; the words are those of docs/open-question.md, section 1). A step
// goes from the choice of u at the time 0 to the first failure of that line at the time 1.
//
// Lemma 1. At the end of a step x is on the line through c_0 across u_0. Let X = |x_1 - c_0| and theta the
// angle between u_0 and u_1. Then d_1 <= X sin theta and theta <= 90 degrees. Proof. c_0 is in C, so u_1.(x_1
// - c_0) = d_1 + u_1.(c_1 - c_0) >= d_1. As x_1 - c_0 is perpendicular to u_0, the left side is at most X sin
// theta.
//
// Convex translation: log2(D/sigma) + 6.3 steps. Let s = -u.t be the slope of approach, t the unit tangent.
// While s > 0, d falls; u turns towards the motion and the tangent away from C, so s falls, too. Take the
// line of a step as the horizontal axis, c_0 as origin. The path begins at height d, falling at the angle
// alpha, sin alpha = s, to the right, and turns left. Its height is a convex function that is 0 at X, where
// it falls at an angle b <= alpha, tan b <= d/X. So d_1/d <= X sin theta/d <= sin theta cot b, and s_1/s <=
// sin(b - theta)/sin b. The sum is cos theta: d_1 s_1 <= d s/4. If s_1 <= 0, d never falls again: while x is
// above the line u points up, and the tangent would have to point straight left first, with nu.u < 0. Start:
// X <= D + d_1, so d_1 >= 2D means sin theta >= 2/3; the angles alpha lose these thetas, so that is at most
// two steps, and from the third on d s < 2D. End: tan alpha >= d/X and X <= D + d, so s >= d/(D + 2d) at the
// beginning of each step but the last two. With k steps sigma^2/(D + 2 sigma) <= 2D/4^(k-5), hence 4^(k-5) <=
// 6 (D/sigma)^2.
//
// Lemma A. Under translation let h be the support function of C, blown up by m, and s_w(x) = w.x - h(w) the
// slack of the support line across w. h is sublinear: for w = a w_1 + b w_2 with a, b >= 0, h(w) <= a h(w_1)
// + b h(w_2), so s_w >= a s_(w_1) + b s_(w_2). So while two support lines whose directions bracket w both
// stand, the one across w stands. Let W be a set of directions so that at each choice of u either u is in W
// or two of W bracket u, less than half a turn apart, and stand. Then in each step some w of W that stood at
// its beginning has failed by its end. Steps are disjoint, so they have no more failures than W. If each s_w
// has at most a zeros with their multiplicities (polynomials of degree a do), a line across w fails at most
// ceil(a/2) times, for between two failures it comes to stand again. So there are at most ceil(a/2) |W|
// steps.
//
// (i) W of N + 12 directions, for m <= sigma: the normals of C's edges, the eight axes of both frames, and
// four more, so that no two neighbours are more than 45 degrees apart. Proof. If the foot is inside an edge
// of C without m, u is its normal. Else it is a vertex c. The two of W next to u on both sides are in c's
// cone of normals, as the cone's ends are in W. With d = g + m the slack of w is d cos(w, u) - m > 0.7 (g +
// m) - m > 0. These directions count all failures of hybrid and of two-lines, handovers included: a coarse
// line's failure is that of its own direction, which is one of the N + 8, at a time of its own.
//
// (ii) W of at most 9 sqrt(D/sigma) + 1 directions, for any m: those of Dudley's approximation. Take D for
// sigma if sigma > D. C is in a disc of radius D/sqrt3. Let k >= 9 sqrt(D/sigma) points z_i divide a circle
// of radius 1.58 D about that disc's centre; they are at least D away from C. Let c_i be the foot and u_i the
// closest direction of z_i. For z_i, and any z from there to the next point z_j, the chord is at most t = 2
// pi 1.58 D/k, t^2 <= 1.22 D sigma, and (z - z_i).(u - u_i) is the sum of (c - c_i).(u - u_i) >= 0 and of at
// least D |u - u_i|^2. So |u - u_i| <= t/D <= 1.11: u turns by less than a right angle from z_i to z_j. And
// (c_j - c_i).(u_j - u_i) <= t y - D y^2 <= t^2/(4 D), y = |u_j - u_i|. While z goes around, u passes all
// directions in order. So the u of a choice lies between some u_i and u_j, and its foot c between c_i and c_j
// on the boundary. Hence u_i.(c_i - c) <= u_i.(c_i - c_j) <= (c_i - c_j).(u_i - u_j), for u_j.(c_i - c_j) <=
// 0. The slack of u_i at x = c + g u is g u_i.u - u_i.(c_i - c) >= g (1 - t^2/(2 D^2)) - t^2/(4 D) >= sigma
// (1 - 0.61)
// - 0.31 sigma > 0, and that of u_j likewise.
//
// Hysteresis. Under translation the slack at an event is g, and a translation by tau changes it by at most
// |tau|: beta = 1. In a disc of radius at most a third of its centre's distance from C two events could only
// be at opposite ends of a diameter, the first nearest to C, and then the second is not on its line: kappa =
// 3. With rotation let tau and delta be the translation (of a point of Q in P's frame) and the rotation since
// an event, G the body with the window. The next event needs one of
// - |tau| + (D + 2g) |delta| >= (1 - gamma) g: a corner is within D + 2g of the point of reference, and its
//   slack was (1 - gamma) g;
// - |delta| >= min{75 degrees, 2 atan(gamma g/(2 D_G))}: two tangents of G that differ by delta meet at most
//   (D_G/2) tan(delta/2) above their chord, and the bracket goes on until one meets the old one gamma g/4
//   above it and the next costs more than gamma g;
// - after a known spin has turned back, |delta| >= min{15 degrees, 2 atan(gamma g/(32 D_G))}: the short side
//   of a leaning bracket.
//
// Algebraic rigid motion: O(D/sigma + log(R/D)) steps. A step from a gap g takes |tau| + D |delta| of
// Omega(g), and for g <= D that is Omega(sigma). An algebraic path of bounded degree has length O(D) in a
// disc of radius O(D), and its rotation is O(1): O(D/sigma) steps there. Farther away a step takes |delta| =
// Omega(1) or |tau| = Omega(g), of which each doubling of g has O(1): O(log(R/D)).
#include "kds/windowed_line.h"

/// Which of two bodies' lines is better to have: the one that lasts longer at the rates of this instant;
/// where these are unknown or tell nothing, the one whose window has the wider bracket.
static int better_owner(const bmr_kds *kds, const bmr_instant *now, const bmr_windowed_line made[2],
                        int spin) {
    double time[2], life[2];
    for (int owner = 0; owner < 2; ++owner) {
        time[owner] = bmr_windowed_time(&made[owner], kds, now);
        life[owner] = bmr_windowed_life(&made[owner], &now->pose, bmr_windowed_sense(owner, spin));
    }
    if (time[0] != time[1])
        return time[1] > time[0] ? 1 : 0;
    return life[1] < life[0] ? 1 : 0;
}

void bmr_free_direction_lay(const bmr_kds *kds, const bmr_instant *now, bmr_vec2 direction, double gap,
                            int spin, const uint32_t support[2], bmr_windowed_line *line) {
    bmr_windowed_line made[2];
    for (int owner = 0; owner < 2; ++owner) {
        bmr_windowed_line_set(&made[owner], kds, &now->pose, owner, direction, support);
        bmr_windowed_corners(&made[owner], kds, &now->pose, BMR_WINDOW_PART * gap,
                             bmr_windowed_sense(owner, spin));
    }
    *line = made[better_owner(kds, now, made, spin)];
}
