// The theatre while somebody is tested: its forms and the observer's keys.
#include <filesystem>

#include "platformer/play/theatre.hpp"

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
        note("Marked.");
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

}  // namespace surefoot::platformer
