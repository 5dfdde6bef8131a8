// surefoot replay: a saved moment is asked again. The same bits?
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

#include "command.hpp"
#include "moment.hpp"
#include "query.hpp"
#include "replays.hpp"

namespace surefoot::tools {
namespace {

struct ReplayOptions {
    std::vector<std::string> files;
    SessionOptions session;
    bool json = false;
    bool cpp = false;
};

std::string report(const std::string& file, const Capture& capture, const Replay& again) {
    std::string text =
        fmt::format("{}, saved by surefoot {} ({})\n", file, version_text(capture.origin.library), capture.origin.abi);
    if (!capture.note.empty()) text += fmt::format("Note: {}\n", capture.note);
    text += question_text(capture);
    text += "Recorded:\n" + moment_answer_text(capture.question, capture.answer);
    if (again.is_same()) {
        text += "Asked again: the same, to the last bit.\n";
    } else {
        text += fmt::format("Asked again by surefoot {}: DIFFERENT in {}.\n", version_text(library_version()),
                            difference_text(again.differs));
        text += moment_answer_text(capture.question, again.answer);
    }
    return text + "Why: " + why_text(capture, again.answer);
}

std::string json_line(const std::string& file, const Capture& capture, const Replay& again) {
    std::string text = fmt::format(R"({{"file":{},"same":{},"differs":[)", json_string(file), again.is_same());
    const std::string names = difference_text(again.differs);
    for (std::size_t at = 0; at < names.size();) {
        const std::size_t end = std::min(names.find(", ", at), names.size());
        text += (at == 0 ? "" : ",") + json_string(again.differs.hit ? "hit" : names.substr(at, end - at));
        at = end + 2;
    }
    text += R"(],"recorded":)";
    append_answer(text, capture.answer);
    text += R"(,"answer":)";
    append_answer(text, again.answer);
    return text + fmt::format(R"(,"triangles":{},"library":{},"note":{}}})"
                              "\n",
                              capture.triangles.size(), json_string(version_text(capture.origin.library)),
                              json_string(capture.note));
}

/// The file's name without its folder and ending: what its test is called.
std::string stem_of(const std::string& file) {
    const std::size_t slash = file.find_last_of("/\\");
    const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
    return name.substr(0, name.find('.'));
}

ExitCode unreadable(const Error& error) {
    fmt::print(stderr, "surefoot: {}\n", error.text);
    return ExitCode::file;
}

ExitCode replay_question(const std::string& file, const ReplayOptions& given) {
    const Expected<Capture> capture = read_capture(file);
    if (!capture) return unreadable(capture.error());
    if (given.cpp) {
        write_out(capture_cpp_test(*capture, stem_of(file)));
        return ExitCode::ok;
    }
    const Replay again = replay(*capture);
    write_out(given.json ? json_line(file, *capture, again) : report(file, *capture, again));
    return again.is_same() ? ExitCode::ok : ExitCode::failed;
}

ExitCode replay_step(const std::string& file, const ReplayOptions& given) {
    const Expected<StepCapture> capture = read_step_capture(file);
    if (!capture) return unreadable(capture.error());
    if (given.cpp) {
        write_out(capture_cpp_test(*capture, stem_of(file)));
        return ExitCode::ok;
    }
    const StepReplay again = replay(*capture);
    write_out(given.json ? step_json(file, *capture, again) : step_report(file, *capture, again));
    return again.is_same() ? ExitCode::ok : ExitCode::failed;
}

ExitCode replay_session(const std::string& file, const ReplayOptions& given) {
    const Expected<Session> session = read_session(file);
    if (!session) return unreadable(session.error());
    SessionOptions options = given.session;
    options.json = given.json;
    return run_session(file, *session, options);
}

SavedKind kind_of(const std::string& file) {
    std::ifstream input(file, std::ios::binary);
    std::stringstream text;
    text << input.rdbuf();
    return saved_kind(text.str());
}

ExitCode replay_file(const std::string& file, const ReplayOptions& given) {
    const SavedKind kind = kind_of(file);
    if (kind == SavedKind::question) return replay_question(file, given);
    if (kind == SavedKind::step) return replay_step(file, given);
    if (given.cpp) throw Failure{ExitCode::usage, fmt::format("{}: --cpp is for sweeps, rays and steps", file)};
    return replay_session(file, given);
}

ExitCode run_replay(const ReplayOptions& given) {
    ExitCode code = ExitCode::ok;
    for (std::size_t i = 0; i < given.files.size(); ++i) {
        if (i > 0 && !given.json && !given.cpp) write_out("\n");
        const ExitCode its = replay_file(given.files[i], given);
        if (its == ExitCode::file || code == ExitCode::ok) code = its;
    }
    return code;
}

}  // namespace

void add_replay(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand(
        "replay", "Ask a saved moment again, make a step or play a session again: the same bits, and why?");
    const auto given = std::make_shared<ReplayOptions>();
    command
        ->add_option("files", given->files, "Moments, as `sweep --save`, `prove --save-failures` or a game wrote them")
        ->type_name("FILE")
        ->required();
    auto* json = command->add_flag("--json", given->json, "Print a line of JSON for each file");
    command->add_flag("--cpp", given->cpp, "Print each as a GoogleTest case in C++ that expects the recorded answer")
        ->excludes(json);
    given->session.level.add_to(*command, "--level", false);
    command->add_option("--tick", given->session.tick, "Of a session: tell why this tick went as it did")
        ->type_name("N");
    command->add_option("--save", given->session.save, "Of a session: save the step of that tick as a moment")
        ->type_name("FILE");
    command->footer(
        help_footer("  surefoot sweep castle.obj --shape sphere:0.5 --from 0,2,0 --to 0,2,12 --save moment.json\n"
                    "  surefoot replay moment.json\n"
                    "  surefoot replay moment.json --cpp > moment_test.cpp\n"
                    "  surefoot replay stopped.json\n"
                    "  surefoot replay session.json --level castle.obj --tick 120 --save stopped.json\n"
                    "\nExit codes: 0 each is the same, 1 at least one differs, 2 wrong usage, 3 a file cannot be "
                    "read."));
    command->callback([given, &run] { run = [given] { return run_replay(*given); }; });
}

}  // namespace surefoot::tools
