// Several sweeps at a time: while the memory that one of them asked for is on its way, the others go on.
#include <array>
#include <cassert>

#include "ieee_guard.hpp"
#include "mesh/asker.hpp"
#include "mesh/data.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

// The sweeps that are searched together. Theirs are the arrays of a few kilobytes each that should stay in the nearest
// cache.
class Together {
public:
    Together(const MeshView& view, const Volume& volume, const QueryOptions& options) noexcept
        : view_(view), volume_(volume), options_(options) {}

    [[nodiscard]] bool is_full() const noexcept { return count_ == most_regions; }

    void add(const Motion& motion, const Box3& extent, std::optional<Hit>& answer) noexcept {
        Sweep& sweep = sweeps_[count_];
        sweep.query.emplace(FirstSweep{view_, volume_, motion, options_});
        sweep.asker.emplace(view_, options_, *sweep.query);
        sweep.answer = &answer;
        searches_[count_] = make_search(view_, volume_, motion, extent);
        sweep.asker->listen_to(searches_[count_]);
        ++count_;
    }

    void answer() noexcept {
        search_regions({searches_.data(), count_});
        for (std::size_t i = 0; i < count_; ++i) {
            Sweep& sweep = sweeps_[i];
            *sweep.answer = sweep.asker->has_done(searches_[i]) ? with_surface(view_, sweep.query->first)
                                                                : std::optional(blocked(HitStatus::overflow));
        }
        count_ = 0;
    }

private:
    struct Sweep {
        std::optional<FirstSweep> query;
        std::optional<Asker<FirstSweep>> asker;
        std::optional<Hit>* answer = nullptr;
    };

    const MeshView& view_;
    const Volume& volume_;
    const QueryOptions& options_;
    std::array<Sweep, most_regions> sweeps_;
    std::array<MeshSearch, most_regions> searches_;
    std::size_t count_ = 0;
};

}  // namespace

void Mesh::sweep_many(const Volume& volume, std::span<const Motion> motions, std::span<std::optional<Hit>> hits,
                      const QueryOptions& options) const noexcept {
    assert(hits.size() >= motions.size() && "sweep_many: room for one answer a motion");
    const std::size_t count = std::min(motions.size(), hits.size());
    const IeeeGuard guard;
    Together together(data_->view, volume, options);
    for (std::size_t i = 0; i < count; ++i) {
        const Motion& motion = motions[i];
        if (options.search != Search::tree || !is_valid_query(volume, motion)) {
            hits[i] = sweep(volume, motion, options);
            continue;
        }
        const Box3 extent = extent_of(volume, magnitude_in(data_->view, motion));
        if (!is_short(motion, extent)) {
            hits[i] = sweep(volume, motion, options);
            continue;
        }
        together.add(motion, extent, hits[i]);
        if (together.is_full()) together.answer();
    }
    together.answer();
}

}  // namespace v0
}  // namespace surefoot
