// Search: what the sweep asked of a level, in order, and what the tree spares.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <vector>

#include <surefoot/sweep.hpp>

#include "debugger/equation.hpp"
#include "debugger/search_log.hpp"
#include "playground/debugger_room/order_cursor.hpp"
#include "playground/debugger_room/panels_maths.hpp"
#include "playground/debugger_room/subjects.hpp"
#include "text.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace paint = view::paint;
namespace ui = view::ui;
using debugger::SearchRun;
using debugger::short_text;

constexpr double quiet_seconds = 0.25;   // every triangle of a level is asked only when the question rests
constexpr std::size_t most_drawn = 600;  // of the steps before the one that is looked at
constexpr view::Colour box_colour = view::rgb(0x5C8FB8);

class SearchPanel final : public Panel {
public:
    [[nodiscard]] std::string_view name() const override { return "Search"; }
    void enter(Stage& stage) override { timed_ = !stage.headless; }
    void changed(const Inquiry& inquiry) override;
    bool update(double dt, Inquiry& inquiry) override;
    void draw(view::Renderer& renderer, const Inquiry& inquiry) override;
    void ui(Inquiry& inquiry) override;

private:
    void order_ui();
    void steps_ui() const;
    void comparison_ui() const;
    [[nodiscard]] std::string text_of(const SearchStep& step) const;
    [[nodiscard]] static Triangle triangle_of(const SearchStep& step, const Inquiry& inquiry);

    bool timed_ = true;
    bool has_tree_ = false;
    std::optional<std::string> refusal_;
    std::vector<SearchStep> steps_;
    std::vector<std::string> answers_;  // of a few triangles, one each
    std::optional<std::uint32_t> met_;
    OrderCursor cursor_;
    std::optional<debugger::SearchComparison> comparison_;
    double rest_ = 0;
};

void SearchPanel::changed(const Inquiry& inquiry) {
    refusal_ = why_no_answer(inquiry);
    comparison_.reset();
    rest_ = 0;
    steps_.clear();
    answers_.clear();
    met_.reset();
    has_tree_ = inquiry.arena.mesh() != nullptr;
    if (!refusal_) {
        const auto& q = inquiry.question;
        if (inquiry.hit) met_ = inquiry.hit->triangle;
        if (has_tree_) {
            SearchRun run =
                debugger::run_search(*inquiry.arena.mesh(), q.volume(), q.motion, Search::scalar_tree, q.one_sided, 1);
            steps_ = std::move(run.steps);
        } else {
            for (const Triangle& triangle : q.triangles) {
                SearchStep step{.kind = SearchStep::Kind::triangle};
                step.triangle = static_cast<std::uint32_t>(steps_.size());
                steps_.push_back(step);
                const auto hit = sweep(q.volume(), q.motion, triangle, {.one_sided = q.one_sided});
                answers_.push_back(hit ? "t = " + short_text(hit->t) : "no hit");
            }
        }
    }
    cursor_.restart(steps_.size());
}

bool SearchPanel::update(double dt, Inquiry& inquiry) {
    const bool moves = cursor_.advance(dt);
    if (!has_tree_ || refusal_ || comparison_) return moves;
    rest_ = inquiry.is_dragged ? 0 : rest_ + dt;
    if (rest_ >= quiet_seconds) {
        const auto& q = inquiry.question;
        comparison_ = debugger::compare_searches(*inquiry.arena.mesh(), q.volume(), q.motion, q.one_sided);
    }
    return true;
}

Triangle SearchPanel::triangle_of(const SearchStep& step, const Inquiry& inquiry) {
    const Mesh* const mesh = inquiry.arena.mesh();
    return mesh != nullptr ? mesh->triangle(step.triangle) : inquiry.question.triangles[step.triangle];
}

void SearchPanel::draw(view::Renderer& renderer, const Inquiry& inquiry) {
    const std::size_t shown = cursor_.shown();
    for (std::size_t i = shown > most_drawn ? shown - most_drawn : 0; i < shown; ++i) {
        const SearchStep& step = steps_[i];
        const bool last = i + 1 == shown;
        if (step.kind == SearchStep::Kind::box) {
            renderer.box(step.box, {.colour = last ? paint::contact : view::with_opacity(box_colour, 0.55),
                                    .width = last ? 3.0 : 1.2,
                                    .behind = last ? 0.5 : 0.15});
            continue;
        }
        const Triangle t = triangle_of(step, inquiry);
        const dvec3 corners[3] = {t.a, t.b, t.c};
        const bool met = met_ == step.triangle;
        const view::Colour colour = last ? paint::contact : met ? paint::hit : paint::face;
        renderer.triangle(t.a, t.b, t.c, view::with_opacity(colour, last || met ? 0.55 : 0.3));
        renderer.polyline(corners, {.colour = colour, .width = last || met ? 3.0 : 1.5, .behind = 0.4}, true);
    }
}

