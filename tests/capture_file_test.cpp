// The file of a moment: what is written reads back to the same bits, and what is no such file says so.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "capture_moments.hpp"

namespace surefoot {
namespace {

using namespace tests;

bool same_turn(const dquat& a, const dquat& b) {
    return same_bits(a.w, b.w) && same_bits(dvec3(a.x, a.y, a.z), dvec3(b.x, b.y, b.z));
}
bool same_pose(const Pose& a, const Pose& b) {
    return same_bits(a.position, b.position) && same_turn(a.orientation, b.orientation);
}
template <typename T, typename Same>
bool same_lists(const std::vector<T>& a, const std::vector<T>& b, Same same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// All of it, compared one by one and not by the text that is tested here.
bool same_captures(const Capture& a, const Capture& b) {
    const auto bits_of = [](const Shape& shape) {
        return std::visit(
            [](const auto& s) {
                std::array<std::uint64_t, 3> bits{};
                std::memcpy(bits.data(), &s, sizeof s);
                return bits;
            },
            shape);
    };
    const CapturedQuestion& p = a.question;
    const CapturedQuestion& q = b.question;
    const bool same_question =
        p.kind == q.kind && p.volume.shape.index() == q.volume.shape.index() &&
        bits_of(p.volume.shape) == bits_of(q.volume.shape) && same_turn(p.volume.orientation, q.volume.orientation) &&
        same_bits(p.motion.from, q.motion.from) && same_bits(p.motion.to, q.motion.to) && p.one_sided == q.one_sided &&
        same_bits(p.begin, q.begin) && same_bits(p.end, q.end) && same_bits(p.turn_gap, q.turn_gap);
    const auto same_triangle = [](const CapturedTriangle& s, const CapturedTriangle& t) {
        return same_bits(s.triangle.a, t.triangle.a) && same_bits(s.triangle.b, t.triangle.b) &&
               same_bits(s.triangle.c, t.triangle.c) && s.id == t.id && s.surface == t.surface && s.body == t.body;
    };
    const auto same_body = [](const CapturedBody& s, const CapturedBody& t) {
        return s.body == t.body && same_pose(s.start, t.start) && same_pose(s.end, t.end) &&
               same_bits(s.bounds.min, t.bounds.min) && same_bits(s.bounds.max, t.bounds.max);
    };
    return same_question && same_lists(a.triangles, b.triangles, same_triangle) &&
           same_lists(a.bodies, b.bodies, same_body) && same_bits(a.answer, b.answer) &&
           a.origin.library == b.origin.library && a.origin.abi == b.origin.abi && a.origin.format == b.origin.format &&
           a.note == b.note;
}

TEST(CaptureFile, any_capture_reads_back_to_the_same_bits) {
    SplitMix random(11);
    for (int i = 0; i < 5000; ++i) {
        const Capture capture = any_capture(random);
        const std::string text = capture_text(capture);
        const auto read = parse_capture(text);
        ASSERT_TRUE(read) << read.error().text << "\n" << text;
        ASSERT_TRUE(same_captures(capture, *read)) << text;
        ASSERT_EQ(capture_text(*read), text);
    }
}

TEST(CaptureFile, every_kind_of_number_reads_back) {
    using Limits = std::numeric_limits<double>;
    Capture capture = capture_sweep(Triangle{}, Sphere{1}, {});
    for (const double value :
         {0.0, -0.0, Limits::denorm_min(), -Limits::denorm_min(), Limits::min(), Limits::max(), Limits::lowest(),
          Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::quiet_NaN(), Limits::signaling_NaN(),
          0.1, 1e22, 1e23, 5e-324, 9007199254740993.0}) {
        capture.question.motion.to.y = value;
        const auto read = parse_capture(capture_text(capture));
        ASSERT_TRUE(read) << read.error().text;
        EXPECT_TRUE(same_bits(read->question.motion.to.y, value)) << value;
    }
}

TEST(CaptureFile, members_may_stand_in_any_order_and_with_any_white_space) {
    const auto read = parse_capture(
        "\r\n\t{\"triangles\":[],\"ray\":{\"to\":[1,2,3],\"one_sided\":true,\"from\":[0,-0,1E+2]},\"answer\":null,"
        "\"abi\":\"v0\",\"note\":\"\\u00e9\\ud83e\\uddb6\\/\",\"library\":\"0.1.0\",\"surefoot_capture\":1} \n");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->question.kind, CaptureKind::ray);
    EXPECT_EQ(read->question.motion.from.z, 100);
    EXPECT_TRUE(std::signbit(read->question.motion.from.y));
    EXPECT_EQ(read->note, "\xc3\xa9\xf0\x9f\xa6\xb6/");
}

TEST(CaptureFile, a_note_that_is_no_utf8_becomes_question_marks) {
    Capture capture = capture_sweep(Triangle{}, Sphere{1}, {});
    capture.note = "a\xff\xc0\x80 \xed\xa0\x80 \xf4\x90\x80\x80 \xe2\x82";
    const auto read = parse_capture(capture_text(capture));
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->note, "a??? ??? ???? ??");
}

/// What the error says of the capture's text with one piece of it replaced.
Error error_of(const std::string& piece, const std::string& by) {
    static const Capture capture = capture_sweep(moving_world(soup(5, 300, 6)), Sphere{1}, {{-5, 0, 0}, {5, 0, 0}});
    std::string text = capture_text(capture);
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, text.npos) << piece;
    const auto read = parse_capture(text.replace(at, piece.size(), by), "moment.json");
    EXPECT_FALSE(read) << piece << " became " << by;
    return read ? Error{} : read.error();
}

