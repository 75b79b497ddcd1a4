// A difficult record and what is done to it: the rows of the stability table.
#pragma once

#include <string>
#include <vector>

#include "items.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

enum class Gaps { kept, bridged, zeroed, cut_out };  // what was done about missing samples

struct Case {
  std::string id, what, stress;
  railbook::spectra::SyntheticTrack track;
  railbook::spectra::WelchOptions welch = {};
  railbook::spectra::FitOptions fit = {};
  double length = 160 * railbook::units::kilometre;
  Gaps gaps = Gaps::kept;
};

std::vector<Case> stability_cases(const railbook::spectra::SyntheticTrack& base);

}  // namespace railbook::psd_chapter
