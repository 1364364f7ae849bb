// SPDX-License-Identifier: MIT
#include "collect.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>

namespace testbed::replay {
namespace {

Point PointOf(const recording::Vec &vec) {
    return {static_cast<double>(vec.x), static_cast<double>(vec.y)};
}

uint16_t Clamped(int64_t count) {
    return static_cast<uint16_t>(std::clamp<int64_t>(count, 0, UINT16_MAX));
}

Calls CallsOf(const recording::Calls &calls) {
    return {calls.polygon_tests, calls.toi, calls.distance, calls.overlap};
}

/// FNV-1a over the bits of every body's pose.
uint64_t HashOf(const recording::Frame &frame) {
    uint64_t hash = 14695981039346656037U;
    const auto add = [&hash](uint32_t bits) {
        for (int shift = 0; shift < 32; shift += 8)
            hash = (hash ^ (bits >> shift & 0xff)) * 1099511628211U;
    };
    for (const recording::Body &body : frame.bodies) {
        add(static_cast<uint32_t>(body.number));
        for (const float value : {body.pose.position.x, body.pose.position.y, body.pose.c, body.pose.s}) {
            uint32_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            add(bits);
        }
    }
    return hash;
}

BodyType TypeOf(const std::string &type) {
    return type == "static"      ? BodyType::Static
           : type == "kinematic" ? BodyType::Kinematic
                                 : BodyType::Dynamic;
}

Shape ShapeOf(const recording::Fixture &fixture) {
    Shape shape;
    shape.kind = fixture.shape == "polygon"  ? ShapeKind::Polygon
                 : fixture.shape == "circle" ? ShapeKind::Circle
                                             : ShapeKind::Chain;
    shape.sensor = fixture.sensor;
    shape.radius = static_cast<double>(fixture.radius);
    shape.points.reserve(fixture.points.size());
    for (const recording::Vec &point : fixture.points)
        shape.points.push_back(PointOf(point));
    return shape;
}

Answer AnswerOf(const recording::Pair &pair) {
    if (!recording::IsZero(pair.calls))
        return Answer::HandedOver;
    if (pair.asked == 0)
        return Answer::Unasked;
    return pair.handed_over > 0 ? Answer::Manifold : Answer::Apart;
}

ProofKind KindOf(const std::string &kind) {
    if (kind == "remembered-edge")
        return ProofKind::RememberedEdge;
    if (kind == "edge-line")
        return ProofKind::EdgeLine;
    if (kind == "direction")
        return ProofKind::Direction;
    if (kind == "disks")
        return ProofKind::Disks;
    throw std::runtime_error("a recording has a proof of an unknown kind, \"" + kind + "\"");
}

/// All but the outlines, which have numbers of their own here.
Proof ProofOf(const recording::Proof &recorded) {
    Proof proof;
    proof.kind = KindOf(recorded.kind);
    proof.owner = recorded.owner;
    proof.level = recorded.level;
    proof.angle = std::atan2(static_cast<double>(recorded.normal.y), static_cast<double>(recorded.normal.x));
    const auto owner = static_cast<size_t>(recorded.owner);
    switch (proof.kind) {
    case ProofKind::RememberedEdge:
    case ProofKind::EdgeLine:
        proof.line = {PointOf(recorded.edge[0]), PointOf(recorded.edge[1])};
        proof.opposite = PointOf(recorded.opposite);
        break;
    case ProofKind::Direction:
        proof.line = {PointOf(recorded.supports[owner]), PointOf(recorded.supports[owner])};
        proof.opposite = PointOf(recorded.supports[1 - owner]);
        break;
    case ProofKind::Disks:
        proof.line = {PointOf(recorded.centres[0]), PointOf(recorded.centres[0])};
        proof.opposite = PointOf(recorded.centres[1]);
        proof.radii = {static_cast<double>(recorded.radii[0]), static_cast<double>(recorded.radii[1])};
        break;
    }
    return proof;
}

} // namespace

size_t Collector::PairHash::operator()(const PairKey &key) const {
    return std::hash<uint64_t>()(static_cast<uint64_t>(key.first) << 32 ^ static_cast<uint32_t>(key.second));
}

void Collector::AddPlugin(const recording::Frame &frame) {
    const int32_t step = m_replay.stepCount++;
    if (frame.step != step)
        throw std::runtime_error("a recording lacks step " + std::to_string(step));
    m_pluginHashes.push_back(HashOf(frame));
    m_replay.pluginCalls.push_back(CallsOf(frame.calls));
    m_gathered.Add(frame);
    AddBodies(frame, step);
    AddOutlines(frame);
    AddPairs(frame, step);
    AddEvents(frame);
    AddContacts(frame, step);
    AddJoints(frame, step);
    AddBoxes(frame, step);
}

void Collector::AddStock(const recording::Frame &frame) {
    const auto step = static_cast<int32_t>(m_stockHashes.size());
    if (frame.step != step)
        throw std::runtime_error("a recording lacks step " + std::to_string(step));
    m_stockHashes.push_back(HashOf(frame));
    m_replay.stockCalls.push_back(CallsOf(frame.calls));
    for (const recording::Pair &pair : frame.pairs)
        if (!recording::IsZero(pair.calls))
            m_pairs[{pair.a, pair.b}].stock.push_back({step, Clamped(pair.calls.polygon_tests),
                                                       Clamped(pair.calls.toi), Clamped(pair.calls.overlap)});
}

void Collector::AddBodies(const recording::Frame &frame, int32_t step) {
    std::set<int> changed;
    for (const recording::Fixture &fixture : frame.fixtures)
        changed.insert(fixture.body);
    for (const std::array<int, 2> &gone : frame.gone)
        changed.insert(gone[0]);
    for (const recording::Body &recorded : frame.bodies) {
        const auto [known, isNew] = m_bodies.try_emplace(recorded.number);
        Presence &presence = known->second;
        const BodyType type = TypeOf(recorded.type);
        const auto isSame = [&](const Body &body) {
            return body.type == type && body.bullet == recorded.bullet &&
                   body.firstStep + static_cast<int32_t>(body.poses.size()) == step;
        };
        if (isNew || changed.count(recorded.number) != 0 || !isSame(m_replay.bodies[presence.entry])) {
            presence.entry = m_replay.bodies.size();
            Body body;
            body.number = recorded.number;
            body.type = type;
            body.bullet = recorded.bullet;
            body.firstStep = step;
            const auto &fixtures = m_gathered.fixtures;
            for (auto it = fixtures.lower_bound({recorded.number, 0});
                 it != fixtures.end() && it->first.first == recorded.number; ++it)
                body.shapes.push_back(ShapeOf(it->second));
            m_replay.bodies.push_back(std::move(body));
        }
        // Nearest to the angle before: a column of angles has no jumps where a turn is full.
        const double turn =
            std::atan2(static_cast<double>(recorded.pose.s), static_cast<double>(recorded.pose.c));
        presence.angle = turn + 2.0 * M_PI * std::round((presence.angle - turn) / (2.0 * M_PI));
        const Point at = PointOf(recorded.pose.position);
        m_replay.bodies[presence.entry].poses.push_back(
            {at.x, at.y, presence.angle,
             (recorded.asleep ? 0 : kAwake) | (recorded.disabled ? 0 : kEnabled)});
    }
}

void Collector::AddOutlines(const recording::Frame &frame) {
    for (const recording::Outline &recorded : frame.outlines) {
        m_outlines[recorded.id] = static_cast<int32_t>(m_replay.outlines.size());
        Outline outline;
        outline.body = recorded.body;
        for (const recording::Vec &point : recorded.points)
            outline.points.push_back(PointOf(point));
        m_replay.outlines.push_back(std::move(outline));
    }
}

void Collector::AddPairs(const recording::Frame &frame, int32_t step) {
    for (const recording::Pair &pair : frame.pairs) {
        PairLog &log = m_pairs[{pair.a, pair.b}];
        PairStep verdict;
        verdict.slack = pair.slack;
        verdict.answer = AnswerOf(pair);
        verdict.touching = pair.touching > 0;
        const bool isFirst = log.plugin.empty() || log.plugin.back().step != step - 1;
        log.plugin.push_back({step, verdict});
        if (!pair.proofs_kept)
            AddProofs(log, pair, step, isFirst);
    }
}

void Collector::AddProofs(PairLog &log, const recording::Pair &pair, int32_t step, bool isFirst) {
    const auto outline = [this](int id) {
        const auto found = m_outlines.find(id);
        return found == m_outlines.end() ? -1 : found->second;
    };
    std::vector<Proof> proofs;
    for (const recording::Proof &recorded : pair.proofs) {
        if (recorded.kind == "none")
            continue;
        proofs.push_back(ProofOf(recorded));
        for (size_t side = 0; side < 2; ++side) {
            proofs.back().hulls[side] = outline(recorded.hulls[side]);
            proofs.back().envelopes[side] = outline(recorded.envelopes[side]);
        }
    }
    if (isFirst || proofs != log.proofs.back().proofs)
        log.proofs.push_back({step, std::move(proofs)});
}

void Collector::AddEvents(const recording::Frame &frame) {
    for (const recording::Event &recorded : frame.events) {
        const auto [kind, isNew] =
            m_eventKinds.try_emplace(recorded.kind, static_cast<int32_t>(m_replay.eventKinds.size()));
        if (isNew)
            m_replay.eventKinds.push_back(recorded.kind);
        Event event;
        event.a = std::min(recorded.a, recorded.b);
        event.b = std::max(recorded.a, recorded.b);
        event.step = static_cast<int32_t>(recorded.step);
        event.kind = kind->second;
        event.levelBefore = recorded.level_before;
        event.levelAfter = recorded.level_after;
        event.gap = static_cast<double>(recorded.gap);
        m_replay.events.push_back(event);
    }
}

void Collector::AddContacts(const recording::Frame &frame, int32_t step) {
    for (const recording::Contact &contact : frame.touching)
        for (size_t i = 0; i < contact.points.size(); ++i) {
            const std::array<int, 5> key = {contact.bodies[0], contact.fixtures[0], contact.bodies[1],
                                            contact.fixtures[1], static_cast<int>(i)};
            auto [known, isNew] = m_contacts.try_emplace(key, m_replay.contacts.size());
            if (!isNew) {
                const ContactPoint &last = m_replay.contacts[known->second];
                isNew = last.firstStep + static_cast<int32_t>(last.at.size()) != step;
            }
            if (isNew) {
                known->second = m_replay.contacts.size();
                m_replay.contacts.push_back({step, {}});
            }
            m_replay.contacts[known->second].at.push_back(PointOf(contact.points[i].at));
        }
}

void Collector::AddJoints(const recording::Frame &frame, int32_t step) {
    for (const recording::Joint &joint : frame.joints)
        for (size_t i = 0; i < joint.segments.size(); ++i) {
            auto [known, isNew] = m_joints.try_emplace({joint.number, i}, m_replay.joints.size());
            if (!isNew) {
                const JointSegment &last = m_replay.joints[known->second];
                isNew = last.firstStep + static_cast<int32_t>(last.ends.size()) != step;
            }
            if (isNew) {
                known->second = m_replay.joints.size();
                m_replay.joints.push_back({step, {}});
            }
            m_replay.joints[known->second].ends.emplace_back(PointOf(joint.segments[i][0]),
                                                             PointOf(joint.segments[i][1]));
        }
}

void Collector::AddBoxes(const recording::Frame &frame, int32_t step) {
    for (const recording::Box &recorded : frame.boxes) {
        Box box;
        box.of = {recorded.body, recorded.fixture, recorded.child};
        box.step = step;
        box.end = step + 1;
        box.low = PointOf({recorded.left, recorded.bottom});
        box.high = PointOf({recorded.right, recorded.top});
        const auto [known, isNew] = m_boxes.try_emplace(box.of, m_replay.boxes.size());
        if (!isNew) {
            Box &last = m_replay.boxes[known->second];
            if (last.end == step && last.low == box.low && last.high == box.high) {
                last.end = step + 1;
                continue;
            }
            known->second = m_replay.boxes.size();
        }
        m_replay.boxes.push_back(box);
    }
}

std::optional<int64_t> Collector::FirstDifference() const {
    const size_t both = std::min(m_pluginHashes.size(), m_stockHashes.size());
    for (size_t step = 0; step < both; ++step)
        if (m_pluginHashes[step] != m_stockHashes[step])
            return static_cast<int64_t>(step);
    return std::nullopt;
}

/// Both sides' steps, merged, cut where neither has one.
void Collector::FinishPair(const PairKey &key, const PairLog &log) {
    auto plugin = log.plugin.begin();
    auto stock = log.stock.begin();
    auto proofs = log.proofs.begin();
    while (plugin != log.plugin.end() || stock != log.stock.end()) {
        const int32_t step = std::min(plugin == log.plugin.end() ? INT32_MAX : plugin->step,
                                      stock == log.stock.end() ? INT32_MAX : stock->step);
        // A replay ends with the plugin's side.
        if (step >= m_replay.stepCount)
            return;
        std::vector<Pair> &pairs = m_replay.pairs;
        const bool continues =
            !pairs.empty() && pairs.back().a == key.first && pairs.back().b == key.second &&
            pairs.back().firstStep + static_cast<int32_t>(pairs.back().steps.size()) == step;
        if (!continues)
            pairs.push_back({key.first, key.second, step, {}});
        PairStep merged;
        if (plugin != log.plugin.end() && plugin->step == step)
            merged = plugin++->verdict;
        else if (continues && !m_replay.certificates.empty() &&
                 m_replay.certificates.back().pair == static_cast<int32_t>(pairs.size()) - 1 &&
                 !m_replay.certificates.back().proofs.empty())
            m_replay.certificates.push_back({static_cast<int32_t>(pairs.size()) - 1, step, {}});
        if (stock != log.stock.end() && stock->step == step) {
            merged.stockPolygonTests = stock->polygonTests;
            merged.stockToi = stock->toi;
            merged.stockOverlaps = stock->overlaps;
            ++stock;
        }
        pairs.back().steps.push_back(merged);
        if (proofs != log.proofs.end() && proofs->step == step) {
            m_replay.certificates.push_back({static_cast<int32_t>(pairs.size()) - 1, step, proofs->proofs});
            ++proofs;
        }
    }
}

Replay Collector::Finish() {
    std::vector<PairKey> keys;
    keys.reserve(m_pairs.size());
    for (const auto &[key, log] : m_pairs)
        keys.push_back(key);
    std::sort(keys.begin(), keys.end());
    for (const PairKey &key : keys) {
        FinishPair(key, m_pairs[key]);
        m_pairs.erase(key); // the same again, in another form: not both at once
    }
    std::stable_sort(m_replay.boxes.begin(), m_replay.boxes.end(),
                     [](const Box &a, const Box &b) { return a.of < b.of; });
    return std::move(m_replay);
}

} // namespace testbed::replay
