#include "platformer/screens/screens.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "platformer/screens/arrange.hpp"
#include "platformer/screens/settings_rows.hpp"

namespace surefoot::platformer {

Screens::Screens(GameSettings settings) : settings_(std::move(settings)) {
    open_title();
}

void Screens::set_levels(std::vector<LevelCard> levels, std::vector<BrokenLevel> broken) {
    levels_ = std::move(levels);
    broken_ = std::move(broken);
    level_ = std::min(level_, levels_.empty() ? 0 : levels_.size() - 1);
    if (!stack_.empty()) put_focus(focus());
}

void Screens::set_layout(const view::Layout& layout) {
    const bool is_other = layout.size() != layout_.size();
    layout_ = layout;
    if (is_other && !stack_.empty()) show_focus(menu());
}

void Screens::say(std::string notice) {
    notice_ = std::move(notice);
    notice_left_ = std::clamp(0.06 * double(notice_.size()), 4.0, 12.0);  // long enough to be read
}

std::optional<Command> Screens::take() {
    if (commands_.empty()) return std::nullopt;
    Command first = std::move(commands_.front());
    commands_.erase(commands_.begin());
    return first;
}

void Screens::open_title() {
    stack_.clear();
    watching_ = false;
    push(ScreenId::title);
}

void Screens::pause() {
    if (is_playing()) push(ScreenId::pause);
}

void Screens::show_win(const WinResult& result) {
    win_ = result;
    stack_.clear();
    push(ScreenId::win);
    guard_hands();
}

void Screens::show_lose(const LoseResult& result) {
    lose_ = result;
    stack_.clear();
    push(ScreenId::lose);
    guard_hands();
}

void Screens::show_replay_end() {
    stack_.clear();
    push(ScreenId::replay_end);
}

void Screens::show_getting_ready() {
    stack_.clear();
    push(ScreenId::getting_ready);
}

void Screens::show_ready() {
    if (!is_playing() && top() == ScreenId::getting_ready) stack_.clear();
}

void Screens::show_trouble(std::string title, std::string why) {
    trouble_ = {std::move(title), std::move(why)};
    push(ScreenId::trouble);
}

bool Screens::ask(Form form) {
    if (!is_playing() && top() == ScreenId::form) return false;
    form_ = std::move(form);
    push(ScreenId::form);
    return true;
}

void Screens::end_form(Command::Kind how) {
    // The command goes first: whoever reads the answers does so before the game goes on.
    commands_.push_back({how, {}});
    pop();
}

/// A press on a field: the next choice, or, where there is nothing to press, on to the next field.
void Screens::fill_in(const Entry& entry) {
    if (entry.kind == Entry::Kind::line)
        move_rows(menu(), 1);
    else
        form_.fields[entry.index].step(1);
}

void Screens::begin_level(const std::string& id, bool watching) {
    const auto found = std::find_if(levels_.begin(), levels_.end(), [&](const auto& level) { return level.id == id; });
    level_ = static_cast<std::size_t>(found - levels_.begin());
    watching_ = watching;
    stack_.clear();
}

void Screens::push(ScreenId id) {
    capture_.reset();
    dragged_.reset();
    stack_.push_back({.id = id});
    const std::vector<Entry> entries = menu().entries;
    const auto played = std::ranges::find_if(
        entries, [&](const Entry& entry) { return entry.act == Act::open_level && entry.index == level_; });
    const bool is_read = !entries.empty() && entries.front().kind == Entry::Kind::text;
    put_focus(id == ScreenId::levels && played != entries.end() ? std::size_t(played - entries.begin()) : 0);
    if (is_read) stack_.back().scroll = 0;  // from its beginning
}

void Screens::pop() {
    const ScreenId gone = top();
    capture_.reset();
    dragged_.reset();
    stack_.pop_back();
    if (gone == ScreenId::options || gone == ScreenId::bindings) commands_.push_back({Command::Kind::keep, {}});
    if (stack_.empty()) {
        commands_.push_back({Command::Kind::resume, {}});
    } else {
        put_focus(focus());
    }
}

/// On this entry, or on the next that can have it: every screen has one, its way out.
void Screens::put_focus(std::size_t at) {
    const Menu now = menu();
    const std::size_t count = now.entries.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t one = (at + i) % count;
        if (!now.entries[one].can_focus()) continue;
        stack_.back().focus = one;
        break;
    }
    show_focus(now);
}

void Screens::show_focus(const Menu& now) {
    Open& open = stack_.back();
    const Arrangement all = arrange(now, layout_.size(), open.scroll);
    const view::Rect& place = all.places[open.focus];
    constexpr double air = 40;  // of what comes next
    if (place.low.y - air < all.page.low.y) open.scroll -= all.page.low.y - place.low.y + air;
    if (place.high.y + air > all.page.high.y) open.scroll += place.high.y + air - all.page.high.y;
    open.scroll = std::clamp(open.scroll, 0.0, all.highest_scroll);
}

void Screens::obey(Intent intent) {
    if (stack_.empty()) return;
    const Menu now = menu();
    const Entry& entry = now.entries[focus()];
    switch (intent) {
        case Intent::none:
            return;
        case Intent::up:
            move_rows(now, -1);
            break;
        case Intent::down:
            move_rows(now, 1);
            break;
        case Intent::leftwards:
        case Intent::rightwards: {
            const int direction = intent == Intent::leftwards ? -1 : 1;
            if (entry.is_adjusted()) {
                change(entry, direction);
            } else if (now.columns > 1) {
                move_within(now, direction, false);
            }
            break;
        }
        case Intent::next:
            move_within(now, 1, true);
            break;
        case Intent::previous:
            move_within(now, -1, true);
            break;
        case Intent::accept:
            choose(entry);
            break;
        case Intent::back:
            back();
            break;
        case Intent::clear:
            if (entry.act != Act::bind) break;
            if (auto why = settings_.bindings.bind(static_cast<Action>(entry.index), entry.place, {})) {
                say(*why);
            } else {
                commands_.push_back({Command::Kind::settings, {}});
            }
            break;
    }
}

