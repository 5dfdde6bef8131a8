// What is asked on a screen, and answered by keys.
#include <gtest/gtest.h>

#include "platformer/screens/form.hpp"
#include "platformer/screens/screens.hpp"
#include "some_screens.hpp"

namespace surefoot::platformer {
namespace {

using view::Key;

/// Goes down to the entry with this beginning and presses it.
void choose(Screens& screens, const std::string& label) {
    for (int i = 0; i < 20 && !screens.menu().entries[screens.focus()].label.starts_with(label); ++i)
        tap(screens, Key::down);
    tap(screens, Key::enter);
}

Screens with_levels() {
    Screens screens;
    screens.set_levels({{.id = "level-0", .title = "Level 0"}});
    return screens;
}

TEST(Forms, take_letters_where_one_types_and_move_on_by_the_keys_that_bring_none) {
    Screens screens = with_levels();
    ASSERT_TRUE(screens.ask(some_form()));
    EXPECT_FALSE(screens.ask(some_form())) << "one at a time";
    tap(screens, Key::w);
    screens.event(view::TextInput{"w\u00E9"});
    EXPECT_EQ(screens.form()["name"].text, "w\u00E9");
    EXPECT_EQ(screens.focus(), 0U);
    tap(screens, Key::backspace);
    EXPECT_EQ(screens.form()["name"].text, "w") << "a letter, and not a byte of it";
    tap(screens, Key::right);
    EXPECT_EQ(screens.form()["name"].text, "A");
    screens.event(view::TextInput{"nna"});
    tap(screens, Key::right);
    EXPECT_EQ(screens.form()["name"].text, "Anna") << "a key that slips does not lose a name";
    screens.event(view::TextInput{std::string(FormField::longest, 'x')});
    EXPECT_EQ(screens.form()["name"].text, "Anna");
    tap(screens, Key::enter);
    EXPECT_EQ(screens.focus(), 1U);
    screens.event(view::TextInput{"x"});
    tap(screens, Key::left);
    EXPECT_EQ(screens.form()["often"].value(), "often");
    choose(screens, "Done");
    EXPECT_EQ(screens.top(), ScreenId::form);
    EXPECT_EQ(screens.notice(), "Still open: I agree");
    choose(screens, "I agree");
    choose(screens, "Done");
    EXPECT_EQ(screens.top(), ScreenId::title) << "what was there before";
    EXPECT_EQ(screens.take()->kind, Command::Kind::answered);
    EXPECT_EQ(screens.form()["name"].text, "Anna");
}

TEST(Forms, of_one_line_are_done_with_it_and_the_game_goes_on) {
    Screens screens = with_levels();
    screens.begin_level("level-0");
    screens.ask({.id = "note", .fields = {{.key = "text", .label = "What?", .required = true}}});
    tap(screens, Key::enter);
    ASSERT_FALSE(screens.is_playing()) << "nothing is written yet";
    screens.event(view::TextInput{"why?"});
    tap(screens, Key::enter);
    EXPECT_TRUE(screens.is_playing());
    EXPECT_EQ(screens.take()->kind, Command::Kind::answered);
    EXPECT_EQ(screens.take()->kind, Command::Kind::resume);
    screens.ask({.id = "note", .fields = {{.key = "text", .label = "What?", .required = true}}});
    tap(screens, Key::escape);
    EXPECT_EQ(screens.take()->kind, Command::Kind::dismissed);
}

}  // namespace
}  // namespace surefoot::platformer
