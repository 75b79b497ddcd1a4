#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/reference_spectra.hpp>
#include <railbook/units/constants.hpp>

#include "psd/references.hpp"

namespace railbook::psd_tool {
namespace {

constexpr double mm = units::millimetre;

}  // namespace

void add_references(tool::Summary& s, const std::vector<std::string>& references,
                    const spectra::Spectrum& own, const spectra::FitOptions& options) {
  if (references.empty()) return;
  double measured = 0;
  std::vector<double> sums(references.size());
  for (Eigen::Index k = 1; k < own.density.size(); ++k) {
    const double phi = own.frequency(k);
    const double gain = spectra::squared_gain(options.chord, phi);
    if (phi < 1.0 / 25 || phi > 1.0 / 3 || gain < options.least_gain) continue;
    measured += own.density[k] / gain * own.df;
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += spectra::reference(references[i]).density(phi) * own.df;
  }
  if (!(measured > 0)) return;
  s.add("rms_3_25_mm", "rms of waves of 3 to 25 m", std::sqrt(measured) / mm, "mm");
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const std::string& name = references[i];
    s.add("rms_" + name + "_mm", "  of " + name, std::sqrt(sums[i]) / mm, "mm",
          fmt::format("the record is {}; {}", measured < sums[i] ? "better" : "worse",
                      spectra::reference(name).source));
  }
}

std::string reference_table(const std::vector<std::string>& references, double low, double high) {
  std::string text;
  for (const std::string& name : references) {
    const spectra::Reference& r = spectra::reference(name);
    if (!text.empty()) text += "\n\n";
    text += fmt::format("phi_cycle_per_m,S_m2_per_cycle_per_m,{}\n", name);
    const double from = std::max(low, r.low), to = std::min(high, r.high);
    for (int i = 0; i <= 200; ++i) {
      const double phi = from * std::pow(to / from, i / 200.0);
      text += fmt::format("{:.6g},{:.6g},\n", phi, r.density(phi));
    }
  }
  return text + "\n";
}

}  // namespace railbook::psd_tool
