// A difficult record and what is done to it: the rows of the stability table.
#pragma once

#include <string>
#include <vector>

#include "items.hpp"
#include "signal/spectrum_fit.hpp"

namespace psd {

enum class Gaps { kept, bridged, zeroed, cut_out };  // what was done about missing samples

struct Case {
  std::string id, what, stress;
  railbook::signal::SyntheticTrack track;
  railbook::signal::WelchOptions welch = {};
  railbook::signal::FitOptions fit = {};
  double length = 160 * railbook::units::kilometre;
  Gaps gaps = Gaps::kept;
};

std::vector<Case> stability_cases(const railbook::signal::SyntheticTrack& base);

}  // namespace psd