TEST(CaptureFile, what_is_wrong_is_named_with_file_and_byte) {
    const Error error = error_of("\"surefoot_capture\": 1", "\"surefoot_capture\": x");
    EXPECT_EQ(error.code, ErrorCode::unreadable);
    EXPECT_EQ(error.file, "moment.json");
    EXPECT_EQ(error.byte, 24U);
    EXPECT_EQ(error.text, "moment.json: no capture: byte 24: a whole number from 0 to 4294967295 must be here");
    EXPECT_EQ(error_of("\"surefoot_capture\": 1", "\"surefoot_capture\": 2").code, ErrorCode::unsupported);
}

TEST(CaptureFile, what_is_not_of_the_form_is_refused) {
    for (const auto& [piece, by] : std::initializer_list<std::pair<const char*, const char*>>{
             {"\"note\"", "\"nots\""},
             {"\"note\": \"\",", ""},
             {"\"note\": \"\",", "\"note\": \"\", \"note\": \"\","},
             {"\"note\": \"\"", "\"note\": \"\\x\""},
             {"\"note\": \"\"", "\"note\": \"\\ud800\""},
             {"\"note\": \"\"", "\"note\": \"\n\""},
             {"\"note\": \"\"", "\"note\": null"},
             {"\"library\": \"", "\"library\": \"x"},
             {"\"library\": \"", "\"library\": \"-"},
             {"\"library\": \"", "\"library\": \"1."},
             {"\"sphere\": [1]", "\"sphere\": [1, 2]"},
             {"\"sphere\": [1]", "\"sphere\": []"},
             {"\"sphere\": [1]", "\"sphere\": [01]"},
             {"\"sphere\": [1]", "\"sphere\": [1.]"},
             {"\"sphere\": [1]", "\"sphere\": [.5]"},
             {"\"sphere\": [1]", "\"sphere\": [+1]"},
             {"\"sphere\": [1]", "\"sphere\": [1e]"},
             {"\"sphere\": [1]", "\"sphere\": [1e999]"},
             {"\"sphere\": [1]", "\"sphere\": [nan]"},
             {"\"sphere\": [1]", "\"sphere\": [\"nan\"]"},
             {"\"sphere\": [1]", "\"sphere\": [\"nan:3ff0000000000000\"]"},
             {"\"sphere\": [1]", "\"sphere\": [1], \"box\": [1, 1, 1]"},
             {"\"sphere\": [1]", ""},
             {"\"begin\": 0,", ""},
             {"\"one_sided\": false", "\"one_sided\": 0"},
             {"\"sweep\"", "\"ray\""},
             {"\"feature\": \"", "\"feature\": \"x"},
             {"\"triangle\": ", "\"triangle\": -"},
             {"\"triangle\": ", "\"triangle\": 99999999999"},
             {"\"bodies\": [\n    {\"body\": 2,", "\"bodies\": [\n    {\"body\": 10,"},
             {"\"bodies\": [\n    {\"body\": 2,", "\"bodies\": [\n    {\"body\": 3,"},
             {"\"triangles\": [\n    {\"body\": 2,", "\"triangles\": [\n    {\"body\": 3,"},
             {"\"triangles\": [\n    {\"body\": 2,", "\"triangles\": [\n    {\"body\": 40,"},
             {"}\n", "}\n}"}}) {
        EXPECT_FALSE(error_of(piece, by).text.empty());
    }
}

