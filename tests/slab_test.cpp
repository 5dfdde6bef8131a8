// Slab<T>: raw memory, placement new, handles that know when their object is gone.
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <surefoot/slab.hpp>

#if defined(__SANITIZE_ADDRESS__)
#define SLAB_TEST_UNDER_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SLAB_TEST_UNDER_ASAN 1
#endif
#endif

#ifdef SLAB_TEST_UNDER_ASAN
#include <sanitizer/asan_interface.h>
#endif

namespace {

using surefoot::Slab;

// Counts every birth and death, and knows its own address, so that a move behind our back is seen.
class Counted {
public:
    static inline int born = 0;
    static inline int died = 0;
    static inline int moved = 0;
    static inline std::vector<int> order_of_death;

    static void reset() {
        born = died = moved = 0;
        order_of_death.clear();
    }

    explicit Counted(int value = 0) : value_(value), self_(this) { ++born; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() {
        ++died;
        if (self_ != this) ++moved;
        order_of_death.push_back(value_);
    }
    [[nodiscard]] int value() const { return value_; }

private:
    int value_;
    const Counted* self_;
};

struct Pair {
    int first;
    double second;
};

// A destructor that takes its children with it.
struct Family {
    Slab<Family>* slab = nullptr;
    Slab<Family>::Handle child{};
    ~Family() {
        if (slab != nullptr && slab->contains(child)) slab->erase(child);
    }
};

// A constructor that makes its own child.
struct Parent {
    Slab<Parent>::Handle child{};
    Parent() = default;
    explicit Parent(Slab<Parent>& slab) : child(slab.insert()) {}
};

struct Thrower {
    explicit Thrower(bool throws) {
        if (throws) throw 1;
    }
};

struct alignas(256) Wide {
    char first = 1;
};

TEST(Slab, a_new_slab_is_empty_and_has_the_room_that_was_asked_for) {
    const Slab<int> none;
    EXPECT_EQ(none.capacity(), 0u);
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.begin(), none.end());

