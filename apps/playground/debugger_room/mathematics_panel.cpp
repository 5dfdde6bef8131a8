// Mathematics: the squashed world, the table of candidates, and the graph of the gap.
#include <algorithm>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <vector>

#include "debugger/gap_curve.hpp"
#include "debugger/method_table.hpp"
#include "debugger/plane_table.hpp"
#include "debugger/support.hpp"
#include "playground/debugger_room/answer_rows.hpp"
#include "playground/debugger_room/drawn_world.hpp"
#include "playground/debugger_room/feature_light.hpp"
#include "playground/debugger_room/framing.hpp"
#include "playground/debugger_room/gap_graph.hpp"
#include "playground/debugger_room/panels_maths.hpp"
#include "playground/debugger_room/subjects.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace paint = view::paint;
namespace ui = view::ui;

constexpr double squash_seconds = 1.6;

class MathematicsPanel final : public Panel {
public:
    [[nodiscard]] std::string_view name() const override { return "Mathematics"; }
    void changed(const Inquiry& inquiry) override;
    bool update(double dt, Inquiry& inquiry) override;
    void draw(view::Renderer& renderer, const Inquiry& inquiry) override;
    void ui(Inquiry& inquiry) override;
    [[nodiscard]] std::vector<dvec3> scene_places() const override;

private:
    void take_apart(const Inquiry& inquiry);
    [[nodiscard]] const Triangle& triangle() const { return subjects_[subject_].triangle; }
    void draw_beside(view::Renderer& renderer, const Inquiry& inquiry) const;
    void draw_lit(view::Renderer& renderer, const Inquiry& inquiry, const DrawnWorld& world) const;
    void squash_ui();
    void subject_ui(const Inquiry& inquiry);
    void table_ui(const Inquiry& inquiry);

    std::optional<std::string> refusal_;
    std::vector<Subject> subjects_;
    std::size_t subject_ = 0;
    std::optional<debugger::MethodTable> method_;
    debugger::PlaneTable planes_;
    std::vector<AnswerRow> rows_;
    debugger::GapCurve curve_;
    dvec3 offset_{0, 0, 0};
    std::vector<dvec3> squashed_;  // what is to be seen of the world beside, at the end of its way
    bool beside_ = true;
    double s_ = 1;
    std::optional<double> goal_;  // where s goes by itself
    double left_ = 1;             // where it left, and how much of the way is gone
    double gone_ = 0;
    bool larger_root_ = false;
    std::optional<std::size_t> pinned_;
    std::optional<std::size_t> lit_;
};

void MathematicsPanel::changed(const Inquiry& inquiry) {
    refusal_ = why_no_answer(inquiry);
    subjects_.clear();
    if (refusal_) return;
    subjects_ = subjects_of(inquiry);
    if (subjects_.empty()) return;
    subject_ = foremost(subjects_, inquiry);
    take_apart(inquiry);
}

void MathematicsPanel::take_apart(const Inquiry& inquiry) {
    const auto& question = inquiry.question;
    const Volume volume = question.volume();
    curve_ = debugger::gap_curve(volume, question.motion, triangle(), 160, question.one_sided);
    method_.reset();
    if (debugger::is_squashable(volume.shape)) {
        method_ = debugger::method_table(
            volume, question.motion, triangle(),
            {.one_sided = question.one_sided, .root = larger_root_ ? debugger::Root::upper : debugger::Root::lower});
        rows_ = rows_of(*method_);
        std::vector<Triangle> triangles;
        for (const Subject& subject : subjects_) triangles.push_back(subject.triangle);
        const Mesh* const mesh = inquiry.arena.mesh();
        offset_ = offset_beside(volume, question.motion, triangles,
                                mesh != nullptr ? std::optional(mesh->bounds()) : std::nullopt);
        const DrawnWorld world = world_beside(volume, question.motion, 1, offset_);
        squashed_.clear();
        for (const dvec3& end : {question.motion.from, question.motion.to})
            append_corners(squashed_, debugger::bounds_of(world.volume, world.point(end)));
        for (const Triangle& t : triangles)
            for (const dvec3& corner : {t.a, t.b, t.c}) squashed_.push_back(world.point(corner));
    } else {
        planes_ = debugger::plane_table(volume, question.motion, triangle(), question.one_sided);
        rows_ = rows_of(planes_);
    }
    if (pinned_ && *pinned_ >= rows_.size()) pinned_.reset();
    if (lit_ && *lit_ >= rows_.size()) lit_.reset();
}

