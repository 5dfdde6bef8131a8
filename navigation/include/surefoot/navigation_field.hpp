/// One goal for many: a potential over the whole mesh that is computed once, and whoever descends it gets to the goal
/// without a search of its own.
///
/// Two potentials. `walked` is how far it is to the goal on foot: it costs a search over all portals, and has no
/// minimum but the goal. `straight` is how far it is through the air: it costs nothing, and every dead end that faces
/// the goal is a minimum in which hill climbing ends. Such minima are found (`minima`) and escaped
/// (`NavigationEscape`).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/navigation_line.hpp>
#include <surefoot/navigation_query.hpp>

namespace surefoot::navigation {
struct FieldState;
}

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

enum class NavigationPotential : std::uint8_t {
    walked,    ///< along the mesh and its links, by area costs
    straight,  ///< as the crow flies
};

/// How to get out of a local minimum.
enum class NavigationEscape : std::uint8_t {
    none,          ///< stays in it
    random,        ///< walks at random for a while, and longer each time
    wall,          ///< keeps a hand on the wall until it is nearer to the goal than the minimum was
    virtual_goal,  ///< goes first to the nearest polygon, by portals crossed, that is nearer to the goal
};

struct NavigationFieldOptions {
    NavigationPotential potential = NavigationPotential::walked;

    /// Of the places in portals between which ways are measured [m, > 0]. Small: straighter ways, and a field that
    /// takes longer to compute.
    double spacing = 1;
};

struct NavigationDescendOptions {
    NavigationEscape escape = NavigationEscape::virtual_goal;
    std::uint64_t seed = 1;            ///< of `NavigationEscape::random`
    double step = 0.25;                ///< of hill climbing [m, > 0]
    std::uint32_t most_escapes = 100;  ///< then it stays where it is
};

/// A local minimum of the potential.
struct NavigationMinimum {
    NavigationPoint place;
    double value = 0;
};

/// The way down from a place.
struct NavigationDescent {
    NavigationLine line;
    std::vector<NavigationMinimum> minima;  ///< in which it came to be, in this order
    bool arrived = false;
};

/// See the top of this file. Once made it is only read: any number of threads may ask it, each with a query of its own.
/// It is of the mesh as it was: make it anew when doors, areas, links or tiles change.
class NavigationField {
public:
    /// None if the goal is not on the mesh.
    [[nodiscard]] static std::optional<NavigationField> make(const NavigationQuery& query, const NavigationPoint& goal,
                                                             const NavigationFieldOptions& options = {});

    NavigationField(NavigationField&& other) noexcept;
    NavigationField& operator=(NavigationField&& other) noexcept;
    ~NavigationField();

    [[nodiscard]] NavigationPotential potential() const noexcept;
    [[nodiscard]] const NavigationPoint& goal() const noexcept;

    /// The potential of a place [m]; infinite if no way leads from there to the goal.
    [[nodiscard]] double at(const NavigationPoint& place) const;

    /// All polygons with a lowest place than which no polygon beside it has a lower; but for those of the goal.
    [[nodiscard]] std::vector<NavigationMinimum> minima(const NavigationQuery& query) const;

    /// The way down from a place to the goal, or to the minimum in which it ends. On `straight` it takes no links, but
    /// for those that lead to a virtual goal.
    [[nodiscard]] NavigationDescent descend(const NavigationQuery& query, const NavigationPoint& from,
                                            const NavigationDescendOptions& options = {}) const;

private:
    explicit NavigationField(std::unique_ptr<navigation::FieldState> state) noexcept;
    std::unique_ptr<navigation::FieldState> state_;
};

}  // namespace v0
}  // namespace surefoot
