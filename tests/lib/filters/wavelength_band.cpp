#include <railbook/filters/wavelength_band.hpp>

#include <catch2/catch.hpp>
#include <string_view>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using filters::Band;
using units::pi;

TEST_CASE("input: bands and chords that the samples cannot carry are refused") {
  CHECK_THROWS_AS(filters::band_taps(filters::bands[0], 1, 0.6), InputError);
  CHECK_THROWS_AS(filters::band_taps(filters::bands[3], 1, 1e-5), InputError);
  CHECK_THROWS_AS(filters::band_taps(filters::bands[1], 1, 0), InputError);
  // Two samples beyond the one before the chord's end, and eight at least, which a filter asks for.
  CHECK(filters::chord_taps(20, 0.25).half.size() == 43);
  CHECK(filters::chord_taps(1.2, 0.25).half.size() == 9);
  CHECK_THROWS_AS(filters::chord_taps(1, 0.3), InputError);
  CHECK_THROWS_AS(filters::chord_taps(20, -1), InputError);
}

TEST_CASE("unit: the European bands are those that two open codes have") {
  struct Edges {
    std::string_view name;
    double shortest, longest;
  };
  std::size_t k = 0;
  for (const auto& [name, shortest, longest] :
       {Edges{"D0", 1, 5}, Edges{"D1", 3, 25}, Edges{"D2", 25, 70}, Edges{"D3", 70, 150}}) {
    REQUIRE(k < filters::bands.size());
    const Band& band = filters::bands[k++];
    CHECK(band.name == name);
    CHECK(band.shortest == shortest);
    CHECK(band.longest == longest);
  }
  CHECK(k == filters::bands.size());
}
