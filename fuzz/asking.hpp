// What was asked when something went wrong, as a moment that `surefoot replay` reads, besides the fuzzer's own bytes.
//
// A broken promise leaves the question with its answer behind. A sanitizer's report, a time-out or memory that ran out
// end the program where nothing can be asked any more; so with SUREFOOT_FUZZ_UNDER_WAY=FILE every question is written
// there before it is asked, and removed once it was answered: what is left is the one that never was. scripts/fuzz.sh
// runs a finding once more in this way.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include <surefoot/capture.hpp>
#include <surefoot/file.hpp>
#include <surefoot/mesh.hpp>

namespace fuzz {

// The question that is being asked, while one lives. Nothing is captured unless it comes to that.
class Asking {
public:
    // `capture` asks it and keeps the answer; `unasked` keeps the question and its triangles alone. Both have to
    // outlive this.
    template <typename Capture, typename Unasked>
    Asking(const Capture& capture, const Unasked& unasked) : context_(&capture), before_(now_) {
        make_ = [](const void* context) { return (*static_cast<const Capture*>(context))(); };
        now_ = this;
        under_way_ = std::getenv("SUREFOOT_FUZZ_UNDER_WAY");
        if (under_way_ == nullptr) return;
        surefoot::Capture moment = unasked();
        moment.note = "never answered; the answer in here is none";
        static_cast<void>(surefoot::write_capture(moment, under_way_));
    }
    Asking(const Asking&) = delete;
    Asking& operator=(const Asking&) = delete;
    ~Asking() {
        now_ = before_;
        if (under_way_ != nullptr) static_cast<void>(std::remove(under_way_));
    }

    // Into the folder SUREFOOT_FUZZ_FINDINGS, else into the current one.
    static void save(const char* promise) {
        if (now_ == nullptr) return;
        surefoot::Capture moment = now_->make_(now_->context_);
        moment.note = std::string("broken promise: ") + promise;
        const std::string text = surefoot::capture_text(moment);
        const char* const folder = std::getenv("SUREFOOT_FUZZ_FINDINGS");
        const std::uint64_t hash = surefoot::hash_bytes(std::as_bytes(std::span(text)));
        const std::string path =
            std::string(folder != nullptr ? folder : ".") + "/moment-" + std::to_string(hash) + ".json";
        if (surefoot::write_capture(moment, path)) std::fprintf(stderr, "surefoot replay %s\n", path.c_str());
    }

private:
    inline static const Asking* now_ = nullptr;

    const void* context_;
    const Asking* before_;
    surefoot::Capture (*make_)(const void*);
    const char* under_way_ = nullptr;
};

inline surefoot::Capture unasked(surefoot::CapturedQuestion question) {
    surefoot::Capture moment;
    moment.question = question;
    moment.origin = {surefoot::library_version(), std::string(surefoot::abi_name), surefoot::capture_format};
    return moment;
}

inline surefoot::Capture unasked(const surefoot::Triangle& triangle, surefoot::CapturedQuestion question) {
    surefoot::Capture moment = unasked(question);
    moment.triangles.push_back({.triangle = triangle});
    return moment;
}

// All of a mesh: which of its triangles are near is a question too.
inline surefoot::Capture unasked(const surefoot::Mesh& mesh, surefoot::CapturedQuestion question) {
    surefoot::Capture moment = unasked(question);
    for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id)
        if (!mesh.is_hidden(id))
            moment.triangles.push_back({.triangle = mesh.triangle(id), .id = id, .surface = mesh.surface(id)});
    return moment;
}

}  // namespace fuzz
