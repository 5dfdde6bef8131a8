// The theatre in other hands than a player's: while somebody is tested, its forms and the observer's keys; and the
// labels that a script clicks.
#include <filesystem>

#include "platformer/play/theatre.hpp"
#include "platformer/screens/arrange.hpp"

namespace surefoot::platformer {

bool Theatre::session_event(const view::InputEvent& event) {
    const bool writes = view::is_press(event, view::Key::f9);
    if (!writes && !view::is_press(event, view::Key::f10)) return false;
    obey_all();  // answers that wait are taken before there is another form
    if (writes) {
        screens_.ask(PlaySession::note_form());
        controls_.release();
    } else {
        note_wrong(session_->note({}, run_ ? run_->game().seconds() : 0));
        mark_ = "Marked";
        mark_left_ = 2;
    }
    return true;
}

void Theatre::take_answers() {
    const Form& form = screens_.form();
    if (form.id == "note") {
        note_wrong(session_->note(form["text"].text, run_ ? run_->game().seconds() : 0));
    } else if (form.id == "end") {
        note_wrong(session_->answer(form));
        quit_ = true;
    } else {
        if (const auto begun = session_->begin(form, today()); !begun) {
            note(begun.error().text);
            screens_.ask(form);  // by value: it is the screens' own
            return;
        }
        // Who is tested begins as everybody begins, and does not touch what the machine's owner has won.
        namespace fs = std::filesystem;
        options_.progress = (fs::path(session_->folder()) / "progress.json").string();
        options_.recordings = (fs::path(session_->folder()) / "best").string();
        progress_ = {};
        show_cards();
        begin_named_level();
    }
}

std::optional<view::dvec2> Theatre::place_of(std::string_view label) const {
    if (screens_.is_playing()) return std::nullopt;
    const Menu menu = screens_.menu();
    const view::Layout& layout = screens_.layout();
    const Arrangement all = arrange(menu, layout.size(), screens_.scroll());
    for (std::size_t i = 0; i < menu.entries.size(); ++i) {
        const view::dvec2 middle = all.places[i].middle();
        if (menu.entries[i].can_focus() && menu.entries[i].label == label && all.page.has(middle))
            return middle * layout.pixels() / layout.per_window_unit;
    }
    return std::nullopt;
}

std::vector<std::string> Theatre::labels() const {
    std::vector<std::string> all;
    if (screens_.is_playing()) return all;
    for (const Entry& entry : screens_.menu().entries)
        if (entry.can_focus()) all.push_back(entry.label);
    return all;
}

}  // namespace surefoot::platformer
