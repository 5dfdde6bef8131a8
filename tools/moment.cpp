#include "moment.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <vector>

#include "command.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

dvec3 along(const Motion& motion, double t) {
    return motion.from + t * (motion.to - motion.from);
}

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", grouped(count), what, count == 1 ? "" : "s");
}

std::string feature_words(const TraceRecord& record) {
    constexpr std::array edges{"ab", "bc", "ca"};
    constexpr std::array corners{"a", "b", "c"};
    const std::size_t index = std::min<std::size_t>(record.feature_index, 2);
    if (record.feature == Feature::face) return "its face";
    return record.feature == Feature::edge ? fmt::format("its edge {}", edges[index])
                                           : fmt::format("its vertex {}", corners[index]);
}

std::string name_of(const Capture& capture, const CapturedTriangle& one) {
    return capture.bodies.empty() ? fmt::format("triangle {}", one.id)
                                  : fmt::format("triangle {} of body {}", one.id, one.body);
}

/// The same question with one of its triangles alone, so that every record is about that one.
Capture only(const Capture& capture, const CapturedTriangle& one) {
    Capture alone;
    alone.question = capture.question;
    alone.triangles = {one};
    for (const CapturedBody& body : capture.bodies)
        if (body.body == one.body) alone.bodies = {body};
    return alone;
}

/// What was tried between the moving shape and one triangle.
struct Tried {
    std::optional<Hit> hit;
    std::vector<TraceRecord> records;
};

Tried try_alone(const Capture& capture, const CapturedTriangle& one) {
    std::vector<TraceRecord> room(4096);
    Trace trace(room);
    Tried tried{replay(only(capture, one), &trace).answer, {}};
    tried.records.assign(trace.records().begin(), trace.records().end());
    return tried;
}

std::size_t planes_in(const Tried& tried) {
    return static_cast<std::size_t>(std::count_if(tried.records.begin(), tried.records.end(),
                                                  [](const TraceRecord& r) { return r.verdict != Verdict::decided; }));
}

/// The plane that the answer comes from: of those entered the one of the hit, of those in touch the shallowest.
const TraceRecord* deciding(const Tried& tried) {
    const TraceRecord* best = nullptr;
    for (const TraceRecord& record : tried.records) {
        if (record.verdict == Verdict::enters && !tried.hit->started_inside && record.normal == tried.hit->normal)
            if (best == nullptr || record.t > best->t) best = &record;
        if (record.verdict == Verdict::contact && tried.hit->started_inside)
            if (best == nullptr || record.gap_from > best->gap_from) best = &record;
    }
    return best;
}

std::string why_it_stopped(const Capture& capture, const CapturedTriangle& one) {
    const Tried tried = try_alone(capture, one);
    std::string text;
    const auto count = [&](Verdict verdict) {
        return std::count_if(tried.records.begin(), tried.records.end(),
                             [&](const TraceRecord& record) { return record.verdict == verdict; });
    };
    text += fmt::format("It is {} that stops the motion.\n", name_of(capture, one));
    if (capture.question.kind == CaptureKind::ray)
        return text + "The segment meets the closed triangle; that is decided exactly, without planes.\n";
    text += fmt::format(
        "{} were tried between the shape and that triangle: the motion enters {}, leaves {}, and is "
        "behind {} all along.\n",
        counted(planes_in(tried), "plane"), count(Verdict::enters), count(Verdict::leaves), count(Verdict::inside));
    const TraceRecord* const plane = tried.hit ? deciding(tried) : nullptr;
    if (plane == nullptr) return text;
    if (tried.hit->started_inside)
        return text + fmt::format(
                          "They touch or overlap at the start, the least along the plane of {}, by {} m; the "
                          "motion would go deeper, so it is stopped at t = 0.\n",
                          feature_words(*plane), short_number(-plane->gap_from));
    return text + fmt::format(
                      "The plane that decides is that of {}, with the normal ({}): the gap along it is {} m at "
                      "the start and would be {} m at the end. It closes at t = {}, and no plane that is "
                      "entered later keeps them apart.\n",
                      feature_words(*plane), short_vector(plane->normal), short_number(plane->gap_from),
                      short_number(plane->gap_to), short_number(tried.hit->t));
}

/// What keeps one triangle apart, and how far at least; nothing if no plane separates them (they part, or slide along).
const TraceRecord* separating(const Tried& tried) {
    const TraceRecord* best = nullptr;
    const auto least = [](const TraceRecord& record) { return std::min(record.gap_from, record.gap_to); };
    for (const TraceRecord& record : tried.records)
        if (record.verdict == Verdict::separates && (best == nullptr || least(record) > least(*best))) best = &record;
    return best;
}

