#include "playground/debugger_room/subjects.hpp"

#include <algorithm>
#include <limits>

#include <surefoot/query.hpp>

#include "debugger/gap_curve.hpp"

namespace surefoot::playground {
namespace {

constexpr std::size_t most_logged = 4096;  // steps of a search; what comes later is only looked at in the panel Search

std::vector<Subject> asked_of(const Mesh& mesh, const Inquiry& inquiry) {
    std::vector<SearchStep> steps(most_logged);
    SearchLog log(steps);
    QueryWork work{.log = &log};
    const auto& question = inquiry.question;
    static_cast<void>(mesh.sweep(question.volume(), question.motion, {.one_sided = question.one_sided, .work = &work}));
    std::vector<std::uint32_t> ids;
    if (inquiry.hit && inquiry.hit->status == HitStatus::ok) ids.push_back(inquiry.hit->triangle);
    // What a search asks last lies nearest to its answer.
    for (std::size_t i = log.steps().size(); i > 0 && ids.size() < most_subjects; --i) {
        const SearchStep& step = log.steps()[i - 1];
        if (step.kind == SearchStep::Kind::triangle && std::find(ids.begin(), ids.end(), step.triangle) == ids.end())
            ids.push_back(step.triangle);
    }
    std::sort(ids.begin(), ids.end());
    std::vector<Subject> subjects;
    for (const std::uint32_t id : ids) subjects.push_back({id, mesh.triangle(id)});
    return subjects;
}

}  // namespace

std::vector<Subject> subjects_of(const Inquiry& inquiry) {
    if (const Mesh* const mesh = inquiry.arena.mesh()) return asked_of(*mesh, inquiry);
    std::vector<Subject> subjects;
    for (const Triangle& triangle : inquiry.question.triangles)
        subjects.push_back({static_cast<std::uint32_t>(subjects.size()), triangle});
    return subjects;
}

std::size_t foremost(const std::vector<Subject>& subjects, const Inquiry& inquiry) {
    if (inquiry.hit) {
        const auto found = std::find_if(subjects.begin(), subjects.end(),
                                        [&](const Subject& subject) { return subject.id == inquiry.hit->triangle; });
        if (found != subjects.end()) return static_cast<std::size_t>(found - subjects.begin());
    }
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const auto curve = debugger::gap_curve(inquiry.question.volume(), inquiry.question.motion, subjects[i].triangle,
                                               17, inquiry.question.one_sided);
        for (const debugger::GapSample& sample : curve.samples) {
            if (sample.g >= least) continue;
            least = sample.g;
            best = i;
        }
    }
    return best;
}

std::optional<std::string> why_no_answer(const Inquiry& inquiry) {
    for (const debugger::Remark& remark : debugger::remarks(inquiry.question))
        if (remark.refused) return remark.text;
    if (inquiry.hit && inquiry.hit->status != HitStatus::ok)
        return "The library refused this question, and blocks it at START.";
    return std::nullopt;
}

}  // namespace surefoot::playground
