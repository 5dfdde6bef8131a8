// A broken promise leaves the question behind as a moment that `surefoot replay` reads, besides the fuzzer's own bytes.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include <surefoot/capture.hpp>
#include <surefoot/file.hpp>

namespace fuzz {

// The question that is being asked, while one lives. Nothing is captured unless it comes to that.
class Asking {
public:
    template <typename Capture>
    explicit Asking(const Capture& capture) : context_(&capture), before_(now_) {
        make_ = [](const void* context) { return (*static_cast<const Capture*>(context))(); };
        now_ = this;
    }
    Asking(const Asking&) = delete;
    Asking& operator=(const Asking&) = delete;
    ~Asking() { now_ = before_; }

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
};

}  // namespace fuzz
