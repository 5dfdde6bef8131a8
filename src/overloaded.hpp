// A visitor made of lambdas.
#pragma once

namespace surefoot::internal {

template <typename... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace surefoot::internal
