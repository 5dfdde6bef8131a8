#include "platformer/hero/figure.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::platformer {
namespace {

using view::Colour;
using view::Piece;
using view::Solid;

class Builder {
public:
    Builder(std::vector<Piece>& pieces, const HeroLook& look) : pieces_(pieces), look_(look), c_(look.colours) {}

    void figure(const HeroPose& pose);
    void image(const AfterImage& image);

private:
    void add(const Frame& frame, const dvec3& at, const dvec3& radii, Colour colour, Solid solid = Solid::ball,
             const dmat3& turn = dmat3(1), float glow = 0);
    void body(const Frame& body, const Stance& stance, double clock);
    void head(const Frame& head, const Stance& stance, double clock);
    void eyes(const Frame& head, double open);
    void ears(const Frame& head, double laid_back);
    void scarf(const HeroPose& pose);
    void foot(const Frame& sole);

    std::vector<Piece>& pieces_;
    const HeroLook& look_;
    const HeroColours& c_;
};

void Builder::add(const Frame& frame, const dvec3& at, const dvec3& radii, Colour colour, Solid solid,
                  const dmat3& turn, float glow) {
    Piece p = piece(frame, at, radii, colour, solid, turn);
    p.glow = look_.is_ghost ? 0.5F : glow;
    if (look_.opacity < 1) p.colour = view::with_opacity(colour, look_.opacity);
    // The shade straight below says where it will land; a shadow aside of it, from the sun, would say something else.
    p.casts_shadow = false;
    pieces_.push_back(p);
}

void Builder::body(const Frame& body, const Stance& stance, double clock) {
    add(body, {0, 0.03, 0}, {0.195, 0.245, 0.180}, c_.fur);
    add(body, {0, -0.09, 0}, {0.222, 0.225, 0.200}, c_.fur);
    add(body, {0, -0.05, 0.058}, {0.165, 0.225, 0.162}, c_.cream);
    // The tail, a brush with a pale end, moves from side to side.
    const double wag = 0.25 * std::sin(clock * 3.1);
    Frame tail = body.inside({0, -0.18, -0.15}, turned(wag) * pitched(0.15 + stance.tail * 0.6));
    add(tail, {0, 0.01, -0.09}, {0.068, 0.068, 0.13}, c_.fur);
    tail = tail.inside({0, 0.01, -0.15}, turned(wag * 0.6) * pitched(0.45));
    add(tail, {0, 0.02, -0.12}, {0.118, 0.118, 0.180}, c_.fur);
    tail = tail.inside({0, 0.03, -0.23}, turned(wag * 0.6) * pitched(0.40));
    add(tail, {0, 0, -0.03}, {0.088, 0.088, 0.130}, c_.cream);
}

void Builder::eyes(const Frame& head, double open) {
    for (const double side : {1.0, -1.0}) {
        const dmat3 out = turned(side * 0.38);
        if (open < 0.3) {
            // Shut: bent upwards, as those of one who smiles.
            for (const double end : {1.0, -1.0})
                add(head, {side * 0.118 + end * 0.024, 0.035, 0.250 - side * end * 0.008}, {0.033, 0.012, 0.02}, c_.paw,
                    Solid::ball, out * rolled(end * 0.62));
            continue;
        }
        add(head, {side * 0.112, 0.035, 0.232}, {0.050, 0.078 * open, 0.040}, view::rgb(0x2A1A1C), Solid::ball, out);
        add(head, {side * 0.112 + 0.014, 0.066, 0.268}, {0.016, 0.019 * open, 0.010}, view::rgb(0xFFFFFF), Solid::ball,
            out, 0.8F);
    }
}

void Builder::ears(const Frame& head, double laid_back) {
    for (const double side : {1.0, -1.0}) {
        const Frame ear = head.inside({side * 0.165, 0.165, -0.01},
                                      pitched(-0.10 - 0.95 * laid_back) * rolled(side * (0.34 + 0.1 * laid_back)));
        add(ear, {0, 0, 0}, {0.105, 0.300, 0.062}, c_.fur, Solid::cone);
        add(ear, {0, 0.012, 0.022}, {0.066, 0.205, 0.047}, c_.cream, Solid::cone);
        add(ear, {0, 0.198, 0}, {0.038, 0.108, 0.026}, c_.paw, Solid::cone);
    }
}

void Builder::head(const Frame& head, const Stance& stance, double clock) {
    add(head, {0, 0, 0}, {0.292, 0.262, 0.262}, c_.fur);
    for (const double side : {1.0, -1.0}) {
        // Cheeks, with a tuft of fur outwards.
        add(head, {side * 0.150, -0.092, 0.110}, {0.138, 0.108, 0.128}, c_.cream);
        add(head, {side * 0.250, -0.105, 0.045}, {0.085, 0.052, 0.070}, c_.cream, Solid::ball, rolled(-side * 0.5));
    }
    add(head, {0, -0.078, 0.215}, {0.098, 0.078, 0.108}, c_.cream);
    add(head, {0, -0.040, 0.315}, {0.037, 0.028, 0.028}, view::rgb(0x2A1A1C));
    // Blinks now and then.
    const double beat = clock - std::floor(clock / 3.7) * 3.7;
    const bool blinks = beat < 0.13 || (beat > 0.32 && beat < 0.42 && std::fmod(clock, 11.1) < 3.7);
    eyes(head, blinks ? 0 : stance.eyes);
    ears(head, stance.ears + 0.04 * std::sin(clock * 2.6));
}

void Builder::scarf(const HeroPose& pose) {
    const auto& points = pose.scarf.now;
    for (std::size_t i = 0; i + 1 < scarf_points; ++i) {
        const dvec3 along = points[i + 1] - points[i];
        const double length = glm::length(along);
        if (length < 1e-6) continue;
        const dvec3 down = along / length;
        dvec3 wide = glm::cross(down, dvec3(0, 1, 0));
        const dvec3 fallback(std::cos(pose.facing), 0, -std::sin(pose.facing));
        // One that hangs straight down lies flat on the back.
        wide = wide + fallback * 0.35 * (glm::dot(wide, fallback) < 0 ? -1.0 : 1.0);
        wide = glm::normalize(wide - down * glm::dot(wide, down));
        const Frame link{dmat3(wide, down, glm::cross(wide, down)), (points[i] + points[i + 1]) * 0.5};
        const double share = double(i) / double(scarf_points - 2);
        add(link, {0, 0, 0}, {0.062 + 0.035 * share, length * 0.66, 0.024}, share > 0.75 ? c_.scarf_end : c_.scarf);
    }
}

void Builder::foot(const Frame& sole) {
    add(sole, {0, 0.075, 0.035}, {0.100, 0.076, 0.155}, c_.paw);
    add(sole, {0, 0.135, -0.03}, {0.078, 0.055, 0.078}, c_.cream);
}

void Builder::figure(const HeroPose& pose) {
    const Stance& s = pose.stance;
    const double tall = 1 + pose.squash;
    const double wide = 1 / std::sqrt(std::max(tall, 0.3));
    const Frame standing = standing_frame(pose);
    if (s.stretch.x < 0.05) return;  // it has popped
    const Frame upright = standing.inside(dvec3(0), scaled(dvec3(wide, tall, wide) * s.stretch));
    Frame root = upright.inside(dvec3(0), pitched(pose.lean_forward) * rolled(pose.lean_left));
    if (pose.flip > 0) {
        const dvec3 middle(0, 0.75, 0);
        root = root.inside(middle, pitched(-pose.flip));
        root.origin = root.at(-middle);
    }
    const Frame torso = root.inside(s.body, turned(s.twist) * pitched(s.pitch) * rolled(s.roll));
    body(torso, s, pose.clock);
    const Frame neck = torso.inside({0, 0.245, 0.01});
    add(neck, {0, 0.005, 0}, {0.192, 0.078, 0.180}, c_.scarf);
    add(neck, {0, -0.01, -0.165}, {0.062, 0.058, 0.05}, c_.scarf);
    // The head is held more upright than the body.
    const dmat3 level = pitched(-s.pitch * 0.45) * rolled(-s.roll * 0.6);
    const dmat3 looks =
        turned(s.head_yaw + pose.look_left) * pitched(s.head_pitch - pose.look_up) * rolled(s.head_roll);
    head(neck.inside(s.head, level).inside({0, 0.262, 0.015}, looks), s, pose.clock);
    const bool holds = pose.act == HeroAct::hang || pose.act == HeroAct::climb;
    for (const int side : {on_left, on_right}) {
        const Frame hand = (holds ? standing : root).inside(s.hands[side]);
        add(hand, {0, 0, 0}, {0.088, 0.088, 0.092}, c_.paw);
        const double out = side == on_left ? 1 : -1;
        add(hand, {-out * 0.055, 0.03, 0.045}, {0.036, 0.036, 0.042}, c_.paw);
        const dmat3 points_down = pitched(s.toes[side]);
        if (pose.flip > 0 || pose.act == HeroAct::dead) {
            foot(root.inside(s.feet[side], points_down));
        } else {
            foot({standing.axes * points_down, pose.feet[std::size_t(side)].at});
        }
    }
    scarf(pose);
}

void Builder::image(const AfterImage& image) {
    const double left_of_it = 1 - image.age / after_image_time;
    if (left_of_it <= 0) return;
    const Stance& s = image.stance;
    const Colour colour = view::with_opacity(c_.scarf_end, 0.42 * left_of_it * look_.opacity);
    const Frame torso = image.body.inside(s.body, pitched(s.pitch));
    const auto ghost = [&](const Frame& frame, const dvec3& at, const dvec3& radii) {
        Piece p = piece(frame, at, radii, colour);
        p.glow = 0.6F;
        pieces_.push_back(p);
    };
    ghost(torso, {0, 0, 0}, dvec3(0.20, 0.26, 0.18) * (0.6 + 0.4 * left_of_it));
    ghost(torso, {0, 0.5, 0.03}, dvec3(0.28, 0.26, 0.26) * (0.6 + 0.4 * left_of_it));
}

}  // namespace

