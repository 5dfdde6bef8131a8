// The examples on memory are also tests: each says what must hold, and ends with status 1 when it does not.
#pragma once

#include <cstdio>
#include <cstdlib>

inline void check(bool holds, const char* sentence) {
    std::printf("%s  %s\n", holds ? "holds" : "FAILS", sentence);
    if (!holds) std::exit(1);
}
