#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::Contains;

namespace {

template <class Change>
void refused(Change change, const char* name) {
  SyntheticTrack track;
  track.A = 1e-7;
  track.phi_c = 0.1;
  track.dip = 0.01;
  change(track);
  CHECK_THROWS_WITH(TrackGenerator{track}, Contains(name) && Contains("allowed"));
}

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("input: a synthetic track out of range is refused by the name of its field") {
  refused([](auto& t) { t.spacing = 0; }, "spacing");
  refused([](auto& t) { t.A = -1e-7; }, "A is");
  refused([](auto& t) { t.A = not_a_number; }, "A is");
  refused([](auto& t) { t.phi_c = 0; }, "phi_c");
  refused([](auto& t) { t.low_cut = 0; }, "low cut");
  refused([](auto& t) { t.low_cut = 2.0; }, "low cut");
  refused([](auto& t) { t.rail_length = 0.5; }, "rail length");
  refused([](auto& t) { t.dip_scatter = -1; }, "scatter");
  refused([](auto& t) { t.dip_correlation = 1.0; }, "correlation");
  refused([](auto& t) { t.memory_length = 0; }, "memory rail length");
  refused([](auto& t) { t.sensor_noise = -1; }, "sensor noise");
  refused([](auto& t) { t.gap_share = 1.0; }, "share of samples lost");
  refused([](auto& t) { t.gap_samples = 0; }, "samples per gap");
}

TEST_CASE("input: lines and chords refuse what has no meaning") {
  CHECK_THROWS_AS(line_strength(0, 1.0, LineConvention::printed), InputError);
  CHECK_THROWS_AS(line_power(1, not_a_number, LineConvention::printed), InputError);
  CHECK_THROWS_AS(modulated_lines(0.0, 0.01, 0.5, 0.01, 1.0), InputError);
  CHECK_THROWS_AS(modulated_lines(0.08, 0.01, 0.5, 0.0, 1.0), InputError);
  CHECK_THROWS_AS(chord_sigma(1e-7, 0.0), InputError);
  CHECK_THROWS_AS(chord_sigma(-1e-7, 19.0), InputError);
  CHECK_THROWS_AS(rail_chord_sensitivity(19.0, 0.0), InputError);
  const std::vector<double> z(50, 0.0);
  CHECK_THROWS_WITH(mid_chord_offsets(z, 0.3048, 62 * units::foot),
                    Contains("samples of the profile"));
  CHECK_THROWS_AS(mid_chord_offsets(z, 0.3048, 0.3), InputError);
  // Two samples to either side, or four where a chord ends between two: and the one in the middle.
  for (const auto& [chord, reach] : {std::pair{4.0, 2U}, {5.0, 4U}}) {
    const std::span<const double> all{z};
    CHECK_THROWS_WITH(mid_chord_offsets(all.first(2 * reach), 1, chord), Contains("samples of"));
    CHECK(mid_chord_offsets(all.first(2 * reach + 1), 1, chord).offset.size() == 1);
  }
}
