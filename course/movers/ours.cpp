#include <surefoot/character.hpp>

#include "course/movers/movers.hpp"

namespace surefoot::course {
namespace {

class Ours final : public Mover {
public:
    [[nodiscard]] bool takes(const Shape& /*shape*/) const override { return true; }
    void load(const Run& run) override {
        run_ = &run;
        level_ = std::make_unique<LevelWorld>(*run.level);
        state_ = {};
        reference_ = reference_from_centre(run.settings);
        state_.position = run.start + reference_;
    }

    Answer tick(const Input& input, double dt, std::span<const Pose> poses) override {
        level_->move_to(poses);
        state_ = step(level_->world(), run_->settings, {.wish = input.wish, .jump = input.jump}, dt, state_).state;
        return {state_.position - reference_, state_.footing == Footing::ground};
    }

private:
    const Run* run_ = nullptr;
    std::unique_ptr<LevelWorld> level_;
    CharacterState state_;
    dvec3 reference_{0, 0, 0};  // from the centre
};

}  // namespace

std::unique_ptr<Mover> make_ours() {
    return std::make_unique<Ours>();
}

}  // namespace surefoot::course
