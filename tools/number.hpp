/// Numbers as text that reads back to the same bits.
#pragma once

#include <charconv>
#include <string>

#include <surefoot/math.hpp>

namespace surefoot::tools {

/// The shortest decimal text that reads back to the same double, or the same float.
/// The core has the same lines in src/capture/number.hpp, which is private, as how numbers are printed is no promise of
/// the library; what both have to agree on, JSON and the standard's shortest decimal, neither decides.
template <typename Number>
void append_number(std::string& out, Number value) {
    char text[40];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    static_cast<void>(error);  // 40 characters hold every number
    out.append(text, end);
}

/// "[x,y,z]".
inline void append_array(std::string& out, const dvec3& v) {
    out += '[';
    append_number(out, v.x);
    out += ',';
    append_number(out, v.y);
    out += ',';
    append_number(out, v.z);
    out += ']';
}

}  // namespace surefoot::tools
