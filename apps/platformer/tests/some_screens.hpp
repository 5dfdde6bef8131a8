// Keys and a form for tests of the screens.
#pragma once

#include "platformer/screens/form.hpp"
#include "platformer/screens/screens.hpp"

namespace surefoot::platformer {

inline void tap(Screens& screens, view::Key key) {
    screens.event(view::KeyPress{.key = key});
    screens.event(view::KeyPress{.key = key, .down = false});
}

inline Form some_form() {
    return {.id = "some",
            .title = "A form",
            .fields = {
                {.key = "name", .label = "Name", .required = true},
                {.kind = FormField::Kind::choice, .key = "often", .label = "How often?", .choices = {"never", "often"}},
                {.kind = FormField::Kind::agree, .key = "yes", .label = "I agree", .required = true}}};
}

}  // namespace surefoot::platformer
