#include "playground/debugger_room/answer_panel.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "debugger/gap_curve.hpp"
#include "moment.hpp"
#include "text.hpp"
#include "view/fonts.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace ui = view::ui;

double length_of(const Motion& motion) {
    return glm::length(motion.to - motion.from);
}

const char* feature_word(Feature feature) {
    return feature == Feature::face ? "the face" : feature == Feature::edge ? "an edge" : "a vertex";
}

std::string t_of(const std::optional<Hit>& hit) {
    return hit ? fmt::format("{:.12g}", hit->t) : "none";
}

}  // namespace

std::string answer_in_a_line(const Investigation& asked) {
    const auto& hit = asked.hit();
    const double length = length_of(asked.question().motion);
    if (const auto& saved = asked.saved_step())
        return fmt::format("A saved step: it wanted to go {:.4g} m, and went {:.4g} m.", length,
                           glm::length(saved->capture.after.position - saved->capture.before.position));
    if (!hit) return fmt::format("No hit: the whole way of {:.4g} m is free.", length);
    if (hit->status != HitStatus::ok)
        return hit->status == HitStatus::invalid ? "Blocked at START: the question is beyond the limits (invalid)."
                                                 : "Blocked at START: a bound on the work was exceeded (overflow).";
    if (hit->started_inside)
        return fmt::format("HIT at t = 0: at START it touches triangle {} and would go deeper.", hit->triangle);
    return fmt::format("HIT at t = {:.6f}, after {:.4g} m: {} of triangle {}.", hit->t, hit->t * length,
                       feature_word(hit->feature), hit->triangle);
}

void AnswerPanel::numbers(Investigation& asked) const {
    const auto& hit = asked.hit();
    if (asked.touches()) {
        const auto& level = asked.level();
        const debugger::Question& question = asked.question();
        const double gap = debugger::gap_at(question.volume(), asked.place_at(hit->t), asked.triangle_hit());
        std::string text = fmt::format(
            "t        {:.12g}\nafter    {:.6g} m\nfeature  {}\ntriangle {}\nnormal   {:+.4f} {:+.4f} {:+.4f}\n"
            "point    {:.4g} {:.4g} {:.4g}\ngap      {:.3g} m",
            hit->t, hit->t * length_of(question.motion), feature_word(hit->feature), hit->triangle, hit->normal.x,
            hit->normal.y, hit->normal.z, hit->point.x, hit->point.y, hit->point.z, gap);
        if (level) text += "\nsurface  " + tools::surface_text(level->level, hit->surface);
        ImGui::PushFont(view::fonts().mono);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopFont();
    } else {
        ui::wrapped(answer_in_a_line(asked));
    }
    if (!asked.level()) return;
    const bool brute = asked.search() == Search::brute_force;
    if (ui::radio("Tree", !brute)) asked.choose_search(Search::tree);
    ImGui::SameLine();
    if (ui::radio("Brute force", brute)) asked.choose_search(Search::brute_force);
    ui::hint(
        "Asks every triangle of the level, whenever the question changes; of a very large one, when a drag is over.");
    if (asked.search_waits())
        ui::note(fmt::format("tree  t = {}\nAll {} triangles are asked when you let go.", t_of(hit),
                             tools::grouped(asked.level()->level.mesh.triangle_count())));
    else if (asked.search() == Search::brute_force)
        ui::note(fmt::format(
            "tree  t = {}\nbrute t = {}\n{}", t_of(asked.by_tree()), t_of(hit),
            difference_of(hit, asked.by_tree()).any() ? "They differ: please save this moment." : "The same bits."));
}

void AnswerPanel::save(const Investigation& asked, view::Toasts& toasts) {
    if (file_.empty() && !folder_.empty()) {
        std::error_code error;
        std::filesystem::create_directories(folder_, error);  // writing says what is wrong with it
        file_ = free_name(folder_);
    }
    if (file_.empty()) {
        toasts.warn("Say first which file the moment is to be saved in.");
        return;
    }
    const auto written = write_capture(asked.capture(), file_);
    if (!written) {
        toasts.warn(written.error().text);
        return;
    }
    std::error_code error;
    const auto whole = std::filesystem::absolute(file_, error);
    toasts.say("Saved: " + (error ? file_ : whole.lexically_normal().string()));
    file_.clear();  // the next one is another moment
}

void AnswerPanel::keeping(const Investigation& asked, view::Display& display, view::Toasts& toasts) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##file", folder_.empty() ? "file.json" : "file.json, or where the last one went", &file_);
    ui::item("File");
    if (ui::button("Save this moment")) save(asked, toasts);
    ui::hint(
        "One small file with the question, the triangles near the way and the answer: for `surefoot replay`, and "
        "for dropping it here again.");
    if (ui::button("Copy as C++ test")) {
        display.set_clipboard(capture_cpp_test(asked.capture()));
        toasts.say("A test in C++ is in the clipboard.");
    }
}

void AnswerPanel::ui(Investigation& asked, view::Display& display, view::Toasts& toasts) {
    if (const auto& moment = asked.moment()) {
        ui::heading(std::filesystem::path(moment->file).filename().string());
        ui::wrapped(verdict_text(*moment));
        const std::string saved = moment->capture.answer ? "t = " + t_of(moment->capture.answer) : "no hit";
        ui::note(fmt::format("Saved answer: {}. {} triangle{}. {}{}{}", saved, moment->capture.triangles.size(),
                             moment->capture.triangles.size() == 1 ? "" : "s", moment->remark,
                             moment->capture.note.empty() ? "" : "\n", moment->capture.note));
    }
    numbers(asked);
    if (ui::section("Why", false)) {
        if (why_is_ != asked.version()) {
            const Capture capture = asked.capture();
            why_ = tools::why_text(capture, capture.answer);
            why_is_ = asked.version();
        }
        ui::wrapped(why_);
    }
    if (ui::section("Keep it", false)) keeping(asked, display, toasts);
}

}  // namespace surefoot::playground
