// "Why did I stop?" A character walks against a kerb that is too high; its last seconds are in a ring, and the moment
// and the session are saved. Explained in docs/why.md.
//
//     example_why_stopped [FOLDER]     where level.surefoot, stopped.json and session.json go
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace {

// A floor, and a block in its way that is 0.52 m high.
surefoot::Expected<surefoot::Mesh> make_level() {
    const std::vector<surefoot::vec3> vertices{{-10, 0, -10},  {-10, 0, 10},    {2, 0, 10},     {2, 0, -10},
                                               {2, 0.52F, 10}, {2, 0.52F, -10}, {6, 0.52F, 10}, {6, 0.52F, -10}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5, 5, 4, 6, 5, 6, 7};
    return surefoot::Mesh::build({.vertices = vertices, .indices = indices});
}

}  // namespace

int main(int count, char** arguments) {
    const auto level = make_level();
    surefoot::World world;
    if (!level || !world.add(*level)) return 1;

    surefoot::CharacterSettings settings;
    settings.volume = surefoot::Box{.half_extents = {0.3, 0.9, 0.3}};
    surefoot::CharacterState state;
    state.position = {0, 1, 0};
    const surefoot::CharacterInput input{.wish = {3, 0, 0}};
    const double dt = 1.0 / 60;

    // [ring]
    std::vector<surefoot::RingTick> room(10 * 60);  // yours: ten seconds at 60 Hz
    surefoot::StepRing ring(room);

    for (int tick = 0; tick < 90; ++tick) {
        ring.push(input, dt, state);
        state = surefoot::step(world, settings, input, dt, state).state;
    }
    // [/ring]

    // [why]
    std::vector<surefoot::StepRecord> records(1024);  // a usual step has a few dozen
    surefoot::StepTrace trace(records);
    const surefoot::StepResult result = surefoot::step(world, settings, input, dt, state, {}, &trace);
    const surefoot::StepStory story{.settings = settings,
                                    .input = input,
                                    .dt = dt,
                                    .before = state,
                                    .result = result,
                                    .records = trace.records(),
                                    .dropped = trace.dropped()};
    for (const surefoot::StepSentence& sentence : surefoot::explain(story)) std::puts(sentence.text.c_str());
    // [/why]

    // [counterfactual]
    settings.step_up = 0.53;
    const surefoot::StepResult freed = surefoot::step(world, settings, input, dt, state);
    std::printf("With step_up = 0.53 it rises by %.2f m.\n", freed.state.position.y - state.position.y);
    // [/counterfactual]
    settings.step_up = 0.4;

    if (count > 1) {
        const std::string folder = arguments[1];
        // [save]
        surefoot::StepCapture moment = surefoot::capture_step(world, settings, input, dt, state);
        moment.note = "I expected to get up here";
        const auto saved = surefoot::write_capture(moment, folder + "/stopped.json");
        const surefoot::Session session = surefoot::session_of(ring, world, settings, state);
        const auto kept = surefoot::write_session(session, folder + "/session.json");
        // [/save]
        if (!saved || !kept || !level->write(folder + "/level.surefoot")) return 1;
    }
    return freed.events.has(surefoot::CharacterEvent::stepped_up) ? 0 : 1;
}
