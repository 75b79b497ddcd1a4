#include <catch2/catch.hpp>

#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

TEST_CASE("input: a fit refuses what cannot be fitted and says why") {
  spectra::SyntheticTrack track;
  track.A = 2e-7;
  const auto spectrum = spectra::welch(spectra::synthesize(track, 20000), units::foot);
  const auto refuses = [&](const spectra::FitOptions& options, const char* text) {
    CHECK_THROWS_WITH(spectra::fit_track_spectrum(spectrum, options), Catch::Contains(text));
    CHECK_THROWS_AS(spectra::fit_track_spectrum(spectrum, options), InputError);
  };
  refuses({.rail_length = 0}, "rail length");
  refuses({.rail_length = 500}, "rail wavenumber");
  refuses({.rail_length = 0.5}, "rail wavenumber");
  refuses({.low = 2, .high = 3}, "holds no usable bins");
  refuses({.low = -1}, "lower end of the band");
  refuses({.chord = -1}, "chord");
  refuses({.chord = 78 * units::foot}, "does not see a rail");
  refuses({.chord = 520 * units::foot}, "an eighth of a segment");
  for (const double foreign : {39., 78., 38.}) {  // the line of the rail itself would be left out
    INFO(foreign);
    refuses({.foreign_lengths = {foreign * units::foot}}, "have a line on that of the rail");
  }
  refuses({.foreign_lengths = {-1}}, "foreign rail length");
  const auto constant = spectra::welch(std::vector<double>(20000, 0.0), units::foot);
  CHECK_THROWS_WITH(spectra::fit_track_spectrum(constant), Catch::Contains("constant signal"));
  const auto coarse =
      spectra::welch(spectra::synthesize(track, 20000), units::foot, {.segment = 16});
  CHECK_THROWS_AS(spectra::fit_track_spectrum(coarse), InputError);
}
