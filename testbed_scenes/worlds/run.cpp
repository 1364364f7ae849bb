// SPDX-License-Identifier: MIT
#include "worlds/world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <numeric>

#include "boomerang/distance.h"
#include "theory/course.h"

namespace testbed {
namespace {

/// A change of plan: this part of the time until the next is spent on the way to the new velocity.
constexpr double kTurning = 0.4;

std::string NameOf(bmr_body body) {
    static const char *const walls[BMR_WALLS] = {"the left wall", "the right wall", "the bottom wall",
                                                 "the top wall"};
    return bmr_is_wall(body) ? walls[body - BMR_WALL(0)] : "body " + std::to_string(body);
}

[[noreturn]] void Stop(bmr_error error, const bmr_world *world, const WorldChoice &choice) {
    const bmr_world_trouble trouble = bmr_world_get_trouble(world);
    const bool known = trouble.error == error && trouble.kind != BMR_TROUBLE_OTHER;
    char text[64];
    std::snprintf(text, sizeof text, "the world stopped at time %.9g: ", bmr_world_time(world));
    std::string why = text;
    if (trouble.error == error && trouble.a != BMR_NO_BODY)
        why += NameOf(trouble.a) + (trouble.b != BMR_NO_BODY ? " and " + NameOf(trouble.b) : "") + ": ";
    why += known ? bmr_trouble_describe(trouble.kind) : bmr_error_describe(error);
    if (error == BMR_ERROR_STALLED)
        why += choice.zeno == BMR_ZENO_ERROR ? " (--zeno elastic answers slow contacts elastically)"
                                             : " (a larger --zeno-speed may end these contacts)";
    throw std::runtime_error(why);
}

} // namespace

WorldRun::WorldRun(const WorldSetup &setup, WorldFrames *frames)
    : m_setup(setup), m_frames(frames), m_dice(setup.choice.seed + 1) {
    const WorldChoice &choice = setup.choice;
    bmr_world_def def = bmr_default_world_def();
    Require(bmr_kds_find(choice.structure.c_str(), &def.structure), choice.structure);
    def.boundary = choice.boundary;
    def.low = setup.low;
    def.high = setup.high;
    def.response = choice.response;
    def.zeno = choice.zeno;
    def.zeno_speed = choice.zenoSpeed;
    def.all_pairs = choice.allPairs;
    def.context = this;
    if (m_frames != nullptr) {
        def.contact = Answer;
        def.observer = Observe;
    }
    bmr_world *world = nullptr;
    Require(bmr_world_create(&def, 0.0, nullptr, &world), "the world");
    m_world.reset(world);
    AddBodies();
    m_atStart = Totals();
}

void WorldRun::AddBodies() {
    for (const WorldBody &body : m_setup.bodies) {
        const bmr_motion_piece piece = bmr_piece_screw(0.0, body.pose, body.velocity, body.spin);
        bmr_motion *motion = nullptr;
        Require(bmr_motion_create(&piece, nullptr, &motion), "a motion");
        const MotionPointer owner(motion);
        const bmr_shape shape = body.polygon->Shape();
        const bmr_body_def def = bmr_default_body_def(&shape, motion);
        bmr_body number = BMR_NO_BODY;
        Require(bmr_world_add(m_world.get(), &def, &number), "a body");
        m_momentumScale += def.mass * std::hypot(body.velocity.x, body.velocity.y);
        if (m_setup.planEvery > 0.0)
            m_plans.push({m_dice.Uniform(0.0, m_setup.planEvery), number});
    }
}

bmr_response WorldRun::Answer(void *context, bmr_world * /*world*/, const bmr_contact *contact) {
    auto *run = static_cast<WorldRun *>(context);
    run->m_frames->Add(*contact);
    return run->m_setup.choice.response;
}

void WorldRun::Observe(void *context, bmr_world * /*world*/, const bmr_world_event *event) {
    static_cast<WorldRun *>(context)->m_frames->Add(*event);
}

void WorldRun::AdvancePlain(double until) {
    const bmr_error error = bmr_world_advance(m_world.get(), until);
    if (error != BMR_OK)
        Stop(error, World(), m_setup.choice);
}

void WorldRun::Advance(double until) {
    while (!m_plans.empty() && m_plans.top().time <= until) {
        const Plan plan = m_plans.top();
        m_plans.pop();
        AdvancePlain(plan.time);
        ChangePlan(plan.body);
        m_plans.push({plan.time + m_setup.planEvery * m_dice.Uniform(0.5, 1.5), plan.body});
    }
    AdvancePlain(until);
}

/// The body bends its path, on a parabola, until it flies in a direction of its own choice; then it coasts.
void WorldRun::ChangePlan(bmr_body body) {
    const bmr_body_state now = StateOf(body);
    const double time = Time(), turning = kTurning * m_setup.planEvery;
    const bmr_vec2 wanted = bmr_scale(m_dice.Uniform(0.5, 1.5), m_dice.Direction());
    const bmr_vec2 pull = bmr_scale(0.5 / turning, bmr_sub(wanted, now.velocity));
    bmr_motion_piece bend = {};
    bend.kind = BMR_PIECE_ALGEBRAIC;
    bend.origin = time;
    bmr_algebraic_piece &path = bend.as.algebraic;
    path.degree = 2;
    path.x[0] = now.pose.position.x;
    path.x[1] = now.velocity.x;
    path.x[2] = pull.x;
    path.y[0] = now.pose.position.y;
    path.y[1] = now.velocity.y;
    path.y[2] = pull.y;
    path.a[0] = 1.0;
    path.start_c = now.pose.c;
    path.start_s = now.pose.s;
    bmr_motion *made = nullptr;
    Require(bmr_motion_create(&bend, nullptr, &made), "a plan");
    const MotionPointer motion(made);
    const bmr_pose bent = bmr_motion_pose(made, time + turning, nullptr, nullptr);
    const bmr_motion_piece coast = bmr_piece_screw(time + turning, bent, wanted, m_dice.Uniform(-1.0, 1.0));
    Require(bmr_motion_change(made, time + turning, &coast), "a plan");
    const bmr_error error = bmr_world_set_motion(m_world.get(), body, made);
    if (error != BMR_OK)
        Stop(error, World(), m_setup.choice);
    ++m_given;
}

bmr_body_state WorldRun::StateOf(bmr_body body) const {
    bmr_body_state state;
    Require(bmr_world_get(World(), body, &state), "a body");
    return state;
}

void WorldRun::Audit() const {
    const bmr_error error = bmr_world_audit(World());
    if (error != BMR_OK)
        throw std::runtime_error("the audit fails at time " + std::to_string(Time()) + ": " +
                                 bmr_error_describe(error));
}

OverlapCheck CheckOverlaps(const WorldRun &run, const WorldSetup &setup) {
    const bool periodic = setup.choice.boundary == BMR_PERIODIC;
    const bmr_vec2 box = bmr_sub(setup.high, setup.low);
    std::vector<bmr_body_state> states;
    for (size_t i = 0; i < setup.bodies.size(); ++i)
        states.push_back(run.StateOf(i));
    OverlapCheck check;
    const auto note = [&check](double depth) {
        check.deepest = std::max(check.deepest, depth);
        check.overlaps += depth > kOverlapTolerance ? 1 : 0;
    };
    for (size_t i = 0; i < states.size(); ++i) {
        const bmr_body_state &a = states[i];
        for (size_t j = 0; j < i; ++j) {
            bmr_body_state b = states[j];
            bmr_vec2 way = bmr_sub(b.pose.position, a.pose.position);
            if (periodic) {
                way.x -= box.x * std::round(way.x / box.x);
                way.y -= box.y * std::round(way.y / box.y);
                b.pose.position = bmr_add(a.pose.position, way);
            }
            if (std::hypot(way.x, way.y) > a.radius + b.radius)
                continue;
            ++check.pairs;
            bmr_overlap overlap;
            Require(bmr_penetration(a.shape->polygon, &a.pose, b.shape->polygon, &b.pose, &overlap),
                    "two bodies");
            note(overlap.depth);
        }
        if (setup.choice.boundary != BMR_WALLED)
            continue;
        for (const bmr_vec2 &vertex : setup.bodies[i].polygon->Vertices()) {
            const bmr_vec2 at = bmr_transform(&a.pose, vertex);
            note(
                std::max({setup.low.x - at.x, at.x - setup.high.x, setup.low.y - at.y, at.y - setup.high.y}));
        }
    }
    return check;
}

// --- what a run came to ---

namespace {

/// How often a run is audited.
constexpr int kAudits = 4;

void SetDrifts(const WorldRun &run, const WorldSetup &setup, WorldFigures *figures) {
    const WorldChoice &choice = setup.choice;
    const bmr_world_totals from = run.TotalsAtStart(), to = run.Totals();
    const bool planned = setup.planEvery > 0.0;
    const bool elastic = choice.response.kind == BMR_RESPONSE_PASS ||
                         (choice.response.kind == BMR_RESPONSE_IMPULSE && choice.response.restitution == 1.0);
    figures->energyLeft = to.energy / from.energy;
    if (planned)
        return;
    if (elastic)
        figures->energy = (to.energy - from.energy) / from.energy;
    if (choice.boundary == BMR_WALLED)
        return;
    const bmr_vec2 change = bmr_sub(to.momentum, from.momentum);
    figures->momentum = std::hypot(change.x, change.y) / run.MomentumScale();
    if (choice.boundary == BMR_OPEN)
        figures->angular = (to.angular - from.angular) / (run.MomentumScale() * figures->side);
}

} // namespace

uint64_t WorldFigures::Events() const {
    return std::accumulate(std::begin(counts.events), std::end(counts.events), uint64_t{0});
}

double WorldFigures::Rate(uint64_t events) const {
    return static_cast<double>(events) / (static_cast<double>(choice.bodies) * choice.seconds);
}

double WorldFigures::MicrosecondsAnEvent() const {
    return Events() > 0 ? 1e6 * clock / static_cast<double>(Events()) : 0.0;
}

WorldFigures Measure(const WorldSetup &setup, const MeasureOptions &options) {
    WorldFigures figures;
    figures.choice = setup.choice;
    figures.side = setup.high.x - setup.low.x;
    std::clock_t start = std::clock(); // of the processor, not on the wall
    WorldRun run(setup, options.frames);
    std::clock_t spent = std::clock() - start;
    if (options.onSlice)
        options.onSlice(run, 0.0);
    for (int slice = 1; slice <= options.slices; ++slice) {
        const double part = static_cast<double>(slice) / options.slices;
        start = std::clock();
        run.Advance(setup.choice.seconds * part);
        spent += std::clock() - start;
        if (options.audit && slice * kAudits / options.slices > (slice - 1) * kAudits / options.slices) {
            run.Audit();
            ++figures.audits;
        }
        if (options.onSlice)
            options.onSlice(run, part);
    }
    figures.clock = static_cast<double>(spent) / CLOCKS_PER_SEC;
    figures.counts = run.Counts();
    figures.plans = run.Plans();
    SetDrifts(run, setup, &figures);
    if (options.check)
        figures.check = CheckOverlaps(run, setup);
    return figures;
}

const char *NameOf(bmr_boundary boundary) {
    return boundary == BMR_OPEN ? "open" : boundary == BMR_WALLED ? "walls" : "periodic";
}

std::string NameOf(const bmr_response &response) {
    if (response.kind == BMR_RESPONSE_PASS)
        return "pass";
    if (response.restitution == 1.0)
        return "elastic";
    char text[40];
    std::snprintf(text, sizeof text, "restitution %.6g", response.restitution);
    return text;
}

} // namespace testbed
