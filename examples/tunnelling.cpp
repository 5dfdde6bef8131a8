// A fast jump through a thin wall: looking at samples tunnels, sweeping between them does not. Explained in
// docs/using.md.
#include <cstdio>

#include <surefoot/surefoot.hpp>

int main() {
    // [tunnelling]
    const surefoot::Triangle wall{.a = {-5, 0, 5}, .b = {5, 0, 5}, .c = {0, 9, 5}};
    const surefoot::Sphere ball{.radius = 0.25};
    const surefoot::JumpArc shot{.from = {0, 1, 0}, .velocity = {0, 4, 60}, .duration = 0.5};

    // Thirty metres in fifteen steps: two metres each, and the ball is half a metre across.
    const auto sampled = surefoot::march(ball, shot, wall, {.steps = 15, .guarded = false});
    const auto guarded = surefoot::march(ball, shot, wall, {.steps = 15, .guarded = true});
    // [/tunnelling]
    const auto patient = surefoot::march(ball, shot, wall, {.steps = 150, .guarded = false});

    std::printf("15 samples: %s\n", sampled ? "stopped" : "through the wall");
    if (guarded) std::printf("15 samples, guarded: stopped at z = %.3f m\n", guarded->position.z);
    if (patient) std::printf("150 samples: stopped at z = %.3f m\n", patient->position.z);
    return !sampled && guarded && guarded->position.z <= 4.75 && patient ? 0 : 1;
}
