// The pictures of docs/memory.md.
#include <string>

#include "canvas.hpp"
#include "sheets.hpp"

namespace pictures {
namespace {

constexpr Lettering small_mono{.size = 13, .anchor = Anchor::middle, .mono = true};
constexpr Lettering note{.size = 13.5, .fill = colour::quiet};
constexpr Lettering note_middle{.size = 13.5, .fill = colour::quiet, .anchor = Anchor::middle};
constexpr Lettering head{.size = 15, .bold = true};

constexpr Style cell_empty{.stroke = colour::faint, .width = 1.4, .fill = "#ffffff"};
constexpr Style cell_alive{.stroke = colour::shape, .width = 1.6, .fill = colour::shape_fill};
constexpr Style cell_dead{.stroke = colour::faint, .width = 1.4, .fill = "#f0eeea"};

std::string draw_lifetime() {
    Canvas c(760, 250, "One piece of memory, and the life of two doors in it.");
    const struct {
        const char* title;
        const char* inside;
        const Style* style;
        const char* below;
    } steps[] = {
        {"memory", "? ? ? ?", &cell_empty, "no door"},
        {"::new (room) Door", "oak", &cell_alive, "a door is born"},
        {"door->~Door()", "? ? ? ?", &cell_dead, "it dies, room stays"},
        {"::new (room) Door", "steel", &cell_alive, "another, same place"},
    };
    double x = 28;
    for (int i = 0; i < 4; ++i) {
        const auto& step = steps[i];
        const double width = 160;
        c.text({x + width / 2, 48}, step.title,
               {.size = 13, .fill = i == 0 ? colour::quiet : colour::motion, .anchor = Anchor::middle, .mono = true});
        c.box({x, 66}, width, 62, *step.style, 5);
        c.text({x + width / 2, 102}, step.inside,
               {.size = 17,
                .fill = step.style == &cell_alive ? colour::shape : colour::faint,
                .anchor = Anchor::middle,
                .bold = true});
        c.text({x + width / 2, 152}, step.below, note_middle);
        if (i < 3) c.arrow({x + width + 3, 97}, {x + width + 19, 97}, {.stroke = colour::quiet});
        x += width + 22;
    }
    c.line({28, 186}, {734, 186}, {.stroke = colour::ink, .width = 2.2});
    c.text({28, 210}, "the memory lives from here to there: taken once, given back once", note);
    c.line({210, 176}, {370, 176}, {.stroke = colour::shape, .width = 4});
    c.line({574, 176}, {734, 176}, {.stroke = colour::shape, .width = 4});
    c.text({734, 232}, "the objects live only where the blue is",
           {.size = 13.5, .fill = colour::shape, .anchor = Anchor::end});
    return c.svg();
}

std::string draw_slab() {
    Canvas c(760, 330, "The chunks of a slab: objects, the tags beside them, and the chain of free slots.");
    c.text({28, 36}, "handle { index 5, generation 3 }", {.size = 15, .fill = colour::touch, .mono = true});
    const double left = 118, width = 70, top = 96, height = 50;
    const struct {
        const char* word;
        int generation;
        const char* next;
    } slots[] = {{"hero", 1, ""}, {"", 2, "3"},   {"crate", 3, ""}, {"", 4, "—"},
                 {"lift", 1, ""}, {"key", 3, ""}, {"", 0, ""},      {"", 0, ""}};
    c.text({28, top + 30}, "objects", note);
    c.text({28, top + 92}, "generation", note);
    c.text({28, top + 122}, "next free", note);
    for (int i = 0; i < 8; ++i) {
        const double x = left + i * (width + 4) + (i >= 4 ? 22 : 0);
        const bool alive = slots[i].generation % 2 == 1;
        const bool fresh = i >= 6;
        c.text({x + width / 2, top - 10}, std::to_string(i), note_middle);
        c.box({x, top}, width, height, alive ? cell_alive : (fresh ? cell_empty : cell_dead), 4);
        if (alive)
            c.text({x + width / 2, top + 31}, slots[i].word,
                   {.size = 15, .fill = colour::shape, .anchor = Anchor::middle});
        if (fresh) {
            c.text({x + width / 2, top + 92}, "·", small_mono);
        } else {
            c.text({x + width / 2, top + 92}, std::to_string(slots[i].generation),
                   {.size = 14,
                    .fill = i == 5 ? colour::touch : (alive ? colour::ink : colour::quiet),
                    .anchor = Anchor::middle,
                    .bold = i == 5,
                    .mono = true});
        }
        c.text({x + width / 2, top + 122}, slots[i].next,
               {.size = 14, .fill = colour::motion, .anchor = Anchor::middle, .mono = true});
    }
    const double x5 = left + 5 * (width + 4) + 22;
    c.line({330, 32}, {x5 + width / 2, 32}, {.stroke = colour::touch});
    c.arrow({x5 + width / 2, 32}, {x5 + width / 2, top - 26}, {.stroke = colour::touch});
    // The chain of free slots: free -> 1 -> 3.
    const double x1 = left + 1 * (width + 4) + width / 2, x3 = left + 3 * (width + 4) + width / 2;
    c.text({28, top + 158}, "free", {.size = 14, .fill = colour::motion, .mono = true});
    c.line({66, top + 153}, {x1, top + 153}, {.stroke = colour::motion});
    c.arrow({x1, top + 153}, {x1, top + 130}, {.stroke = colour::motion});
    c.line({x1 + 14, top + 138}, {x1 + 14, top + 146}, {.stroke = colour::motion});
    c.line({x1 + 14, top + 146}, {x3, top + 146}, {.stroke = colour::motion});
    c.arrow({x3, top + 146}, {x3, top + 130}, {.stroke = colour::motion});
    const double x6 = left + 6 * (width + 4) + 22 + width / 2;
    c.arrow({x6, top + 166}, {x6, top + 104}, {.stroke = colour::quiet});
    c.text({x6, top + 182}, "used: from here on never touched",
           {.size = 13.5, .fill = colour::quiet, .anchor = Anchor::middle});
    c.text({left, top + 208}, "chunk 0: 4 slots", note);
    c.text({left + 4 * (width + 4) + 22, top + 208}, "chunk 1: as many as all before", note);
    return c.svg();
}

std::string draw_alignment() {
    Canvas c(760, 222, "A record of 32 bytes behind a header of five bytes, and behind one that is padded to eight.");
    const double left = 32, byte = 17;
    const auto ruler = [&](double y) {
        for (int i = 0; i <= 40; i += 8) {
            c.line({left + i * byte, y}, {left + i * byte, y + 7}, {.stroke = colour::quiet, .width = 1.1});
            c.text({left + i * byte, y + 22}, std::to_string(i),
                   {.size = 12, .fill = colour::quiet, .anchor = Anchor::middle});
        }
    };
    const auto row = [&](double y, int header, const char* title, std::string_view tint, std::string_view fill) {
        c.box({left, y}, header * byte, 34, {.stroke = colour::quiet, .fill = "#f0eeea"}, 3);
        const char* fields[] = {"x", "y", "z", "team  flags"};
        for (int i = 0; i < 4; ++i) {
            const double x = left + (header + 8 * i) * byte;
            c.box({x, y}, 8 * byte, 34, {.stroke = tint, .fill = fill}, 3);
            c.text({x + 4 * byte, y + 22}, fields[i], {.size = 14, .fill = tint, .anchor = Anchor::middle});
        }
        c.text({left, y - 10}, title, {.size = 14, .fill = tint});
        ruler(y + 36);
    };
    row(40, 5, "header of 5 bytes: x begins at 5, and no double may stand there. Read it with memcpy.", colour::touch,
        "#f6e2dc");
    row(140, 8, "header of 8 bytes: x begins at 8. The record may be used where it stands.", colour::motion, "#dcefe3");
    return c.svg();
}

std::string draw_vtable() {
    Canvas c(760, 350, "A record in a file and the object it becomes: the first eight bytes are the vtable pointer.");
    const double width = 150, height = 44, top = 66, left = 170;
    const auto row = [&](double y, const char* title, const char* slot, std::string_view slot_colour,
                         std::string_view slot_fill) {
        c.text({28, y + 27}, title, head);
        c.box({left, y}, width, height, {.stroke = slot_colour, .fill = slot_fill}, 4);
        c.text({left + width / 2, y + 27}, slot,
               {.size = 14, .fill = slot_colour, .anchor = Anchor::middle, .mono = true});
        const char* fields[] = {"radius  2.0", "id  70"};
        for (int i = 0; i < 2; ++i) {
            const double x = left + (i + 1) * (width + 4);
            c.box({x, y}, width, height, cell_alive, 4);
            c.text({x + width / 2, y + 27}, fields[i],
                   {.size = 14, .fill = colour::shape, .anchor = Anchor::middle, .mono = true});
        }
    };
    for (int i = 0; i < 3; ++i) c.text({left + i * (width + 4), 44}, "byte " + std::to_string(8 * i), note);
    row(top, "in the file", "type 1: disc", colour::ground, colour::ground_fill);
    row(top + 106, "in memory", "vtable pointer", colour::touch, "#f6e2dc");
    c.arrow({left + width / 2, top + height + 4}, {left + width / 2, top + 100}, {.stroke = colour::touch, .width = 2});
    c.text({left + width / 2 + 14, top + 76}, "only these eight bytes are written",
           {.size = 13.5, .fill = colour::touch});
    const double x_id = left + 2 * (width + 4) + width / 2;
    c.line({x_id, top + height + 8}, {x_id, top + 98}, {.stroke = colour::quiet, .dashed = true});
    c.text({x_id + 12, top + 76}, "these stay", note);
    const double y = top + 206;
    c.text({28, y + 22}, "in the code", head);
    const char* table[] = {"Disc: ~Disc()", "area()", "Plate: ~Plate()", "area()"};
    for (int i = 0; i < 4; ++i) {
        const double x = left + i * (width - 10) + (i >= 2 ? 14 : 0);
        c.box({x, y}, width - 14, 36, {.stroke = i < 2 ? colour::ink : colour::faint, .fill = "#ffffff"}, 3);
        c.text({x + (width - 14) / 2, y + 23}, table[i],
               {.size = 13, .fill = i < 2 ? colour::ink : colour::quiet, .anchor = Anchor::middle, .mono = true});
    }
    c.arrow({left + width / 2, top + 106 + height + 2}, {left + width / 2, y - 4}, {.stroke = colour::ink});
    c.text({left, y + 58}, "one table of functions for each class, somewhere else in every run of the program", note);
    return c.svg();
}

}  // namespace

std::span<const Picture> memory_pictures() {
    static constexpr Picture all[] = {
        {"memory-lifetime", draw_lifetime},
        {"memory-slab", draw_slab},
        {"memory-alignment", draw_alignment},
        {"memory-vtable", draw_vtable},
    };
    return all;
}

}  // namespace pictures
