#include "debugger/plane_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <surefoot/sweep.hpp>

#include "debugger/equation.hpp"

namespace surefoot::debugger {

namespace {

/// More than the library ever records of one triangle.
constexpr std::size_t most_records = 512;

std::string name_of(const TraceRecord& record) {
    static constexpr const char* edges[] = {"ab", "bc", "ca"};
    static constexpr const char* corners[] = {"a", "b", "c"};
    const std::size_t index = std::min<std::size_t>(record.feature_index, 2);
    if (record.feature == Feature::face) return "face";
    return record.feature == Feature::edge ? fmt::format("edge {}", edges[index])
                                           : fmt::format("vertex {}", corners[index]);
}

std::string words_for(const TraceRecord& record) {
    switch (record.verdict) {
        case Verdict::separates:
            return "keeps them apart on the whole way: the proof that there is no hit";
        case Verdict::enters:
            if (record.t < 0) return "gave way before START: decides nothing";
            return fmt::format("gives way at t = {}", short_text(record.t));
        case Verdict::leaves:
            if (record.t > 1) return "opens again only after END: decides nothing";
            return fmt::format("opens again at t = {}", short_text(record.t));
        case Verdict::inside:
            return "behind it all along: decides nothing";
        case Verdict::contact:
            return "the least deep at START: the way out";
        case Verdict::decided:
            break;
    }
    return "the answer";
}

/// The same plane may be proposed by several features, and asked twice.
bool is_known(const std::vector<PlaneRow>& rows, const TraceRecord& record) {
    return std::any_of(rows.begin(), rows.end(), [&](const PlaneRow& row) {
        return row.normal == record.normal && row.verdict == record.verdict && row.gap_from == record.gap_from;
    });
}

PlaneRow row_of(const TraceRecord& record) {
    PlaneRow row;
    row.proposed_by = name_of(record);
    row.normal = record.normal;
    row.gap_from = record.gap_from;
    row.gap_to = record.gap_to;
    if (record.verdict == Verdict::enters || record.verdict == Verdict::leaves) row.t = record.t;
    row.verdict = record.verdict;
    row.why = words_for(record);
    return row;
}

/// The row whose plane gave way when the answer says; the first of several.
void mark_answer(PlaneTable& table) {
    PlaneRow* last = nullptr;
    for (PlaneRow& row : table.rows) {
        const bool counts = table.hit->t == 0 ? row.verdict == Verdict::contact : row.verdict == Verdict::enters;
        if (counts && (last == nullptr || row.t.value_or(0) > last->t.value_or(0))) last = &row;
    }
    if (last == nullptr) return;
    last->answer = true;
    last->why += ", the last to do so: here they touch";
}

std::string conclusion_of(const PlaneTable& table) {
    const auto separates = [](const PlaneRow& row) { return row.verdict == Verdict::separates; };
    const auto touches = [](const PlaneRow& row) { return row.verdict == Verdict::contact; };
    if (table.hit && table.hit->status != HitStatus::ok) return "The question is outside the limits: blocked at t = 0.";
    if (table.hit && table.hit->t == 0) return "In touch at START and going deeper: a hit at t = 0.";
    if (table.hit) return fmt::format("The last plane gives way at t = {}: a hit.", short_text(table.hit->t));
    if (std::any_of(table.rows.begin(), table.rows.end(), separates))
        return "A plane has a gap on the whole way: no hit.";
    if (std::any_of(table.rows.begin(), table.rows.end(), touches))
        return "In touch at START and going no deeper: no hit.";
    return table.rows.empty() ? "Nothing had to be asked: no hit."
                              : "One plane opens before another closes, so they never touch: no hit.";
}

}  // namespace

PlaneTable plane_table(const Volume& volume, const Motion& motion, const Triangle& triangle, bool one_sided) {
    std::vector<TraceRecord> room(most_records);
    Trace trace(room);
    PlaneTable table;
    table.hit = sweep(volume, motion, triangle, {.one_sided = one_sided}, &trace);
    const Trace& filled = trace;
    for (const TraceRecord& record : filled.records()) {
        if (record.verdict != Verdict::decided && !is_known(table.rows, record)) table.rows.push_back(row_of(record));
    }
    if (table.hit && table.hit->status == HitStatus::ok) mark_answer(table);
    table.conclusion = conclusion_of(table);
    return table;
}

}  // namespace surefoot::debugger
