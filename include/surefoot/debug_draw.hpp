/// Where the library's parts draw what they think: lines, triangles and words at places of the world, into a sink of
/// yours. The core draws nothing and links no window.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A colour as screens take it (sRGB), not multiplied by its opacity.
struct DebugColour {
    std::uint8_t r = 255;
    std::uint8_t g = 255;
    std::uint8_t b = 255;
    std::uint8_t a = 255;  ///< 0 is not to be seen at all, 255 hides what is behind
};

static_assert(std::is_trivially_copyable_v<DebugColour> && sizeof(DebugColour) == 4);

/// What can be drawn into. The text is good during the call only.
template <typename T>
concept DebugDrawSink = requires(T& sink, const dvec3& place, const DebugColour& colour, std::string_view text) {
    sink.line(place, place, colour);
    sink.triangle(place, place, place, colour);
    sink.text(place, text, colour);
};

/// A view of any sink, the size of two pointers; one that was made of nothing swallows everything. Non-owning: the sink
/// must outlive it. Allocates nothing itself; whether a sink does is the sink's own affair. Places are metres of the
/// world. A sink may not throw when the core draws into it.
class DebugDraw {
public:
    constexpr DebugDraw() noexcept = default;

    template <DebugDrawSink Sink>
    requires(!std::is_same_v<Sink, DebugDraw>) constexpr DebugDraw(Sink& sink) noexcept
        : sink_(&sink), calls_(&calls_of<Sink>) {}

    void line(const dvec3& from, const dvec3& to, const DebugColour& colour) const {
        if (calls_ != nullptr) calls_->line(sink_, from, to, colour);
    }

    /// Seen from both sides.
    void triangle(const dvec3& a, const dvec3& b, const dvec3& c, const DebugColour& colour) const {
        if (calls_ != nullptr) calls_->triangle(sink_, a, b, c, colour);
    }

    /// A short text in UTF-8, beside `place`.
    void text(const dvec3& place, std::string_view words, const DebugColour& colour) const {
        if (calls_ != nullptr) calls_->text(sink_, place, words, colour);
    }

    /// Is there anybody to draw for? Ask before you compute what only a drawing needs.
    [[nodiscard]] explicit constexpr operator bool() const noexcept { return calls_ != nullptr; }

private:
    struct Calls {
        void (*line)(void*, const dvec3&, const dvec3&, const DebugColour&);
        void (*triangle)(void*, const dvec3&, const dvec3&, const dvec3&, const DebugColour&);
        void (*text)(void*, const dvec3&, std::string_view, const DebugColour&);
    };

    template <typename Sink>
    static constexpr Calls calls_of{
        [](void* sink, const dvec3& from, const dvec3& to, const DebugColour& colour) {
            static_cast<Sink*>(sink)->line(from, to, colour);
        },
        [](void* sink, const dvec3& a, const dvec3& b, const dvec3& c, const DebugColour& colour) {
            static_cast<Sink*>(sink)->triangle(a, b, c, colour);
        },
        [](void* sink, const dvec3& place, std::string_view words, const DebugColour& colour) {
            static_cast<Sink*>(sink)->text(place, words, colour);
        }};

    void* sink_ = nullptr;
    const Calls* calls_ = nullptr;
};

}  // namespace v0
}  // namespace surefoot
