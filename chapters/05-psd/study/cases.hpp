// A difficult record and what is done to it: the rows of the stability table.
#pragma once

#include <string>
#include <vector>

#include "sections.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

enum class Gaps { kept, bridged, zeroed, cut_out };  // what was done about missing samples

struct Case {
  std::string id, what, stress;
  spectra::SyntheticTrack track;
  spectra::WelchOptions welch = {};
  spectra::FitOptions fit = {};
  double length = 160 * units::kilometre;
  Gaps gaps = Gaps::kept;
  report::Stands expect = report::holds;
  double loss = 1;  // degrades: bound of the relative error of A
};

std::vector<Case> stability_cases(const spectra::SyntheticTrack& base);

}  // namespace railbook::psd_chapter
