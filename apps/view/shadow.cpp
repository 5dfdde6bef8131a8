#include "view/shadow.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace surefoot::view {

ShadowMap::ShadowMap(int size) : size_(size), depth_(gl::shadow_texture(size)) {
    framebuffer_ = gl::framebuffer_of(nullptr, &depth_);
}

void ShadowMap::begin(const dvec3& middle, double radius, double reach, const dvec3& towards_sun) {
    middle_ = middle;
    radius_ = radius;
    const dvec3 sun = glm::normalize(towards_sun);
    const dvec3 side = across(sun).first;
    const dmat4 turn = glm::lookAt(dvec3(0), -sun, side);
    clip_from_middle_ = glm::ortho(-radius, radius, -radius, radius, -reach, radius * 1.05) * turn;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, size_, size_);
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_BLEND);
    glClear(GL_DEPTH_BUFFER_BIT);
}

gl::mat4 ShadowMap::clip_from(const dvec3& origin) const {
    return gl::mat4(glm::translate(clip_from_middle_, origin - middle_));
}

gl::mat4 ShadowMap::map_from(const dvec3& eye) const {
    const dmat4 halved = glm::scale(glm::translate(dmat4(1), dvec3(0.5)), dvec3(0.5));
    return gl::mat4(glm::translate(halved * clip_from_middle_, eye - middle_));
}

}  // namespace surefoot::view
