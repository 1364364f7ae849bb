// SPDX-License-Identifier: MIT
// What a pair's budget is: made by a proof, renewed by the pair's line, dropped.
#include "world/ledger.h"

namespace bmr {

void Ledger::DropAllProofs() {
    for (uint32_t i = 0; i < m_count; ++i)
        if (m_contacts[i] != nullptr && IsWatched(i))
            SetDue(i);
}

bool Ledger::Renew(uint32_t i, double threshold) {
    const Record &record = m_records[i];
    if ((m_bits[i] & kHasLine) == 0 ||
        ((m_movers.Bits(record.a) | m_movers.Bits(record.b)) & kChanged) != 0 || m_movers.AreSumsLost())
        return false;
    const bmr_mover &a = m_movers[record.a].motion, &b = m_movers[record.b].motion;
    const double slack = bmr_budget_line_gap(&m_lines[i], &a, &b, kUnits) - threshold;
    const uint32_t deadline = bmr_budget_deadline(slack, a.moved, b.moved, kUnits);
    if (bmr_budget_is_due(deadline, a.moved, b.moved))
        return false;
    m_records[i].deadline = deadline;
    return true;
}

bool Ledger::BeginProof(uint32_t i) {
    DropLine(i);
    const Record &record = m_records[i];
    m_movers.AddProof(record.a, m_manager->m_broadPhase, m_look);
    m_movers.AddProof(record.b, m_manager->m_broadPhase, m_look);
    m_bits[i] |= kHasLine;
    return ((m_movers.Bits(record.a) | m_movers.Bits(record.b)) & kPlain) == 0;
}

void Ledger::Prove(uint32_t i, bmr_vec2 d, double gap, double threshold, bool forImpactsToo) {
    const Record &record = m_records[i];
    const bmr_mover &a = m_movers[record.a].motion, &b = m_movers[record.b].motion;
    m_records[i].deadline = bmr_budget_deadline(gap - threshold, a.moved, b.moved, kUnits);
    m_lines[i] = bmr_budget_line_make(d, gap, &a, &b, kUnits);
    m_bits[i] = static_cast<uint8_t>((m_bits[i] & ~kNoImpactProof) | (forImpactsToo ? 0 : kNoImpactProof));
}

} // namespace bmr
