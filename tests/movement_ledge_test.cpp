// Edges: grabbed, hung on, gone along, climbed, dropped, vaulted, and refused.
#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

Actor climber() {
    Actor actor;
    actor.settings.ledge_reach = 0.3;
    actor.settings.vault_height = 1.2;
    return actor;
}

const CharacterInput east{.wish = {3, 0, 0}};

TEST(MovementLedge, AnEdgeIsGrabbedInTheFallHungOnAndClimbed) {
    const World world = Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, 5, 5}).world();
    Actor actor = climber();
    actor.state.position = {1.4, 5.5, 0};
    for (int i = 0; i < 120 && !actor.did(CharacterEvent::grabbed_ledge); ++i) actor.tick(world, {.wish = {0.5, 0, 0}});
    ASSERT_TRUE(actor.did(CharacterEvent::grabbed_ledge));
    EXPECT_EQ(actor.state.footing, Footing::ledge);
    const double feet = actor.state.position.y - 0.91;
    EXPECT_NEAR(feet + actor.settings.hands_height, 5, 0.03);
    const dvec3 hung = actor.state.position;
    actor.run(world, 1);
    EXPECT_EQ(actor.state.position, hung) << "without a wish it stays";
    for (int i = 0; i < 180 && !actor.did(CharacterEvent::climbed_ledge); ++i) actor.tick(world, east);
    actor.run(world, 0.5);
    EXPECT_TRUE(actor.on_ground());
    EXPECT_NEAR(actor.state.position.y, 5.91, 0.01);
}

TEST(MovementLedge, WhoHangsGoesAlongTheEdgeToItsEndAndDropsWhenAskedTo) {
    const World world = Scene().floor(-20, 20, -9, 9).block({2, 0, -2}, {9, 5, 2}).world();
    Actor actor = climber();
    actor.state.position = {1.4, 5.5, 0};
    for (int i = 0; i < 120 && !actor.did(CharacterEvent::grabbed_ledge); ++i) actor.tick(world, {.wish = {0.5, 0, 0}});
    ASSERT_TRUE(actor.did(CharacterEvent::grabbed_ledge));
    actor.run(world, 1, {.wish = {0, 0, 1}});
    EXPECT_NEAR(actor.state.position.z, actor.settings.shimmy_speed, 0.05);
    actor.run(world, 3, {.wish = {0, 0, 1}});
    EXPECT_EQ(actor.state.footing, Footing::ledge);
    EXPECT_LT(actor.state.position.z, 2.2) << "the edge ends";
    actor.tick(world, {.crouch = true});
    EXPECT_TRUE(actor.did(CharacterEvent::dropped_ledge));
    actor.run(world, 2);
    EXPECT_TRUE(actor.on_ground());
    EXPECT_NEAR(actor.state.position.y, 0.91, 0.01);
}

TEST(MovementLedge, AnEdgeIsLetGoWhenTheSettingsOrTheModeAllowNone) {
    const World world = Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, 5, 5}).world();
    for (const CharacterMode mode : {CharacterMode::walk, CharacterMode::swim, CharacterMode::fly}) {
        Actor actor = climber();
        actor.state.position = {1.4, 5.5, 0};
        for (int i = 0; i < 120 && !actor.did(CharacterEvent::grabbed_ledge); ++i)
            actor.tick(world, {.wish = {0.5, 0, 0}});
        ASSERT_EQ(actor.state.footing, Footing::ledge);
        if (mode == CharacterMode::walk) actor.settings.ledge_reach = 0;
        EXPECT_TRUE(actor.tick(world, {.mode = mode}).has(CharacterEvent::dropped_ledge));
        EXPECT_EQ(actor.state.hold, Hold::none);
        EXPECT_EQ(actor.state.footing, Footing::air);
        actor.run(world, 2);
        EXPECT_TRUE(actor.on_ground()) << "it falls";
    }
}

TEST(MovementLedge, AnEdgeWithoutRoomAboveItIsHeldAndNotClimbed) {
    const World world =
        Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, 5, 5}).block({2, 5.8, -5}, {9, 8, 5}).world();
    Actor actor = climber();
    actor.state.position = {1.4, 5.5, 0};
    for (int i = 0; i < 120 && !actor.did(CharacterEvent::grabbed_ledge); ++i) actor.tick(world, {.wish = {0.5, 0, 0}});
    ASSERT_TRUE(actor.did(CharacterEvent::grabbed_ledge));
    actor.run(world, 2, east);
    EXPECT_EQ(actor.state.footing, Footing::ledge);
    EXPECT_FALSE(actor.did(CharacterEvent::climbed_ledge));
}

TEST(MovementLedge, ASmoothWallAndASlopingTopOfferNoEdge) {
    const World wall = Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, 50, 5}).world();
    Actor actor = climber();
    actor.state.position = {1.4, 8, 0};
    actor.run(wall, 2, east);
    EXPECT_FALSE(actor.did(CharacterEvent::grabbed_ledge));
    const World roof = Scene()
                           .floor(-20, 20, -5, 5)
                           .quad({2, 0, -5}, {2, 0, 5}, {2, 5, 5}, {2, 5, -5})
                           .quad({2, 5, -5}, {2, 5, 5}, {5, 11, 5}, {5, 11, -5})
                           .world();
    Actor other = climber();
    other.state.position = {1.4, 6, 0};
    other.run(roof, 2, east);
    EXPECT_FALSE(other.did(CharacterEvent::grabbed_ledge));
}