bool MathematicsPanel::update(double dt, Inquiry& /*inquiry*/) {
    if (!goal_) return false;
    gone_ = std::min(gone_ + dt / squash_seconds, 1.0);
    // Slow at both ends, so that the eye can follow.
    s_ = left_ + (*goal_ - left_) * gone_ * gone_ * (3 - 2 * gone_);
    if (gone_ == 1) {
        s_ = *goal_;
        goal_.reset();
    }
    return true;
}

std::vector<dvec3> MathematicsPanel::scene_places() const {
    return method_ && beside_ ? squashed_ : std::vector<dvec3>();
}

void MathematicsPanel::draw(view::Renderer& renderer, const Inquiry& inquiry) {
    if (subjects_.empty()) return;
    const Triangle& t = triangle();
    const dvec3 corners[3] = {t.a, t.b, t.c};
    if (subjects_.size() > 1) renderer.polyline(corners, {.colour = paint::face, .width = 2.5, .behind = 0.35}, true);
    draw_lit(renderer, inquiry, real_world(inquiry.question.volume()));
    if (method_ && beside_) draw_beside(renderer, inquiry);
}

void MathematicsPanel::draw_lit(view::Renderer& renderer, const Inquiry& inquiry, const DrawnWorld& world) const {
    if (!lit_) return;
    const Volume volume = inquiry.question.volume();
    const Motion& motion = inquiry.question.motion;
    if (method_) {
        const debugger::Candidate& candidate = method_->candidates[*lit_];
        light_feature(renderer, world, volume, motion.from, triangle(), candidate.feature, candidate.index);
        if (candidate.contact)
            renderer.point(world.point(*candidate.contact), 9, candidate.kept ? paint::hit : paint::contact);
    } else {
        light_plane(renderer, volume, motion.from + (motion.to - motion.from) * inquiry.t, triangle(),
                    planes_.rows[*lit_].normal, rows_[*lit_].colour);
    }
}

void MathematicsPanel::draw_beside(view::Renderer& renderer, const Inquiry& inquiry) const {
    const Motion& motion = inquiry.question.motion;
    const DrawnWorld world = world_beside(inquiry.question.volume(), motion, s_, offset_);
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
        const Triangle& t = subjects_[i].triangle;
        const dvec3 corners[3] = {world.point(t.a), world.point(t.b), world.point(t.c)};
        const bool chosen = i == subject_;
        renderer.triangle(corners[0], corners[1], corners[2],
                          view::with_opacity(view::rgb(0xD8DEE3), chosen ? 0.55 : 0.22));
        renderer.polyline(corners, {.colour = chosen ? paint::face : paint::ink, .width = chosen ? 2.5 : 1.2}, true);
        if (!chosen) continue;
        const dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        for (std::size_t k = 0; k < 3; ++k)
            renderer.label({.place = corners[k] + (corners[k] - middle) * 0.05,
                            .text = std::string(1, char('a' + k)),
                            .yields = true});
    }
    const auto at = [&](double t) { return world.point(motion.from + (motion.to - motion.from) * t); };
    renderer.arrow(at(0), at(1), {.colour = paint::ink, .width = 2});
    renderer.shape(world.volume, at(0), {.colour = paint::start, .opacity = 0.3});
    renderer.shape(world.volume, at(1), {.colour = paint::end, .opacity = 0.3});
    if (curve_.t_star) renderer.shape(world.volume, at(*curve_.t_star), {.colour = paint::hit, .opacity = 0.4});
    if (inquiry.t > 0 && inquiry.t < 1 && inquiry.t != curve_.t_star)
        renderer.shape(world.volume, at(inquiry.t), {.colour = paint::accent, .opacity = 0.15, .outline = 1.5});
    draw_lit(renderer, inquiry, world);
    const double r = std::max({world.squash.radii.x, world.squash.radii.y, world.squash.radii.z});
    renderer.label({.place = at(0) + dvec3(0, 1.3 * r, 0),
                    .text = s_ == 1   ? "squashed: the ball of radius 1"
                            : s_ == 0 ? "the world as it is"
                                      : fmt::format("on the way, s = {:.2f}", s_),
                    .offset = {0, -14},
                    .yields = true});
}

