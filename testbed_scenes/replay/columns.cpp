// SPDX-License-Identifier: MIT
//
// Which columns a replay becomes. Their names are what page/model.js asks for.
#include "encoding.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace testbed::replay {
namespace {

constexpr double kFarthestAngle = 100000.0, kLargestSlack = 1e6;

int32_t Position(double value) {
    return Quantise(value, kPositionQuantum, kFarthest);
}
int32_t Angle(double value) {
    return Quantise(value, kAngleQuantum, kFarthestAngle);
}

int32_t Count(size_t count) {
    return static_cast<int32_t>(count);
}

/// Columns under construction, by the place in which they were declared.
class Table {
public:
    explicit Table(const std::vector<const char *> &names) {
        for (const char *name : names)
            m_columns.push_back({name, {}});
    }
    void Add(const std::vector<int32_t> &row) {
        for (size_t i = 0; i < row.size(); ++i)
            m_columns[i].values.push_back(row[i]);
    }
    void MoveTo(std::vector<Column> &columns) {
        std::move(m_columns.begin(), m_columns.end(), std::back_inserter(columns));
    }

private:
    std::vector<Column> m_columns;
};

/// Tables refer to the next by counts: a body's shapes and poses follow those of the body before it.
void AddBodies(const Replay &replay, std::vector<Column> &columns) {
    Table bodies({"body.number", "body.type", "body.shapes", "body.first", "body.steps"});
    Table shapes({"shape.kind", "shape.radius", "shape.points"}), shapePoints({"shape.x", "shape.y"});
    Table poses({"pose.x", "pose.y", "pose.angle", "pose.flags"});
    for (const Body &body : replay.bodies) {
        bodies.Add({body.number, static_cast<int32_t>(body.type) | (body.bullet ? 4 : 0),
                    Count(body.shapes.size()), body.firstStep, Count(body.poses.size())});
        for (const Shape &shape : body.shapes) {
            shapes.Add({static_cast<int32_t>(shape.kind) | (shape.sensor ? 4 : 0), Position(shape.radius),
                        Count(shape.points.size())});
            for (const Point &point : shape.points)
                shapePoints.Add({Position(point.x), Position(point.y)});
        }
        for (const Pose &pose : body.poses)
            poses.Add({Position(pose.x), Position(pose.y), Angle(pose.angle), pose.flags});
    }
    Table outlines({"outline.body", "outline.points"}), outlinePoints({"outline.x", "outline.y"});
    for (const Outline &outline : replay.outlines) {
        outlines.Add({outline.body, Count(outline.points.size())});
        for (const Point &point : outline.points)
            outlinePoints.Add({Position(point.x), Position(point.y)});
    }
    for (Table *table : {&bodies, &shapes, &shapePoints, &poses, &outlines, &outlinePoints})
        table->MoveTo(columns);
}

void AddPairs(const Replay &replay, std::vector<Column> &columns) {
    Table pairs({"pair.a", "pair.b", "pair.first", "pair.steps"});
    Table steps({"step.slack", "step.verdict", "step.polygon", "step.toi", "step.overlap"});
    for (const Pair &pair : replay.pairs) {
        pairs.Add({pair.a, pair.b, pair.firstStep, Count(pair.steps.size())});
        for (const PairStep &step : pair.steps)
            steps.Add({QuantiseSlack(static_cast<double>(step.slack)),
                       static_cast<int32_t>(step.answer) | (step.touching ? 4 : 0), step.stockPolygonTests,
                       step.stockToi, step.stockOverlaps});
    }
    for (Table *table : {&pairs, &steps})
        table->MoveTo(columns);
}

void AddProofs(const Replay &replay, std::vector<Column> &columns) {
    Table certificates({"certificate.pair", "certificate.step", "certificate.proofs"});
    Table proofs({"proof.kind", "proof.owner", "proof.level", "proof.angle", "proof.x0", "proof.y0",
                  "proof.x1", "proof.y1", "proof.ox", "proof.oy", "proof.ra", "proof.rb", "proof.hullA",
                  "proof.hullB", "proof.envelopeA", "proof.envelopeB"});
    for (const Certificate &certificate : replay.certificates) {
        certificates.Add({certificate.pair, certificate.step, Count(certificate.proofs.size())});
        for (const Proof &proof : certificate.proofs)
            proofs.Add({static_cast<int32_t>(proof.kind), proof.owner, proof.level, Angle(proof.angle),
                        Position(proof.line[0].x), Position(proof.line[0].y), Position(proof.line[1].x),
                        Position(proof.line[1].y), Position(proof.opposite.x), Position(proof.opposite.y),
                        Position(proof.radii[0]), Position(proof.radii[1]), proof.hulls[0], proof.hulls[1],
                        proof.envelopes[0], proof.envelopes[1]});
    }
    Table events(
        {"event.a", "event.b", "event.step", "event.kind", "event.before", "event.after", "event.gap"});
    for (const Event &event : replay.events)
        events.Add({event.a, event.b, event.step, event.kind, event.levelBefore, event.levelAfter,
                    QuantiseSlack(event.gap)});
    for (Table *table : {&certificates, &proofs, &events})
        table->MoveTo(columns);
}

std::vector<int32_t> RowOf(const Calls &calls) {
    const auto whole = [](int64_t count) {
        return static_cast<int32_t>(std::clamp<int64_t>(count, 0, INT32_MAX));
    };
    return {whole(calls.polygonTests), whole(calls.toi), whole(calls.distance), whole(calls.overlaps)};
}

void AddRest(const Replay &replay, std::vector<Column> &columns) {
    Table contacts({"contact.first", "contact.steps"}), contactPoints({"contact.x", "contact.y"});
    for (const ContactPoint &contact : replay.contacts) {
        contacts.Add({contact.firstStep, Count(contact.at.size())});
        for (const Point &point : contact.at)
            contactPoints.Add({Position(point.x), Position(point.y)});
    }
    Table joints({"joint.first", "joint.steps"}), ends({"joint.ax", "joint.ay", "joint.bx", "joint.by"});
    for (const JointSegment &joint : replay.joints) {
        joints.Add({joint.firstStep, Count(joint.ends.size())});
        for (const auto &[a, b] : joint.ends)
            ends.Add({Position(a.x), Position(a.y), Position(b.x), Position(b.y)});
    }
    Table boxes({"box.step", "box.end", "box.left", "box.bottom", "box.width", "box.height"});
    for (const Box &box : replay.boxes)
        boxes.Add({box.step, box.end, Position(box.low.x), Position(box.low.y),
                   Position(box.high.x - box.low.x), Position(box.high.y - box.low.y)});
    Table stock({"stock.polygon", "stock.toi", "stock.distance", "stock.overlap"}),
        plugin({"plugin.polygon", "plugin.toi", "plugin.distance", "plugin.overlap"});
    for (const Calls &calls : replay.stockCalls)
        stock.Add(RowOf(calls));
    for (const Calls &calls : replay.pluginCalls)
        plugin.Add(RowOf(calls));
    for (Table *table : {&contacts, &contactPoints, &joints, &ends, &boxes, &stock, &plugin})
        table->MoveTo(columns);
}

} // namespace

int32_t Quantise(double value, double quantum, double limit) {
    if (std::isnan(value))
        return 0;
    return static_cast<int32_t>(std::lround(std::clamp(value, -limit, limit) / quantum));
}

int32_t QuantiseSlack(double slack) {
    if (!(slack >= 0.0))
        return -1;
    const auto quanta = static_cast<int32_t>(std::floor(std::min(slack, kLargestSlack) / kSlackQuantum));
    return quanta == 0 && slack > 0.0 ? 1 : quanta;
}

std::vector<Column> ColumnsOf(const Replay &replay) {
    std::vector<Column> columns;
    AddBodies(replay, columns);
    AddPairs(replay, columns);
    AddProofs(replay, columns);
    AddRest(replay, columns);
    return columns;
}

} // namespace testbed::replay