void add_pieces(std::vector<Piece>& pieces, const HeroPose& pose, const HeroLook& look) {
    Builder builder(pieces, look);
    for (const AfterImage& image : pose.images) builder.image(image);
    // One that cannot be hurt for a while comes and goes, ten times a second; gently with reduced motion.
    const bool blinks_off = pose.untouchable && std::fmod(pose.clock, 0.16) < 0.07;
    if (blinks_off && !pose.reduced_motion) return;
    if (pose.untouchable && pose.reduced_motion) {
        HeroLook pale = look;
        pale.opacity *= 0.65;
        Builder(pieces, pale).figure(pose);
        return;
    }
    builder.figure(pose);
}

void draw(view::Renderer& renderer, const HeroPose& before, const HeroPose& after, double blend, const HeroLook& look) {
    std::vector<Piece> pieces;
    pieces.reserve(80);
    add_pieces(pieces, between(before, after, blend), look);
    for (const Piece& p : pieces) renderer.piece(p);
}

void draw_volume(view::Renderer& renderer, const CharacterSettings& settings, const CharacterState& state) {
    const Volume* volume = &settings.volume;
    if (state.form == CharacterForm::crouched && settings.crouched) volume = &*settings.crouched;
    if (state.form == CharacterForm::in_air && settings.in_air) volume = &*settings.in_air;
    if (state.form == CharacterForm::on_ramp && settings.on_ramp) volume = &*settings.on_ramp;
    if (state.form == CharacterForm::on_ledge && settings.on_ledge) volume = &*settings.on_ledge;
    renderer.shape(*volume, state.position, {.colour = view::paint::result, .opacity = 0.25, .casts_shadow = false});
}

}  // namespace surefoot::platformer
