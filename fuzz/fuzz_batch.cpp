// A batch of sweeps made of any bytes: every line is answered with one line of JSON, and nothing else happens.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "batch.hpp"

namespace {

surefoot::Mesh floor_of_two() {
    const surefoot::vec3 corners[] = {{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    const std::uint32_t indices[] = {0, 3, 2, 0, 2, 1};
    auto mesh = surefoot::Mesh::build({.vertices = corners, .indices = indices});
    if (!mesh) std::abort();
    return *mesh;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const surefoot::Mesh mesh = floor_of_two();
    std::istringstream input(std::string(data, data + size));
    char* text = nullptr;
    std::size_t length = 0;
    std::FILE* const output = open_memstream(&text, &length);
    if (output == nullptr) return 0;
    const surefoot::tools::BatchCount count = surefoot::tools::run_batch(mesh, {}, input, output);
    std::fclose(output);
    std::istringstream answers(std::string(text, length));
    std::free(text);
    std::uint64_t lines = 0;
    std::uint64_t bad = 0;
    for (std::string line; std::getline(answers, line); ++lines) {
        const nlohmann::json answer = nlohmann::json::parse(line, nullptr, false);
        if (!answer.is_object() || answer.contains("hit") == answer.contains("error")) std::abort();
        bad += answer.contains("error");
    }
    if (lines != count.lines || bad != count.bad) std::abort();
    return 0;
}