    const Slab<int> hundred(100);
    EXPECT_EQ(hundred.capacity(), 128u);
    EXPECT_TRUE(hundred.empty());
    EXPECT_EQ(hundred.begin(), hundred.end());
}

TEST(Slab, a_handle_finds_the_object_it_was_given_for) {
    Slab<std::string> slab(4);
    const auto hero = slab.insert("hero");
    const auto crate = slab.insert(3u, 'c');
    ASSERT_TRUE(hero && crate);
    EXPECT_EQ(*slab.get(hero), "hero");
    EXPECT_EQ(slab[crate], "ccc");
    slab[crate] = "crate";
    EXPECT_EQ(*std::as_const(slab).get(crate), "crate");
    EXPECT_EQ(std::as_const(slab)[crate], "crate");
    EXPECT_EQ(slab.size(), 2u);
}

TEST(Slab, aggregates_are_made_without_a_constructor) {
    Slab<Pair> slab(1);
    const auto handle = slab.insert(3, 4.5);
    EXPECT_EQ(slab[handle].first, 3);
    EXPECT_EQ(slab[handle].second, 4.5);
}

TEST(Slab, the_default_handle_names_nothing) {
    Slab<int> slab(4);
    (void)slab.insert(7);
    const Slab<int>::Handle nothing;
    EXPECT_FALSE(nothing);
    EXPECT_FALSE(slab.contains(nothing));
    EXPECT_EQ(slab.get(nothing), nullptr);
}

TEST(Slab, a_forged_handle_to_an_empty_slot_names_nothing) {
    Slab<int> slab(4);
    const auto handle = slab.insert(7);
    slab.erase(handle);
    for (std::uint32_t index : {0u, 1u, 3u, 4u, 1000u, ~0u}) {
        for (std::uint32_t generation : {0u, 1u, 2u, 3u, ~0u}) {
            EXPECT_EQ(slab.get({index, generation}), nullptr) << index << ", " << generation;
        }
    }
}

TEST(Slab, constructions_and_destructions_are_exactly_one_each) {
    Counted::reset();
    {
        Slab<Counted> slab(8);
        EXPECT_EQ(Counted::born, 0) << "room is not objects";
        std::vector<Slab<Counted>::Handle> handles;
        for (int i = 0; i < 8; ++i) handles.push_back(slab.insert(i));
        EXPECT_EQ(Counted::born, 8);
        EXPECT_EQ(Counted::died, 0);
        slab.erase(handles[2]);
        slab.erase(handles[5]);
        EXPECT_EQ(Counted::died, 2);
        EXPECT_EQ(slab.size(), 6u);
        (void)slab.insert(8);
        EXPECT_EQ(Counted::born, 9);
    }
    EXPECT_EQ(Counted::born, 9);
    EXPECT_EQ(Counted::died, 9);
    EXPECT_EQ(Counted::moved, 0);
    EXPECT_EQ(Counted::order_of_death, (std::vector<int>{2, 5, 0, 1, 3, 4, 8, 6, 7}));
}

TEST(Slab, clear_destroys_everything_and_keeps_the_memory) {
    Counted::reset();
    Slab<Counted> slab(4);
    const auto first = slab.insert(1);
    const auto second = slab.insert(2);
    slab.clear();
    EXPECT_EQ(Counted::died, 2);
    EXPECT_TRUE(slab.empty());
    EXPECT_EQ(slab.capacity(), 4u);
    EXPECT_EQ(slab.get(first), nullptr);
    EXPECT_EQ(slab.get(second), nullptr);
    EXPECT_TRUE(slab.insert(3));
}

TEST(Slab, a_stale_handle_stays_null_after_its_slot_has_a_new_tenant) {
    Slab<int> slab(1);
    std::vector<Slab<int>::Handle> stale;
    for (int tenant = 0; tenant < 1000; ++tenant) {
        const auto handle = slab.insert(tenant);
        ASSERT_EQ(*slab.get(handle), tenant);
        ASSERT_TRUE(std::all_of(stale.begin(), stale.end(), [&](auto old) { return slab.get(old) == nullptr; }));
        slab.erase(handle);
        ASSERT_EQ(slab.get(handle), nullptr);
        stale.push_back(handle);
    }
}

TEST(Slab, a_slot_whose_generations_have_run_out_is_retired) {
    Slab<int, std::uint8_t> slab(2);
    const auto other = slab.insert(-1);
    std::vector<Slab<int, std::uint8_t>::Handle> stale;
    for (int tenant = 0; tenant < 128; ++tenant) {
        const auto handle = slab.insert(tenant);
        ASSERT_EQ(handle.index, 1u);
        slab.erase(handle);
        stale.push_back(handle);
    }
    EXPECT_FALSE(slab.insert(128)) << "a 129th tenant would have the first tenant's handle";
    for (const auto old : stale) EXPECT_EQ(slab.get(old), nullptr);
    EXPECT_EQ(slab[other], -1);
    EXPECT_EQ(slab.size(), 1u);
    ASSERT_TRUE(slab.reserve(3));
    EXPECT_EQ(slab.insert(129).index, 2u);
}

TEST(Slab, a_full_slab_says_so_instead_of_growing_by_itself) {
    Slab<int> slab(2);
    EXPECT_TRUE(slab.insert(1));
    EXPECT_TRUE(slab.insert(2));
    EXPECT_FALSE(slab.insert(3));
    EXPECT_EQ(slab.size(), 2u);
    EXPECT_FALSE(Slab<int>().insert(1));
}

TEST(Slab, growth_moves_no_object_and_keeps_every_handle) {
    Counted::reset();
    Slab<Counted> slab(1);
    std::vector<std::pair<Slab<Counted>::Handle, const Counted*>> all;
    for (int i = 0; i < 5000; ++i) {
        if (slab.size() == slab.capacity()) {
            ASSERT_TRUE(slab.reserve(slab.capacity() + 1));
        }
        const auto handle = slab.insert(i);
        ASSERT_EQ(handle.index, static_cast<std::uint32_t>(i));
        all.emplace_back(handle, slab.get(handle));
    }
    EXPECT_EQ(slab.capacity(), 8192u);
    for (int i = 0; i < 5000; ++i) {
        const auto [handle, address] = all[static_cast<std::size_t>(i)];
        ASSERT_EQ(slab.get(handle), address);
        ASSERT_EQ(address->value(), i);
    }
    slab.clear();
    EXPECT_EQ(Counted::moved, 0);
}

TEST(Slab, no_two_objects_share_a_byte) {
    for (std::uint32_t first : {1u, 2u, 7u, 64u}) {
        Slab<Pair> slab(first);
        ASSERT_TRUE(slab.reserve(300));
        std::vector<std::uintptr_t> addresses;
        while (const auto handle = slab.insert(0, 0.0)) {
            addresses.push_back(reinterpret_cast<std::uintptr_t>(slab.get(handle)));
        }
        EXPECT_EQ(addresses.size(), slab.capacity());
        std::sort(addresses.begin(), addresses.end());
        for (std::size_t i = 1; i < addresses.size(); ++i) ASSERT_GE(addresses[i] - addresses[i - 1], sizeof(Pair));
    }
}

TEST(Slab, room_that_cannot_be_had_is_refused_and_what_was_there_stays) {
    struct Huge {
        char bytes[std::size_t{1} << 40];
    };
    if constexpr (sizeof(std::size_t) == 8) {
        Slab<Huge> huge;
        EXPECT_FALSE(huge.reserve(std::uint32_t{1} << 31));  // 2^71 bytes: the multiplication would overflow
        EXPECT_EQ(huge.capacity(), 0u);
    }
    Slab<int> slab(1);
    const auto handle = slab.insert(5);
    EXPECT_FALSE(slab.reserve(Slab<int>::max_capacity + 1));
    EXPECT_EQ(slab.capacity(), 1u);
    EXPECT_EQ(slab[handle], 5);
}

TEST(Slab, over_aligned_types_are_aligned_in_every_chunk) {
    Slab<Wide> slab(1);
    ASSERT_TRUE(slab.reserve(64));
    while (const auto handle = slab.insert()) {
        ASSERT_EQ(reinterpret_cast<std::uintptr_t>(slab.get(handle)) % 256, 0u);
        ASSERT_EQ(slab[handle].first, 1);
    }
    EXPECT_EQ(slab.size(), 64u);
}

TEST(Slab, small_types_stand_side_by_side) {
    Slab<char> slab(64);
    for (char letter = 'a'; letter <= 'z'; ++letter) ASSERT_TRUE(slab.insert(letter));
    const char* const first = &*slab.begin();
    EXPECT_EQ(std::string(first, 26), "abcdefghijklmnopqrstuvwxyz");
}

TEST(Slab, iteration_visits_the_living_in_slot_order) {
    Slab<int> slab(8);
    std::vector<Slab<int>::Handle> handles;
    for (int i = 0; i < 8; ++i) handles.push_back(slab.insert(i));
    slab.erase(handles[0]);
    slab.erase(handles[3]);
    slab.erase(handles[7]);

    std::vector<int> seen;
    for (int value : slab) seen.push_back(value);
    EXPECT_EQ(seen, (std::vector<int>{1, 2, 4, 5, 6}));

    (void)slab.insert(70);  // the slot freed last is taken first
    (void)slab.insert(30);
    seen.clear();
    for (auto place = std::as_const(slab).begin(); place != slab.end(); ++place) {
        EXPECT_EQ(slab.get(place.handle()), &*place);
        seen.push_back(*place);
    }
    EXPECT_EQ(seen, (std::vector<int>{1, 2, 30, 4, 5, 6, 70}));
}

TEST(Slab, erasing_while_iterating_is_fine) {
    Slab<int> slab(16);
    for (int i = 0; i < 16; ++i) (void)slab.insert(i);
    for (auto place = slab.begin(); place != slab.end(); ++place) {
        if (*place % 3 != 0) slab.erase(place.handle());
    }
    std::vector<int> left(slab.begin(), Slab<int>::Iterator<false>(&slab, slab.capacity()));
    EXPECT_EQ(left, (std::vector<int>{0, 3, 6, 9, 12, 15}));
}

TEST(Slab, its_iterators_are_forward_iterators) {
    EXPECT_TRUE(std::forward_iterator<Slab<int>::Iterator<false>>);
    EXPECT_TRUE(std::forward_iterator<Slab<int>::Iterator<true>>);
    EXPECT_TRUE((std::sentinel_for<std::default_sentinel_t, Slab<int>::Iterator<true>>));
}

TEST(Slab, a_destructor_may_erase_its_children) {
    Slab<Family> slab(3);
    const auto grandchild = slab.insert(&slab);
    const auto child = slab.insert(&slab, grandchild);
    const auto parent = slab.insert(&slab, child);
    slab.erase(parent);
    EXPECT_TRUE(slab.empty());
    EXPECT_FALSE(slab.contains(child) || slab.contains(grandchild));

    const auto kept = slab.insert(&slab);
    (void)slab.insert(&slab, kept);
    // The slab's own destructor meets the same chain now, child first.
}

TEST(Slab, a_constructor_may_insert_its_children) {
    Slab<Parent> slab(2);
    const auto parent = slab.insert(slab);
    ASSERT_EQ(slab.size(), 2u);
    EXPECT_TRUE(slab.contains(slab[parent].child));
    EXPECT_NE(slab.get(parent), slab.get(slab[parent].child));
}

TEST(Slab, a_constructor_that_throws_leaves_the_slot_free) {
    Slab<Thrower> slab(1);
    EXPECT_THROW((void)slab.insert(true), int);
    EXPECT_TRUE(slab.empty());
    EXPECT_EQ(slab.begin(), slab.end());
    EXPECT_TRUE(slab.insert(false));
}

TEST(Slab, moving_a_slab_moves_no_object) {
    Counted::reset();
    Slab<Counted> slab(2);
    const auto handle = slab.insert(5);
    const Counted* const address = slab.get(handle);

    Slab<Counted> other(std::move(slab));
    EXPECT_EQ(other.get(handle), address);
    EXPECT_EQ(slab.capacity(), 0u);
    EXPECT_EQ(slab.get(handle), nullptr);

    Slab<Counted> target(1);
    (void)target.insert(6);
    target = std::move(other);
    EXPECT_EQ(target.get(handle), address);
    EXPECT_EQ(Counted::order_of_death, (std::vector<int>{6}));

    auto& same = target;
    target = std::move(same);
    EXPECT_EQ(target.get(handle), address) << "moved onto itself";
    EXPECT_FALSE(std::is_copy_constructible_v<Slab<int>> || std::is_copy_assignable_v<Slab<int>>);
}

TEST(Slab, agrees_with_a_map_over_a_long_random_life) {
    Counted::reset();
    std::mt19937_64 random(20240517);
    std::map<std::uint32_t, std::pair<Slab<Counted>::Handle, int>> model;  // by slot
    std::vector<Slab<Counted>::Handle> dead;
    {
        Slab<Counted> slab(3);
        int refused = 0;
        for (int step = 0; step < 20000; ++step) {
            const auto dice = random() % 100;
            if (dice < 52) {
                const auto handle = slab.insert(step);
                if (model.size() == slab.capacity()) {
                    ASSERT_FALSE(handle);
                    if (++refused % 50 == 0) {
                        ASSERT_TRUE(slab.reserve(slab.capacity() + 1));
                    }
                } else {
                    ASSERT_TRUE(handle);
                    ASSERT_TRUE(model.emplace(handle.index, std::pair(handle, step)).second) << "two in one slot";
                }
            } else if (dice < 99 && !model.empty()) {
                const auto victim = std::next(model.begin(), static_cast<std::ptrdiff_t>(random() % model.size()));
                ASSERT_TRUE(slab.erase(victim->second.first));
                dead.push_back(victim->second.first);
                model.erase(victim);
            } else if (dice == 99 && random() % 20 == 0) {
                slab.clear();
                for (const auto& [slot, tenant] : model) dead.push_back(tenant.first);
                model.clear();
            }
            ASSERT_EQ(slab.size(), model.size());
            ASSERT_EQ(Counted::born - Counted::died, static_cast<int>(model.size()));
            if (!dead.empty()) {
                ASSERT_EQ(slab.get(dead[random() % dead.size()]), nullptr);
            }
            if (step % 100 == 0) {
                auto expected = model.begin();
                for (auto place = slab.begin(); place != slab.end(); ++place, ++expected) {
                    ASSERT_NE(expected, model.end());
                    ASSERT_EQ(place.handle(), expected->second.first);
                    ASSERT_EQ(place->value(), expected->second.second);
                }
                ASSERT_EQ(expected, model.end());
            }
        }
        EXPECT_GE(slab.capacity(), 16u) << "the run should have grown the slab a few times";
        EXPECT_GE(dead.size(), 5000u);
    }
    EXPECT_EQ(Counted::born, Counted::died);
    EXPECT_EQ(Counted::moved, 0);
}

TEST(Slab, the_same_calls_give_the_same_handles) {
    const auto life = [] {
        std::mt19937_64 random(7);
        Slab<int> slab(64);
        std::vector<Slab<int>::Handle> handles;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> log;
        for (int step = 0; step < 500; ++step) {
            if (random() % 2 == 0 || handles.empty()) {
                const auto handle = slab.insert(step);
                log.emplace_back(handle.index, handle.generation);
                if (handle) handles.push_back(handle);
            } else {
                const auto at = static_cast<std::ptrdiff_t>(random() % handles.size());
                slab.erase(handles[static_cast<std::size_t>(at)]);
                handles.erase(handles.begin() + at);
            }
        }
        return log;
    };
    EXPECT_EQ(life(), life());
}

#ifdef SLAB_TEST_UNDER_ASAN
TEST(Slab, address_sanitizer_sees_the_empty_slots) {
    Slab<Pair> slab(4);
    const auto first = slab.insert(1, 1.0);
    const auto second = slab.insert(2, 2.0);
    const Pair* const address = slab.get(first);
    EXPECT_FALSE(__asan_address_is_poisoned(address));
    EXPECT_TRUE(__asan_address_is_poisoned(slab.get(second) + 1)) << "a slot that was never used";
    slab.erase(first);
    EXPECT_TRUE(__asan_address_is_poisoned(address));
    EXPECT_FALSE(__asan_address_is_poisoned(slab.get(second)));
    ASSERT_EQ(slab.insert(3, 3.0).index, first.index);
    EXPECT_FALSE(__asan_address_is_poisoned(address));
}

TEST(SlabDeathTest, address_sanitizer_stops_a_read_through_a_dead_pointer) {
    Slab<Pair> slab(1);
    const auto handle = slab.insert(1, 1.0);
    const volatile int* const kept = &slab.get(handle)->first;
    slab.erase(handle);
    EXPECT_DEATH((void)*kept, "use-after-poison");
}
#endif

TEST(SlabDeathTest, using_a_dead_handle_asserts_in_words) {
    Slab<int> slab(1);
    const auto handle = slab.insert(1);
    slab.erase(handle);
#ifdef NDEBUG
    EXPECT_FALSE(slab.erase(handle)) << "without asserts it does nothing";
    EXPECT_TRUE(slab.empty());
#else
    EXPECT_DEATH(slab.erase(handle), "this handle is dead or was never alive; ask contains");
    EXPECT_DEATH((void)slab[handle], "this handle is dead or was never alive; ask get");
    EXPECT_DEATH((void)slab[{}], "this handle is dead or was never alive; ask get");
#endif
}

}  // namespace
