// Thirty staged stops. The sentence names the triangle, the rule and the number; and with that number changed by the
// stated margin, and nothing else, the character gets where it did not.
#include <algorithm>
#include <cstdlib>

#include "why_stages.hpp"

namespace surefoot::tests {
namespace {

/// The character after the stage has been played, and the sentences about the tick that was asked about.
struct Played {
    Actor actor;
    std::vector<StepSentence> sentences;
    std::string text;
};

const StepSentence* find(const Stage& stage, const std::vector<StepSentence>& sentences) {
    for (const StepSentence& one : sentences) {
        if (one.about.rule == stage.rule && one.text.find(stage.says) != std::string::npos) return &one;
    }
    return nullptr;
}

Played play(const Stage& stage, const CharacterSettings& settings) {
    const World world = stage.scene.world();
    Played played;
    played.actor.settings = settings;
    played.actor.state.position = stage.start;
    Actor& actor = played.actor;
    std::vector<StepRecord> room(4096);
    const int waits = 30;  // until it stands
    const int ticks = waits + static_cast<int>(stage.seconds / actor.dt);
    for (int i = 0; i < ticks; ++i) {
        CharacterInput input;
        if (i >= waits) input = {.wish = stage.wish, .jump = stage.jumps};
        StepTrace trace(room);
        StepStory story{settings, input, actor.dt, actor.state, {}, {}, 0};
        story.result = step(world, settings, input, actor.dt, actor.state, {}, &trace);
        story.records = trace.records();
        actor.state = story.result.state;
        actor.events |= story.result.events.set;
        if (!stage.passes && i + 1 < ticks) continue;
        const std::vector<StepSentence> sentences = explain(story);
        const bool is_it = find(stage, sentences) != nullptr;
        if (stage.passes && !is_it && i + 1 < ticks) continue;
        if (!played.text.empty()) continue;
        played.sentences = sentences;
        played.text = explain_text(story);
    }
    return played;
}

/// The number that follows these words.
double number_after(const std::string& text, const std::string& words) {
    const std::size_t place = text.find(words);
    return place == std::string::npos ? -1 : std::strtod(text.c_str() + place + words.size(), nullptr);
}

class StagedStop : public testing::TestWithParam<Stage> {};

TEST_P(StagedStop, IsToldWithTriangleRuleAndNumberAndChangingTheNumberFlipsIt) {
    const Stage& stage = GetParam();
    const Played stopped = play(stage, stage.settings);
    ASSERT_FALSE(stage.succeeded(stopped.actor)) << "it was to be stopped\n" << stopped.text;
    const StepSentence* const told = find(stage, stopped.sentences);
    ASSERT_NE(told, nullptr) << stopped.text;
    const auto is_named = [&](std::uint32_t triangle) {
        return told->text.find("triangle " + std::to_string(triangle) + " of body 0") != std::string::npos;
    };
    EXPECT_TRUE(stage.triangles.empty() || std::any_of(stage.triangles.begin(), stage.triangles.end(), is_named))
        << stopped.text;
    const double number = number_after(told->text, stage.says);
    EXPECT_NEAR(number, stage.number, stage.within) << stopped.text;
    CharacterSettings changed = stage.settings;
    stage.change(changed, number);
    const Played freed = play(stage, changed);
    EXPECT_TRUE(stage.succeeded(freed.actor)) << stopped.text << "and with the number changed\n" << freed.text;
}

INSTANTIATE_TEST_SUITE_P(Why, StagedStop, testing::ValuesIn(stages()), [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace surefoot::tests
