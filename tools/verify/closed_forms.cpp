#include <charconv>

#include <railbook/contact/hertz.hpp>
#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/num/special.hpp>
#include <railbook/quality/vehicle.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/track/beam_on_foundation.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/units/input_error.hpp>

#include "verify/references.hpp"

namespace railbook::verify_tool {

double At::operator[](std::size_t i) const {
  double value = 0;
  const std::string word = i < words.size() ? words[i] : "";
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc{} || end != word.data() + word.size())
    throw InputError("input " + std::to_string(i + 1) + " is \"" + word + "\"; allowed: a number");
  return value;
}

namespace {

contact::HertzContact hertz(const At& at) {
  return contact::hertz_from_force({at[0], at[1], 0}, at[2], at[3]);
}

track::BeamState beam(const At& at) {
  return track::beam_state(track::WinklerBeam{at[0], at[1]}, at[2], at[3]);
}

double band(const At& at) {
  const filters::Band of = filters::parse_band("band", at.words.at(0));
  return filters::band_gain(of, static_cast<int>(at[1]), at[2]);
}

// At a linear force of at[0] over the friction.
double vermeulen_johnson(const At& at) {
  rolling::RollingCase c = rolling::normalised_case(1, 0.3);
  const rolling::Slopes slopes = rolling::vermeulen_johnson_slopes(1, 0.3);
  c.creepage.longitudinal = at[0] / slopes.longitudinal;
  return rolling::vermeulen_johnson(c, slopes).fx;
}

}  // namespace

Quantities closed_forms() {
  return {
      {"hertz-a", [](const At& at) { return hertz(at).a; }},
      {"hertz-b", [](const At& at) { return hertz(at).b; }},
      {"hertz-approach", [](const At& at) { return hertz(at).approach; }},
      {"hertz-pressure", [](const At& at) { return hertz(at).p_max; }},
      {"beam-deflection", [](const At& at) { return beam(at).deflection; }},
      {"beam-slope", [](const At& at) { return -beam(at).slope; }},
      {"beam-moment", [](const At& at) { return beam(at).moment; }},
      {"beam-shear", [](const At& at) { return -beam(at).shear; }},
      {"beam-stiffness",
       [](const At& at) {
         return track::WinklerBeam{at[0], at[1]}.point_stiffness();
       }},
      {"critical-speed", [](const At& at) { return track::critical_speed(at[0], at[1], at[2]); }},
      {"amplification", [](const At& at) { return track::moving_load(at[0], 0).at_load(); }},
      {"chord-gain", [](const At& at) { return spectra::chord_gain(at[0], at[1]); }},
      {"mean-gain",
       [](const At& at) { return filters::mean_gain(static_cast<int>(at[0]), at[1]); }},
      {"band-gain", band},
      {"stroke-gain",
       [](const At& at) {
         return quality::stroke_gain({at[0], at[1]}, at[2]);
       }},
      {"stroke-peak", [](const At& at) { return quality::stroke_peak(at[0]).gain; }},
      {"sine-integral", [](const At& at) { return num::sine_integral(at[0]); }},
      {"normal-exceedance", [](const At& at) { return spectra::normal_exceedance(at[0]); }},
      {"elliptic-k", [](const At& at) { return contact::elliptic_integrals(at[0]).k; }},
      {"elliptic-d", [](const At& at) { return contact::elliptic_integrals(at[0]).d; }},
      {"rail-chord", [](const At& at) { return spectra::rail_chord_sensitivity(at[0], at[1]); }},
      {"vermeulen-johnson", vermeulen_johnson},
  };
}

}  // namespace railbook::verify_tool
