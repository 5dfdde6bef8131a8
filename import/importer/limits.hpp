/// What the process may not do.
#pragma once

#include <cstdint>

namespace surefoot::importer {

/// No core dumps, no open files but the three standard ones, and an end together with the program that started us.
void harden_process();

/// All memory of the process, its code included. Not under AddressSanitizer and its kin, which reserve terabytes.
void limit_memory(std::uint64_t bytes);

/// Processor time. The one who started us looks at the clock as well; this is for when it is gone.
void limit_time(std::uint64_t seconds);

}  // namespace surefoot::importer