void SearchPanel::ui(Inquiry& /*inquiry*/) {
    if (refusal_) {
        ui::note(*refusal_);
        return;
    }
    if (!has_tree_)
        ui::note(fmt::format(
            "There is no tree here: {} asked one after the other. Open a level to see one.",
            steps_.size() == 1 ? "the only triangle is" : fmt::format("all {} triangles are", steps_.size())));
    if (has_tree_ && ui::section("Three ways to the same answer")) comparison_ui();
    if (steps_.empty()) {
        ui::note("Not one box was opened: the motion comes near nothing.");
        return;
    }
    if (!has_tree_ || ui::section("In order")) {
        order_ui();
        steps_ui();
    }
}

void SearchPanel::order_ui() {
    if (ui::button(cursor_.is_playing() ? "Pause" : "Play", 72)) {
        if (cursor_.is_playing())
            cursor_.pause();
        else
            cursor_.play();
    }
    ImGui::SameLine();
    if (ui::button("<", 30) && cursor_.shown() > 0) cursor_.show(cursor_.shown() - 1);
    ImGui::SameLine();
    if (ui::button(">", 30)) cursor_.show(cursor_.shown() + 1);
    ui::at_right(fmt::format("{} of {}", tools::grouped(cursor_.shown()), tools::grouped(cursor_.count())));
    auto step = static_cast<double>(cursor_.shown());
    if (ui::slider("Step", step, 0, static_cast<double>(cursor_.count()), "%.0f"))
        cursor_.show(static_cast<std::size_t>(std::lround(step)));
    if (!has_tree_) return;
    const auto boxes = std::count_if(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(cursor_.shown()),
                                     [](const SearchStep& s) { return s.kind == SearchStep::Kind::box; });
    ui::key_colour(box_colour, fmt::format("{} boxes opened", tools::grouped(static_cast<std::uint64_t>(boxes))));
    ImGui::SameLine(0, 18);
    ui::key_colour(paint::face, fmt::format("{} triangles asked",
                                            tools::grouped(cursor_.shown() - static_cast<std::size_t>(boxes))));
}

std::string SearchPanel::text_of(const SearchStep& step) const {
    if (step.kind == SearchStep::Kind::box) return fmt::format("box, reached at t = {}", short_text(step.enters));
    const std::string answer = !answers_.empty()       ? answers_[step.triangle]
                               : met_ == step.triangle ? "the first touch"
                                                       : "";
    return fmt::format("triangle {}{}{}", step.triangle, answer.empty() ? "" : ": ", answer);
}

/// The steps around the one that is looked at.
void SearchPanel::steps_ui() const {
    constexpr std::size_t rows = 9;
    const std::size_t shown = cursor_.shown();
    const std::size_t first =
        std::min(shown > rows / 2 + 1 ? shown - rows / 2 - 1 : 0, steps_.size() > rows ? steps_.size() - rows : 0);
    for (std::size_t i = first; i < std::min(first + rows, steps_.size()); ++i) {
        const bool last = i + 1 == shown;
        const bool box = steps_[i].kind == SearchStep::Kind::box;
        const bool met = !box && met_ == steps_[i].triangle;
        view::Colour colour = last ? paint::contact : met ? paint::hit : box ? box_colour : paint::face;
        if (i >= shown) colour = view::with_opacity(colour, 0.35);
        ui::key_colour(colour, fmt::format("{:>4}  {}", i + 1, text_of(steps_[i])));
    }
}

void SearchPanel::comparison_ui() const {
    if (!comparison_) {
        ui::note("Every triangle is asked once the question rests ...");
        return;
    }
    if (ImGui::BeginTable("searches", timed_ ? 5 : 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("");
        ImGui::TableSetupColumn("boxes");
        ImGui::TableSetupColumn("triangles");
        ImGui::TableSetupColumn("t");
        if (timed_) ImGui::TableSetupColumn("time");
        ImGui::TableHeadersRow();
        const std::pair<const char*, const SearchRun*> runs[] = {{"Brute force", &comparison_->brute_force},
                                                                 {"Scalar tree", &comparison_->scalar_tree},
                                                                 {"Tree", &comparison_->tree}};
        for (const auto& [title, run] : runs) {
            ImGui::TableNextRow();
            const std::string cells[] = {title, run->boxes > 0 ? tools::grouped(run->boxes) : "-",
                                         tools::grouped(run->triangles), run->hit ? short_text(run->hit->t) : "no hit",
                                         tools::duration(run->seconds)};
            for (int column = 0; column < (timed_ ? 5 : 4); ++column) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(cells[column].c_str());
            }
        }
        ImGui::EndTable();
    }
    if (comparison_->same_answer)
        ui::note("The same answer, to the last bit of t.");
    else
        ui::key_colour(paint::start, "THE ANSWERS DIFFER");
}

}  // namespace

std::unique_ptr<Panel> make_search_panel() {
    return std::make_unique<SearchPanel>();
}

}  // namespace surefoot::playground