std::string why_it_is_free(const Capture& capture) {
    if (capture.triangles.empty()) return "There is no triangle near the way.\n";
    if (capture.question.kind == CaptureKind::ray)
        return fmt::format("The segment meets none of {}.\n", counted(capture.triangles.size(), "triangle"));
    std::size_t kept_apart = 0;
    const CapturedTriangle* nearest = nullptr;
    std::optional<TraceRecord> by;
    for (const CapturedTriangle& one : capture.triangles) {
        const Tried tried = try_alone(capture, one);
        const TraceRecord* const plane = separating(tried);
        if (plane == nullptr) continue;
        ++kept_apart;
        if (by && std::min(by->gap_from, by->gap_to) <= std::min(plane->gap_from, plane->gap_to)) continue;
        by = *plane;
        nearest = &one;
    }
    std::string text = fmt::format("Of {} near the way, {} kept apart from it by a plane.\n",
                                   counted(capture.triangles.size(), "triangle"),
                                   kept_apart == 1 ? "1 is" : fmt::format("{} are", grouped(kept_apart)));
    if (nearest != nullptr)
        text += fmt::format(
            "The least gap is that to {}: along the normal ({}) of {} it is {} m at the start and {} m "
            "at the end.\n",
            name_of(capture, *nearest), short_vector(by->normal), feature_words(*by), short_number(by->gap_from),
            short_number(by->gap_to));
    if (kept_apart < capture.triangles.size())
        text += fmt::format(
            "{} by no single plane: the motion does not reach them, or touches and leaves or slides "
            "along them.\n",
            capture.triangles.size() - kept_apart == 1
                ? "1 is"
                : fmt::format("{} are", grouped(capture.triangles.size() - kept_apart)));
    return text;
}

std::string others_text(const Capture& capture, const CapturedTriangle& hit) {
    std::size_t met = 0;
    std::optional<Hit> next;
    for (const CapturedTriangle& one : capture.triangles) {
        if (&one == &hit) continue;
        const std::optional<Hit> other = replay(only(capture, one)).answer;
        if (!other) continue;
        ++met;
        if (!next || other->t < next->t) next = other;
    }
    if (capture.triangles.size() == 1) return "";
    std::string text =
        fmt::format("Of the {} near the way, {} would be met as well",
                    counted(capture.triangles.size() - 1, "other triangle"), met == 0 ? "none" : grouped(met));
    if (next) text += fmt::format(", the first of them triangle {} at t = {}", next->triangle, short_number(next->t));
    return text + ".\n";
}

}  // namespace

std::string question_text(const Capture& capture) {
    const CapturedQuestion& q = capture.question;
    const std::string what = q.kind == CaptureKind::ray ? std::string("ray goes") : describe(q.volume) + " moves";
    std::string text =
        fmt::format("{} {} m from ({}) to ({}){}.\n", what, short_number(glm::length(q.motion.to - q.motion.from)),
                    short_vector(q.motion.from), short_vector(q.motion.to), q.one_sided ? ", one-sided" : "");
    text += fmt::format("Near its way: {}", counted(capture.triangles.size(), "triangle"));
    if (!capture.bodies.empty())
        text += fmt::format(" of {}, during [{}, {}] of the tick",
                            capture.bodies.size() == 1 ? "1 body" : grouped(capture.bodies.size()) + " bodies",
                            short_number(q.begin), short_number(q.end));
    return text + ".\n";
}

std::string moment_answer_text(const CapturedQuestion& question, const std::optional<Hit>& hit) {
    if (!hit) return "  no hit: the whole way is free\n";
    if (hit->status != HitStatus::ok)
        return fmt::format("  blocked at t = {}: {}\n", short_number(hit->t),
                           hit->status == HitStatus::invalid ? "the question is beyond the limits (invalid)"
                                                             : "a stated bound on the work was exceeded (overflow)");
    std::string text = fmt::format("  hit at t = {}{}\n", short_number(hit->t),
                                   hit->started_inside ? ", touching or inside at the start" : "");
    text += fmt::format("  stops at  {} m\n", short_vector(along(question.motion, hit->t)));
    text += fmt::format("  touches   {} m\n", short_vector(hit->point));
    text += fmt::format("  normal    {}\n", short_vector(hit->normal));
    text += fmt::format("  feature   {}\n", in_words(hit->feature));
    text += fmt::format("  triangle  {}, surface {}, body {}\n", hit->triangle, hit->surface, hit->body);
    return text;
}

std::string difference_text(const AnswerDifference& d) {
    std::string text;
    for (const auto& [differs, name] : {std::pair{d.hit, "whether there is a hit"},
                                        {d.t, "t"},
                                        {d.point, "point"},
                                        {d.normal, "normal"},
                                        {d.feature, "feature"},
                                        {d.triangle, "triangle"},
                                        {d.surface, "surface"},
                                        {d.body, "body"},
                                        {d.status, "status"},
                                        {d.started_inside, "started_inside"}})
        if (differs) text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
    return text;
}

std::string why_text(const Capture& capture, const std::optional<Hit>& answer) {
    if (!answer) return why_it_is_free(capture);
    const auto is_hit = [&](const CapturedTriangle& one) {
        return one.body == answer->body && one.id == answer->triangle;
    };
    const auto hit = std::find_if(capture.triangles.begin(), capture.triangles.end(), is_hit);
    if (answer->status != HitStatus::ok || hit == capture.triangles.end())
        return "The question cannot be answered within the limits of docs/using.md, and what cannot be answered "
               "blocks.\n";
    return why_it_stopped(capture, *hit) + others_text(capture, *hit);
}

void save_moment(const Capture& capture, const std::string& path) {
    if (const auto written = write_capture(capture, path); !written)
        throw Failure{ExitCode::file, written.error().text};
}

}  // namespace surefoot::tools
