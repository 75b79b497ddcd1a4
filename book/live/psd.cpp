// Chapter 5: a track of stated roughness and joints, its spectrum, and the class read off it.
#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>

#include "live.hpp"

namespace railbook::live {
namespace {

using namespace spectra;

constexpr double rail = 39 * units::foot;

void track(const Inputs& in, Answer& out) {
  SyntheticTrack description;
  description.seed = static_cast<std::uint64_t>(in.whole("seed"));
  description.A = in["A"];
  description.phi_c = in["corner"];
  description.rail_length = rail;
  description.dip =
      convert_dip(in["dip"], LineConvention::printed, LineConvention::exact_one_sided);
  description.dip_scatter = in["scatter"];
  const auto z =
      synthesize(description, static_cast<std::size_t>(in["length"] / description.spacing));
  const Spectrum spectrum = welch(z, description.spacing,
                                  {.segment = static_cast<std::size_t>(1) << in.whole("segment")});
  const SpectrumFit fit = fit_track_spectrum(spectrum, {.rail_length = rail});
  const ClassRule rule{.chord = 19};
  const double dip = std::max(0.0, fit.B_printed.value);
  const Classification found = classify(std::max(0.0, fit.A.value), dip, rule);
  const Classification true_class = classify(in["A"], in["dip"], rule);
  out.value("A", fit.A.value);
  out.value("A_error", fit.A.error);
  out.value("corner", fit.phi_c.value);
  out.value("corner_error", fit.phi_c.error);
  out.value("corner_fitted", fit.corner == CornerState::fitted ? 1 : 0);
  out.value("dip", dip);
  out.value("dip_error", fit.B_printed.error);
  out.value("line_significant", fit.line_significant ? 1 : 0);
  out.value("class", found.track_class);
  out.value("deviation", found.deviation);
  out.value("true_class", true_class.track_class);
  out.value("true_deviation", true_class.deviation);
  out.value("segments", static_cast<double>(spectrum.segments));
  out.value("averages", spectrum.averages);
  out.table("spectrum", {"phi", "density", "low", "high", "fit", "truth"});
  const BandSpectrum bands = band_average(spectrum, 12, 4 * spectrum.df, 1.4);
  const TrackParameters truth{.A = in["A"], .phi_c = in["corner"]};
  for (Eigen::Index k = 0; k < bands.frequency.size(); ++k) {
    const double s = bands.density[k], error = 2 * bands.relative_error[k];
    out.row({bands.frequency[k], s, s / (1 + error), s * (1 + error),
             std::exp(fit.regression.log_density(std::log(bands.frequency[k]))),
             random_psd(truth, bands.frequency[k])});
  }
  out.table("odds", {"class", "probability"});
  const auto odds = class_probabilities(fit, rule);
  for (std::size_t m = 0; m < odds.size(); ++m) out.row({static_cast<double>(m), odds[m]});
  out.table("limits", {"class", "limit"});
  for (std::size_t m = 0; m < rule.limits.size(); ++m)
    out.row({static_cast<double>(m + 1), rule.limits[m]});
  out.table("record", {"x", "z"});
  for (std::size_t i = 0; i < std::min<std::size_t>(z.size(), 600); ++i)
    out.row({static_cast<double>(i) * description.spacing, z[i]});
}

}  // namespace

std::span<const Function> psd_functions() {
  static const std::array<Function, 1> all{{{"track",
                                             nullptr,
                                             {{"A", "m^2 cycle/m", 1e-7, 1e-9, 1e-4},
                                              {"corner", "cycle/m", 0.13, 0.03, 0.5},
                                              {"dip", "m", 0.006, 0, 0.05},
                                              {"scatter", "", 0, 0, 1},
                                              {"length", "m", 1609.344, 500, 32e3},
                                              {"seed", "", 1, 1, 1e6},
                                              {"segment", "", 10, 9, 12}},  // power of two
                                             track}}};
  return all;
}

}  // namespace railbook::live
