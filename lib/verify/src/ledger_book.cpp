// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the rows of the ledger.
#include "ledger_book.h"

#include "body.h"

#include <algorithm>

namespace ncsim::verify {

using cda::Cell;
using gcode::MoveKind;

void LedgerBook::enter(const Move& move, bool later) {
    const gcode::Motion& m = *move.motion;
    auto& rows = ledger_.rows;
    const bool same = !rows.empty() && rows.back().line == m.span.line &&
                      rows.back().file == m.file && rows.back().tool == m.tool &&
                      rows.back().last_motion + 1 == move.number;
    if (!same) {
        LedgerRow row;
        row.file = m.file;
        row.line = m.span.line;
        row.first_motion = move.number;
        row.tool = m.tool;
        row.kind = m.kind;
        rows.push_back(row);
    }
    LedgerRow& row = rows.back();
    row.last_motion = move.number;
    if (m.kind == MoveKind::Feed) row.kind = MoveKind::Feed;
    row.length_mm += move.length_mm;
    if (later) {
        if (m.kind == MoveKind::Feed) cut_now_.feed_mm = move.length_mm;
        cut_now_.row = rows.size() - 1;
        cuts_.push_back(cut_now_);
        return;
    }
    row.removed_mm3 += move.removed_mm3;
    row.contact.add(move.contact);
}

void LedgerBook::note_cells(const toolpath::Step& step, double rounding) {
    if (step.cells.empty()) return;
    cut_now_.origin = step.cells.front().origin;
    for (const Cell& cell : step.cells) {
        const Box met = intersection(cell.bounds, stock_);
        if (met.is_empty()) continue;
        // If the tool is upright, only planes are rounded, by at most 2^-24 of the extent of the
        // cell.
        const Vec3 e = met.max - met.min;
        const double thickness =
            is_upright(step) ? std::min(rounding, 0x1p-24 * norm(e)) : rounding;
        cut_now_.sliver_mm3 += 2.0 * thickness * (e.x * e.y + e.y * e.z + e.z * e.x);
    }
}

void LedgerBook::close(const cda::RemovalByMotion& account, bool tells_air) {
    double air_mm = 0.0;
    for (const Cut& cut : cuts_) {
        const auto found = account.find(cut.origin);
        const double removed = found == account.end() ? 0.0 : found->second.volume;
        if (cut.feed_mm > 0.0 && removed <= cut.sliver_mm3) air_mm += cut.feed_mm;
        if (removed <= 0.0) continue;
        LedgerRow& row = ledger_.rows[cut.row];
        row.removed_mm3 += removed;
        row.contact.add(intersection(found->second.bounds, stock_));
        ledger_.removed_mm3 += removed;
    }
    if (tells_air) ledger_.air_mm = air_mm;
}

}  // namespace ncsim::verify