TEST(MovementLedge, AWallOfAMetreIsVaultedByAPressOfJumpAndAHigherOneIsNot) {
    for (const double height : {0.8, 1.1, 1.5}) {
        const World world = Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, height, 5}).world();
        Actor actor = climber();
        actor.settings.jump_height = 0.1;
        actor.state.position = {1.3, 1, 0};
        actor.run(world, 0.5);
        actor.tick(world, {.wish = {3, 0, 0}, .jump = true});
        actor.run(world, 1.2, {.wish = {0.5, 0, 0}});
        EXPECT_EQ(actor.did(CharacterEvent::vaulted), height < 1.2) << height;
        if (height >= 1.2) continue;
        EXPECT_TRUE(actor.on_ground()) << height;
        EXPECT_NEAR(actor.state.position.y, height + 0.91, 0.01);
    }
}

/// Hangs on an edge 5 m high, west of it.
Actor hung_on(const World& world, const CharacterSettings& settings) {
    Actor actor{.settings = settings};
    actor.state.position = {1.4, 5.5, 0};
    for (int i = 0; i < 120 && !actor.did(CharacterEvent::grabbed_ledge); ++i) actor.tick(world, {.wish = {0.5, 0, 0}});
    EXPECT_TRUE(actor.did(CharacterEvent::grabbed_ledge));
    actor.run(world, 0.5);
    EXPECT_EQ(actor.state.footing, Footing::ledge);
    return actor;
}

TEST(MovementLedge, WhoHangsHasItsBodyForEdgesAndGivesItBackWhenItStandsOrFalls) {
    const World world = Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, 5, 5}).world();
    for (const double width : {0.2, 0.4, 0.6}) {
        CharacterSettings settings = climber().settings;
        settings.on_ledge = Volume(Ellipsoid{{width, 0.8, width}});
        Actor actor = hung_on(world, settings);
        EXPECT_EQ(actor.state.form, CharacterForm::on_ledge) << width;
        EXPECT_FALSE(actor.did(CharacterEvent::no_room)) << width;
        EXPECT_NEAR(actor.state.position.y - 0.81 + settings.hands_height, 5, 0.03) << "the hands stay";
        EXPECT_NEAR(actor.state.position.x, 2 - width, 0.05) << "beside the wall";
        Actor falls = actor;
        falls.run(world, 2, {.crouch = true});
        EXPECT_TRUE(falls.on_ground()) << width;
        EXPECT_EQ(falls.state.form, CharacterForm::standing) << width;
        EXPECT_NEAR(falls.state.position.y, 0.91, 0.01) << width;
        for (int i = 0; i < 180 && !actor.did(CharacterEvent::climbed_ledge); ++i) actor.tick(world, east);
        EXPECT_EQ(actor.state.form, CharacterForm::on_ledge) << width;
        actor.run(world, 0.5, east);
        EXPECT_TRUE(actor.on_ground()) << width;
        EXPECT_EQ(actor.state.form, CharacterForm::standing) << width;
        EXPECT_NEAR(actor.state.position.y, 5.91, 0.01) << width;
    }
}

TEST(MovementLedge, ABodyForEdgesThatHasNoRoomIsNotTaken) {
    // Between the wall and one behind it there is room for 0.4 m of half width and not for 0.6.
    const World world =
        Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, 5, 5}).block({0, 0, -5}, {0.95, 9, 5}).world();
    CharacterSettings settings = climber().settings;
    settings.on_ledge = Volume(Ellipsoid{{0.6, 0.8, 0.6}});
    const Actor actor = hung_on(world, settings);
    EXPECT_EQ(actor.state.form, CharacterForm::standing);
    EXPECT_TRUE(actor.did(CharacterEvent::no_room));
    EXPECT_FALSE(actor.did(CharacterEvent::stuck));
    EXPECT_FALSE(actor.did(CharacterEvent::recovered));
}

TEST(MovementLedge, WhoseBodyForEdgesWouldFitWhereItCannotStandHoldsTheEdgeAndDoesNotClimb) {
    const World world =
        Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {9, 5, 5}).block({2, 6.2, -5}, {9, 8, 5}).world();
    CharacterSettings settings = climber().settings;
    settings.on_ledge = Volume(Ellipsoid{{0.3, 0.5, 0.3}});
    Actor actor = hung_on(world, settings);
    EXPECT_EQ(actor.state.form, CharacterForm::on_ledge);
    actor.run(world, 2, east);
    EXPECT_EQ(actor.state.footing, Footing::ledge);
    EXPECT_FALSE(actor.did(CharacterEvent::climbed_ledge));
}

TEST(MovementLedge, ABodyForEdgesThatIsNoneMakesTheSettingsInvalid) {
    CharacterSettings settings = climber().settings;
    settings.on_ledge = Volume(Ellipsoid{{0.3, -1, 0.3}});
    EXPECT_FALSE(is_valid(settings));
}

}  // namespace
}  // namespace surefoot::tests