void MathematicsPanel::ui(Inquiry& inquiry) {
    if (refusal_) {
        ui::note(*refusal_);
        return;
    }
    if (subjects_.empty()) {
        ui::note("The sweep asked no triangle: its boxes were all out of the way.");
        return;
    }
    if (subjects_.size() > 1) subject_ui(inquiry);
    squash_ui();
    if (ui::section("The gap g(t)")) {
        gap_graph(curve_, inquiry.t);
        ui::hint(curve_.method);
    }
    if (ui::section(method_ ? "Seven candidates" : "Planes that were tried"))
        table_ui(inquiry);
    else
        lit_.reset();
}

void MathematicsPanel::subject_ui(const Inquiry& inquiry) {
    std::vector<std::string> names;
    for (const Subject& subject : subjects_) names.push_back(fmt::format("{}", subject.id));
    std::vector<const char*> pointers;
    for (const std::string& name : names) pointers.push_back(name.c_str());
    int chosen = static_cast<int>(subject_);
    if (!ui::choice("Triangle", chosen, pointers)) return;
    subject_ = static_cast<std::size_t>(chosen);
    take_apart(inquiry);
}

void MathematicsPanel::squash_ui() {
    if (!method_) {
        ui::note("Only sphere and ellipsoid have a squashed world. Here planes decide.");
        return;
    }
    ui::checkbox("Squashed world", beside_);
    if (!beside_) return;
    const bool out = goal_ ? *goal_ == 1 : s_ == 1;
    ImGui::SameLine();
    if (ui::button(out ? "Unsquash" : "Squash", 84)) {
        goal_ = out ? 0 : 1;
        left_ = s_;
        gone_ = 0;
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const double low = 0;
    const double high = 1;
    if (ImGui::SliderScalar("##squashing", ImGuiDataType_Double, &s_, &low, &high, "s = %.2f",
                            ImGuiSliderFlags_AlwaysClamp))
        goal_.reset();
    ui::item("Squashing");
}

void MathematicsPanel::table_ui(const Inquiry& inquiry) {
    const std::string& conclusion = method_ ? method_->conclusion : planes_.conclusion;
    const bool wrong = method_ && larger_root_;
    ImGui::PushTextWrapPos(0);
    ImGui::PushStyleColor(ImGuiCol_Text, view::to_imgui(wrong ? view::rgb(0xF08A80) : paint::paper));
    ImGui::TextUnformatted((wrong ? "Wrong: " + conclusion : conclusion).c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    lit_ = answer_rows(rows_, pinned_);
    if (!method_) return;
    if (ui::checkbox("Larger root (wrong on purpose)", larger_root_)) take_apart(inquiry);
    ui::hint("The classic mistake: the larger root is where the ball ceases to touch, not where it begins to.");
}

}  // namespace

std::unique_ptr<Panel> make_mathematics_panel() {
    return std::make_unique<MathematicsPanel>();
}

}  // namespace surefoot::playground
