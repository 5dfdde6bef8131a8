#include <dlfcn.h>

#include "platformer/sound/quiet.hpp"

namespace surefoot::sound {

namespace {

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

void quieten_alsa() {
    // OpenAL loads ALSA by itself, if it is there, and this asks for the same copy. It stays, since it keeps the
    // handler.
    static void* const alsa = dlopen("libasound.so.2", RTLD_NOW | RTLD_LOCAL);
    if (alsa == nullptr) return;
    const auto set = reinterpret_cast<int (*)(decltype(&say_nothing))>(dlsym(alsa, "snd_lib_error_set_handler"));
    if (set != nullptr) set(say_nothing);
}

}  // namespace surefoot::sound