/// To the next row with something to choose, round and round, to the nearest column.
void Screens::move_rows(const Menu& now, int direction) {
    const Entry& from = now.entries[focus()];
    const int rows = now.entries.back().row + 1;
    for (int i = 1; i <= rows; ++i) {
        const int row = ((from.row + direction * i) % rows + rows) % rows;
        std::optional<std::size_t> best;
        for (std::size_t k = 0; k < now.entries.size(); ++k) {
            const Entry& entry = now.entries[k];
            if (entry.row != row || !entry.can_focus()) continue;
            if (!best || std::abs(entry.column - from.column) < std::abs(now.entries[*best].column - from.column))
                best = k;
        }
        if (!best) continue;
        stack_.back().focus = *best;
        show_focus(now);
        return;
    }
}

/// One entry on, in reading order: within what stands in columns, or over the whole screen.
void Screens::move_within(const Menu& now, int direction, bool whole) {
    const auto takes_part = [&](const Entry& entry) {
        return entry.can_focus() && (whole || entry.kind == now.entries[focus()].kind);
    };
    const std::size_t count = now.entries.size();
    for (std::size_t i = 1; i <= count; ++i) {
        const std::size_t at = (focus() + (direction > 0 ? i : count - i)) % count;
        if (!takes_part(now.entries[at])) continue;
        stack_.back().focus = at;
        show_focus(now);
        return;
    }
}

void Screens::change(const Entry& entry, int direction) {
    if (entry.act == Act::field) {
        form_.fields[entry.index].step(direction);
        return;
    }
    adjust(setting_rows()[entry.index], settings_, direction);
    commands_.push_back({Command::Kind::settings, {}});
}

void Screens::play(Command::Kind kind, std::size_t level) {
    if (level >= levels_.size()) return;
    level_ = level;
    watching_ = kind == Command::Kind::watch;
    stack_.clear();
    commands_.push_back({kind, levels_[level].id});
}

void Screens::leave() {
    open_title();
    push(ScreenId::levels);
    commands_.push_back({Command::Kind::leave, {}});
}

void Screens::back() {
    switch (top()) {
        case ScreenId::title:
            push(ScreenId::quit);
            break;
        case ScreenId::win:
        case ScreenId::lose:
        case ScreenId::replay_end:
        case ScreenId::getting_ready:
            leave();
            break;
        case ScreenId::form:
            end_form(Command::Kind::dismissed);
            break;
        default:
            pop();
            break;
    }
}

void Screens::set_window_size(const view::ivec2& size) {
    settings_.width = size.x;
    settings_.height = size.y;
}

void Screens::choose(Act act) {
    const Menu now = menu();
    const auto found = std::ranges::find(now.entries, act, &Entry::act);
    if (found != now.entries.end()) choose(*found);
}

void Screens::choose(const Entry& entry) {
    if (!entry.enabled) {
        say(entry.hint);
        return;
    }
    switch (entry.act) {
        case Act::none:
            break;
        case Act::go_on:
            play(Command::Kind::start, next_to_play());
            break;
        case Act::levels:
            push(ScreenId::levels);
            break;
        case Act::options:
            push(ScreenId::options);
            break;
        case Act::bindings:
            push(ScreenId::bindings);
            break;
        case Act::help:
            push(ScreenId::help);
            break;
        case Act::credits:
            push(ScreenId::credits);
            break;
        case Act::ask_quit:
            push(ScreenId::quit);
            break;
        case Act::quit:
            commands_.push_back({Command::Kind::quit, {}});
            break;
        case Act::back:
        case Act::resume:
            pop();
            break;
        case Act::open_level:
            level_ = entry.index;
            push(ScreenId::level);
            break;
        case Act::open_broken:
            show_trouble(broken_[entry.index].name + " cannot be played", broken_[entry.index].why);
            break;
        case Act::start:
            play(Command::Kind::start, level_);
            break;
        case Act::race:
            play(Command::Kind::race, level_);
            break;
        case Act::watch:
            play(Command::Kind::watch, level_);
            break;
        case Act::next:
            play(Command::Kind::start, level_ + 1);
            break;
        case Act::retry:
        case Act::restart:
            stack_.clear();
            commands_.push_back({entry.act == Act::retry ? Command::Kind::retry : Command::Kind::restart, {}});
            break;
        case Act::leave:
            leave();
            break;
        case Act::set:
            change(entry, 1);
            break;
        case Act::bind:
            capture_ = Capture{static_cast<Action>(entry.index), entry.place, 6};
            break;
        case Act::reset_settings: {
            const GameSettings before = std::exchange(settings_, {});
            settings_.bindings = before.bindings;
            settings_.width = before.width;  // the window's own
            settings_.height = before.height;
            commands_.push_back({Command::Kind::settings, {}});
            break;
        }
        case Act::field:
            fill_in(entry);
            break;
        case Act::submit:
            end_form(Command::Kind::answered);
            break;
        case Act::dismiss:
            end_form(Command::Kind::dismissed);
            break;
        case Act::reset_bindings:
            settings_.bindings = Bindings::defaults();
            commands_.push_back({Command::Kind::settings, {}});
            break;
    }
}

}  // namespace surefoot::platformer
