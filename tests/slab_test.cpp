// Slab<T>: raw memory, placement new, handles that know when their object is gone.
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <surefoot/slab.hpp>

#include "slab_things.hpp"

namespace {

using namespace slab_things;

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
    EXPECT_TRUE((
        std::is_same_v<std::iterator_traits<Slab<int>::Iterator<true>>::iterator_category, std::forward_iterator_tag>));
    EXPECT_TRUE((std::sentinel_for<surefoot::SlabEnd, Slab<int>::Iterator<true>>));
}

}  // namespace
