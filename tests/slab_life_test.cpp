// Slab<T> over long and difficult lives: objects that call back, that throw, that are moved with their slab; a random
// life beside a std::map; misuse.
#include <cstdint>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include <surefoot/slab.hpp>

#include "slab_things.hpp"

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

using namespace slab_things;

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
