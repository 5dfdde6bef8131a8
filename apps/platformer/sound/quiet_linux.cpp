#include <dlfcn.h>

#include "platformer/sound/quiet.hpp"

namespace surefoot::sound {

void quieten_alsa() {
    // OpenAL loads ALSA by itself, if it is there, and this asks for the same copy. It stays, since it keeps the handler.
    static void* const alsa = dlopen("libasound.so.2", RTLD_NOW | RTLD_LOCAL);
    if (alsa == nullptr) return;
    using Handler = void (*)(const char*, int, const char*, int, const char*, ...);
    const auto set = reinterpret_cast<int (*)(Handler)>(dlsym(alsa, "snd_lib_error_set_handler"));
    if (set != nullptr) set([](const char*, int, const char*, int, const char*, ...) {});
}

}  // namespace surefoot::sound
