// Drawing a frame that was collected.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "view/renderer_parts.hpp"

namespace surefoot::view {
namespace {

// How much nearer to the eye a triangle of debug drawing counts as than it is.
constexpr float triangle_lift = 0.0008F;

struct Ball {
    dvec3 middle{0, 0, 0};
    double radius = 0;
};

dvec3 snapped(const dvec3& place, double grid) {
    return glm::floor(place / grid + 0.5) * grid;
}

}  // namespace

void Canvas::fit(const ivec2& wanted) {
    if (wanted == size) return;
    size = wanted;
    colour = gl::colour_texture(size);
    smooth_colour = gl::colour_texture(size);
    depth = gl::depth_texture(size);
    scene = gl::framebuffer_of(&colour, &depth);
    smooth = gl::framebuffer_of(&smooth_colour, &depth);
}

void Renderer::end(unsigned framebuffer) {
    if (view_.framebuffer.x <= 0 || view_.framebuffer.y <= 0) return;  // a window that was made small to nothing
    Parts& p = *parts_;
    const Camera& camera = view_.camera;
    p.clip_from_eye = gl::mat4(camera.projection(double(view_.framebuffer.x) / view_.framebuffer.y) * camera.turn());
    p.light = {.to_sun = vec3(glm::normalize(sky.towards_sun)), .up = vec3(camera.up), .sky = &sky, .fog = effects.fog};
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBlendEquation(GL_FUNC_ADD);
    p.canvas.fit(view_.framebuffer);  // before shadow maps are bound: making textures binds them in their place
    if (effects.shadows) draw_shadows();
    draw_scene();
    finish(framebuffer);
    counts_.lines = p.lines.size();
    counts_.shapes = p.placed.size();
    counts_.pieces = p.pieces.pieces().size();
}

void Renderer::draw_shadows() {
    Parts& p = *parts_;
    const Camera& camera = view_.camera;
    const double largest_region = sky.shadow_radius;
    if (!p.still || p.still->size() != effects.shadow_size) {
        p.still.emplace(effects.shadow_size);
        p.moving.emplace(1024);
        p.still_is = {};
    }
    dvec3 low(1e300);
    dvec3 high(-1e300);
    StillShadow wanted;
    wanted.towards_sun = sky.towards_sun;
    const PlacedModel* caster = nullptr;
    int casters = 0;
    for (const PlacedModel& m : p.models) {
        if (!m.look.casts_shadow) continue;
        caster = &m;
        ++casters;
        const double radius = glm::length(m.model->bounds().max - m.model->bounds().min) * 0.5;
        low = glm::min(low, m.origin() - radius);
        high = glm::max(high, m.origin() + radius);
        if (m.look.moves) continue;
        wanted.models.push_back(m.model->serial());
        wanted.poses.push_back(m.pose);
    }
    if (casters == 0) low = high = camera.eye;
    const Ball scene{(low + high) * 0.5, std::max(glm::length(high - low) * 0.5, 1e-6)};
    // Around a model's origin a ball of half its diagonal is enough; several models have the box around their balls.
    Ball region = scene;
    if (casters == 1)
        region.radius = glm::length(caster->model->bounds().max - caster->model->bounds().min) * 0.5 + 1e-6;
    if (region.radius > largest_region) {
        region.radius = largest_region;
        region.middle = snapped(camera.eye + camera.forward * (largest_region * 0.6), largest_region * 0.3);
    }
    wanted.middle = region.middle;
    wanted.radius = region.radius;
    const double reach = scene.radius + glm::length(scene.middle - region.middle);
    const bool same = wanted.models == p.still_is.models && wanted.middle == p.still_is.middle &&
                      wanted.radius == p.still_is.radius && wanted.towards_sun == p.still_is.towards_sun &&
                      std::equal(wanted.poses.begin(), wanted.poses.end(), p.still_is.poses.begin(),
                                 p.still_is.poses.end(), [](const Pose& a, const Pose& b) {
                                     return a.position == b.position && a.orientation == b.orientation;
                                 });
    p.depth.use();
    const auto draw_model = [&](const PlacedModel& m, const ShadowMap& map) {
        const gl::mat4 clip_from_model = map.clip_from(region.middle) * m.from_model(region.middle);
        p.depth.set("clip_from_model", clip_from_model);
        static_cast<void>(m.model->draw(Frustum(clip_from_model), m.in_model(region.middle), false));
    };
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, 2.0F);
    if (!same) {
        p.still->begin(region.middle, region.radius, reach, sky.towards_sun);
        for (const PlacedModel& m : p.models)
            if (!m.look.moves && m.look.casts_shadow) draw_model(m, *p.still);
        p.still_is = std::move(wanted);
        counts_.shadow_drawn = true;
    }
    dvec3 moving_low(1e300);
    dvec3 moving_high(-1e300);
    const auto include = [&](const dvec3& middle, double reach_around) {
        moving_low = glm::min(moving_low, middle - reach_around);
        moving_high = glm::max(moving_high, middle + reach_around);
    };
    for (const PlacedShape& s : p.placed)
        if (s.look.casts_shadow) include(s.middle, s.reach);
    for (const Piece& piece : p.pieces.pieces())
        if (piece.casts_shadow) include(piece.place[3], reach_of(piece));
    for (const PlacedModel& m : p.models)
        if (m.look.moves && m.look.casts_shadow)
            include(m.origin(), glm::length(m.model->bounds().max - m.model->bounds().min) * 0.5);
    if (moving_low.x <= moving_high.x) {
        const dvec3 middle = (moving_low + moving_high) * 0.5;
        const double radius = std::min(glm::length(moving_high - moving_low) * 0.5, largest_region);
        // Shadows fall on what is behind the movers, however far that is.
        p.moving->begin(middle, radius, radius, sky.towards_sun);
        for (const PlacedModel& m : p.models)
            if (m.look.moves && m.look.casts_shadow) draw_model(m, *p.moving);
        for (const PlacedShape& s : p.placed) {
            if (!s.look.casts_shadow) continue;
            p.depth.set("clip_from_model", p.moving->clip_from(middle) * s.from_model(middle));
            s.model->draw();
        }
        p.pieces.draw_depth(p.moving->clip_from(middle), middle);
        p.light.moving_strength = 0.55F;
        p.light.moving_from_eye = p.moving->map_from(camera.eye);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    p.light.still_from_eye = p.still->map_from(camera.eye);
    p.light.shadow_size = {1.0F / static_cast<float>(p.still->size()), 1.0F / static_cast<float>(p.moving->size()),
                           static_cast<float>(p.still->texel()), static_cast<float>(p.moving->texel())};
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, p.moving->texture().id());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, p.still->texture().id());
}