TEST(CaptureFile, a_file_cut_anywhere_is_refused) {
    SplitMix random(13);
    for (int i = 0; i < 20; ++i) {
        const std::string text = capture_text(any_capture(random));
        for (std::size_t size = 0; size + 1 < text.size(); ++size)
            ASSERT_FALSE(parse_capture(std::string_view(text).substr(0, size))) << text.substr(0, size);
    }
}

TEST(CaptureFile, a_file_with_flipped_bytes_is_refused_or_replays_without_harm) {
    SplitMix random(17);
    const std::string world = capture_text(
        capture_sweep(moving_world(soup(5, 30, 3)), any_volume(random), {{-5, 0, 0}, {5, 0, 0}}, {.turn_gap = 0.1}));
    int read = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = i % 2 == 0 ? world : capture_text(any_capture(random));
        for (std::uint64_t flips = 1 + random.next() % 3; flips > 0; --flips) {
            char& byte = text[random.next() % text.size()];
            byte =
                random.next() % 2 == 0 ? static_cast<char>(random.next()) : "0123456789e-.[]{}\""[random.next() % 18];
        }
        const auto capture = parse_capture(text);
        if (!capture) {
            ASSERT_FALSE(capture.error().text.empty());
            ASSERT_LE(capture.error().byte, text.size());
            continue;
        }
        ++read;
        static_cast<void>(replay(*capture));
        static_cast<void>(capture_cpp_test(*capture));
    }
    EXPECT_GT(read, 1000);
}

TEST(CaptureFile, deep_nesting_costs_nothing) {
    EXPECT_FALSE(parse_capture(std::string(std::size_t{1} << 20U, '[')));
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"answer\":";
    EXPECT_FALSE(parse_capture(objects));
}

TEST(CaptureFile, is_written_and_read_by_path) {
    const auto folder = std::filesystem::temp_directory_path() / ("surefoot-capture-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::string path = (folder / "moment.json").string();
    const Capture capture = capture_sweep(soup(1, 40, 10).mesh(), Sphere{1}, {{0, 5, 0}, {0, -5, 0}});
    std::ofstream(path) << "something that was there before";
    ASSERT_TRUE(write_capture(capture, path));
    const auto read = read_capture(path);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_TRUE(same_captures(capture, *read));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "nothing is left beside it";
    EXPECT_EQ(write_capture(capture, (folder / "none" / "moment.json").string()).error().code, ErrorCode::write_failed);
    EXPECT_EQ(read_capture((folder / "none.json").string()).error().code, ErrorCode::not_found);
    std::filesystem::remove_all(folder);
}

// The example stands in docs/capture.md as this library writes it.
TEST(CaptureFile, the_example_of_the_docs_is_what_is_written) {
    const Triangle ground{{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}};
    Capture capture = capture_sweep(ground, Ellipsoid{}, {{-0.5, 2, 0.5}, {-0.5, -2, 0.5}});
    capture.note = "falls onto the ground";
    std::ifstream page(SUREFOOT_DOCS_DIR "/capture.md", std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(page)), {});
    EXPECT_NE(text.find("```json\n" + capture_text(capture) + "```\n"), text.npos) << capture_text(capture);
    EXPECT_NE(text.find("```text\n" + capture_cpp_test(capture, "falls") + "```\n"), text.npos)
        << capture_cpp_test(capture, "falls");
}

}  // namespace
}  // namespace surefoot
