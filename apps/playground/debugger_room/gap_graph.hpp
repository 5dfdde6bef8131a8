/// The graph of g(t), on which t can be dragged.
#pragma once

#include "debugger/gap_curve.hpp"

namespace surefoot::playground {

/// As wide as there is room. Sets `t` while the pointer drags on it.
void gap_graph(const debugger::GapCurve& curve, double& t);

}  // namespace surefoot::playground