void Renderer::draw_scene() {
    Parts& p = *parts_;
    glBindFramebuffer(GL_FRAMEBUFFER, p.canvas.scene.id());
    glViewport(0, 0, view_.framebuffer.x, view_.framebuffer.y);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClear(GL_DEPTH_BUFFER_BIT);  // the sky covers every pixel that nothing else does
    draw_models();
    draw_shapes(true);
    draw_pieces(false);
    draw_sky();
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    draw_triangles();
    draw_discs();
    draw_shapes(false);
    draw_pieces(true);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
}

void Renderer::set_door(const gl::Program& program) const {
    const dvec3 way = door_.middle - view_.camera.eye;
    const double square = std::max(glm::dot(way, way), 1e-6);
    const dvec3 across = glm::cross(way, view_.camera.above());
    const dvec3 right = glm::length(across) > 1e-9 ? glm::normalize(across) : view_.camera.right();
    const dvec3 above = glm::cross(right, way / std::sqrt(square));
    program.set("door_middle", vec3(way));
    program.set("door_ahead", vec3(way / square));
    program.set("door_right", vec3(right / door_.half.x));
    program.set("door_above", vec3(above / door_.half.y));
    program.set("door_strength", static_cast<float>(door_.strength));
    program.set("door_near", static_cast<float>(door_.nearest));
}

void Renderer::draw_models() {
    Parts& p = *parts_;
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, p.patterns.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    effects.soft_patterns ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, effects.soft_patterns ? GL_LINEAR : GL_NEAREST);
    glActiveTexture(GL_TEXTURE0);
    const bool has_door = door_.strength > 0 || door_.nearest > 0;
    for (const PlacedModel& m : p.models) {
        const EdgeLook& edges = m.look.edges;
        const bool with_edges = edges.width > 0;
        const gl::mat4 from_model = m.from_model(view_.camera.eye);
        const Frustum seen(p.clip_from_eye * from_model);
        const auto use = [&](const gl::Program& program) {
            program.use();
            p.light.set(program);
            program.set("clip_from_eye", p.clip_from_eye);
            program.set("eye_from_model", from_model);
            program.set("patterns", 2);
        };
        const std::size_t look = with_edges ? 2 : m.model->has_patterns() ? 3 : m.model->is_flat() ? 1 : 0;
        const gl::Program& program = p.mesh[effects.shadows ? 1 : 0][look];
        use(program);
        if (has_door && !with_edges && m.model->is_flat()) {
            const double widest = 1.5 * std::max(door_.half.x, door_.half.y);
            const SightLine line{.eye = m.in_model(view_.camera.eye),
                                 .goal = m.in_model(door_.middle),
                                 .radius = door_.strength > 0 ? static_cast<float>(widest) : 0,
                                 .nearest = static_cast<float>(door_.nearest)};
            counts_.triangles += m.model->draw_parted(seen, line, false);
            const gl::Program& door = p.door[effects.shadows ? 1 : 0][m.model->has_patterns() ? 1 : 0];
            use(door);
            set_door(door);
            door.set("door_gap", m.look.yields ? -0.5F : 0.3F);
            counts_.triangles += m.model->draw_parted(seen, line, true);
            continue;
        }
        if (with_edges) {
            program.set("edge_width", static_cast<float>(edges.width * view_.line_pixels()));
            constexpr const char* names[] = {"edge_colours[0]", "edge_colours[1]", "edge_colours[2]",
                                             "edge_colours[3]"};
            for (int i = 0; i < 4; ++i) program.set(names[i], to_vec4(edges.kinds[i]));
        }
        counts_.triangles += m.model->draw(seen, m.in_model(view_.camera.eye), with_edges);
    }
}

