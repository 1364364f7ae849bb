// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_COLLECT_H
#define BOOMERANG_TESTBED_COLLECT_H

#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "recording/recording.h"
#include "replay.h"

namespace testbed::replay {

/// Makes a replay of two recordings of the same scene, one of a run with the plugin and one of stock Box2D,
/// both of every step from 0 on. Frames come one by one, each side's in order, the sides in any order; none
/// is kept.
class Collector {
public:
    /// The plugin's frame: where everything is, what is proved, what happened. O(frame log frame).
    void AddPlugin(const recording::Frame &frame);
    /// Stock's: of it the calls are kept, and what tells whether its bodies are where the plugin's are.
    void AddStock(const recording::Frame &frame);

    /// The first step whose bodies differ, in place or in number, among those that both sides have.
    std::optional<int64_t> FirstDifference() const;
    /// The replay of the steps of the plugin's side, once. `about` is left empty. O(all of it).
    Replay Finish();

private:
    struct PluginStep {
        int32_t step;
        PairStep verdict;
    };
    struct StockStep {
        int32_t step;
        uint16_t polygonTests, toi, overlaps;
    };
    struct Proofs {
        int32_t step;
        std::vector<Proof> proofs;
    };
    struct PairLog {
        std::vector<PluginStep> plugin;
        std::vector<StockStep> stock;
        std::vector<Proofs> proofs; ///< where they changed, and at the first step after an absence
    };
    struct Presence {
        size_t entry = 0;
        double angle = 0.0;
    };
    using PairKey = std::pair<int32_t, int32_t>;
    struct PairHash {
        size_t operator()(const PairKey &key) const;
    };

    void AddBodies(const recording::Frame &frame, int32_t step);
    void AddOutlines(const recording::Frame &frame);
    void AddPairs(const recording::Frame &frame, int32_t step);
    void AddProofs(PairLog &log, const recording::Pair &pair, int32_t step, bool isFirst);
    void AddEvents(const recording::Frame &frame);
    void AddContacts(const recording::Frame &frame, int32_t step);
    void AddJoints(const recording::Frame &frame, int32_t step);
    void AddBoxes(const recording::Frame &frame, int32_t step);
    void FinishPair(const PairKey &key, const PairLog &log);

    Replay m_replay;
    recording::Gathered m_gathered;
    std::map<int, Presence> m_bodies;
    std::map<int, int32_t> m_outlines; ///< index by the recording's id
    std::unordered_map<PairKey, PairLog, PairHash> m_pairs;
    std::map<std::string, int32_t> m_eventKinds;
    std::map<std::array<int, 5>, size_t> m_contacts; ///< by bodies, fixtures and place in the manifold
    std::map<std::pair<int, size_t>, size_t> m_joints;
    std::map<std::array<int, 3>, size_t> m_boxes;
    std::vector<uint64_t> m_pluginHashes, m_stockHashes;
};

} // namespace testbed::replay

#endif
