// Tests keep away from the user's own cache, and find the importer of this build. Linked into each of them.
#include <cstdlib>

namespace {

[[maybe_unused]] const bool set = setenv("XDG_CACHE_HOME", SUREFOOT_TEST_CACHE, 1) == 0 &&
                                  setenv("SUREFOOT_IMPORTER", SUREFOOT_BUILT_IMPORTER, 1) == 0;

}  // namespace