void Renderer::draw_shapes(bool solid) {
    Parts& p = *parts_;
    std::vector<const PlacedShape*> order;
    for (const PlacedShape& s : p.placed)
        if ((s.look.opacity >= 1) == solid) order.push_back(&s);
    if (order.empty()) return;
    // The farthest first, so that what is nearer covers it.
    std::stable_sort(order.begin(), order.end(), [&](const PlacedShape* a, const PlacedShape* b) {
        return glm::length(a->middle - view_.camera.eye) > glm::length(b->middle - view_.camera.eye);
    });
    const gl::Program& program = p.shape;
    program.use();
    p.light.set(program);
    program.set("clip_from_eye", p.clip_from_eye);
    glEnable(GL_CULL_FACE);
    for (const PlacedShape* s : order) {
        program.set("eye_from_model", s->from_model(view_.camera.eye));
        gl::vec4 colour = to_vec4(s->look.colour);
        colour.a = static_cast<float>(s->look.opacity);
        if (!solid) {
            program.set("colour", gl::vec4(colour.r, colour.g, colour.b, colour.a * 0.5F));
            glCullFace(GL_FRONT);
            s->model->draw();
        }
        program.set("colour", colour);
        glCullFace(GL_BACK);
        s->model->draw();
    }
    glDisable(GL_CULL_FACE);
    glBindVertexArray(0);
}

void Renderer::draw_pieces(bool see_through) {
    Parts& p = *parts_;
    counts_.triangles += p.pieces.draw(p.light, p.clip_from_eye, view_.camera.eye,
                                       view_.camera.unit_at(1, view_.framebuffer), see_through, effects.shadows);
}

void Renderer::draw_discs() {
    parts_->discs.draw(parts_->clip_from_eye, view_.camera.eye, view_.camera.right(), view_.camera.above());
}

void Renderer::draw_sky() {
    Parts& p = *parts_;
    const Camera& camera = view_.camera;
    const double half = std::tan(camera.field_of_view / 2);
    p.sky.use();
    const dvec3 right = camera.right() * (half * view_.framebuffer.x / view_.framebuffer.y);
    const dvec3 above = camera.above() * half;
    p.sky.set("view_forward", vec3(camera.forward - right * camera.lens_shift.x - above * camera.lens_shift.y));
    p.sky.set("view_right", vec3(right));
    p.sky.set("view_above", vec3(above));
    p.sky.set("up", p.light.up);
    p.sky.set("to_sun", p.light.to_sun);
    p.sky.set("zenith", sky.zenith);
    p.sky.set("horizon", sky.horizon);
    p.sky.set("nadir", sky.nadir);
    glBindVertexArray(p.nothing.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_triangles() {
    Parts& p = *parts_;
    if (p.triangles.empty()) return;
    gl::stream(p.flat_buffer, p.triangles.data(), p.triangles.size() * sizeof(p.triangles[0]));
    p.flat.use();
    p.flat.set("clip_from_eye", p.clip_from_eye);
    p.flat.set("lift", triangle_lift);
    glBindVertexArray(p.flat_array.id());
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(p.triangles.size()));
    glBindVertexArray(0);
}

void Renderer::finish(unsigned framebuffer) {
    Parts& p = *parts_;
    const ivec2 size = view_.framebuffer;
    if (effects.smooth_edges) {
        glBindFramebuffer(GL_FRAMEBUFFER, p.canvas.smooth.id());
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        glBindTexture(GL_TEXTURE_2D, p.canvas.colour.id());
        p.smooth.use();
        p.smooth.set("picture", 0);
        p.smooth.set("texel", gl::vec2(1.0F / static_cast<float>(size.x), 1.0F / static_cast<float>(size.y)));
        glBindVertexArray(p.nothing.id());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    // Lines are smooth by themselves, and smoothing them twice would blur them.
    p.lines.draw(p.clip_from_eye, size, view_.camera.nearest, view_.camera.unit_at(1, size));
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    const GLuint drawn = effects.smooth_edges ? p.canvas.smooth.id() : p.canvas.scene.id();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace surefoot::view
