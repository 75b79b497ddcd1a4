// What a fit leaves out around lines, and the lines that nobody named: on spectra without scatter,
// where each limit is sharp.
#include <railbook/spectra/line_mask.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/spectra/chord.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::spectra;

namespace {

constexpr double phi_0 = 1 / 12.0, level = 1e-6, df = 1e-3;
constexpr Eigen::Index last = 400;

// Level under a model of level 1: a peak at a bin stands out by what is put there.
struct Flat {
  FitOptions options{.rail_length = 12, .high = 10};
  Spectrum spectrum;
  SpectrumFit fit;
  explicit Flat(double averages = 10) {
    spectrum.df = df, spectrum.averages = averages;
    spectrum.density = Eigen::VectorXd::Constant(last + 1, level);
    fit.bins = 300;
    fit.regression.log_A = -1e3, fit.regression.noise = level;  // white
  }
  void raise(Eigen::Index from, Eigen::Index to, double times) {
    for (Eigen::Index k = from; k <= to; ++k) spectrum.density[k] *= times;
  }
  std::optional<StrayLine> stray() const { return stray_line(spectrum, options, fit); }
  bool seen(Eigen::Index bin, double times = 10) const {
    Flat other = *this;
    other.raise(bin, bin, times);
    const auto found = other.stray();
    return found && found->phi == other.spectrum.frequency(bin);
  }
};

// The chance that a sum of n exponential times of mean 1 is beyond x.
double beyond(int n, double x) {
  double term = std::exp(-x), sum = term;
  for (int k = 1; k < n; ++k) sum += term *= x / k;
  return sum;
}

}  // namespace

TEST_CASE(
    "unit: a fit leaves out its line, eight thousandths about the harmonics, and blind bins") {
  const double step = 1e-4;
  for (const double half : {0.02, 0.004}) {
    const FitOptions o{.rail_length = 12, .line_half_width = half};
    for (const int n : {1, 2, 3, 9})
      for (const double side : {-1.0, 1.0}) {
        const double width = n == 1 ? half : 0.008;
        CAPTURE(half, n, side);
        CHECK(masked(o, n * phi_0 + side * (width - step)));
        CHECK_FALSE(masked(o, n * phi_0 + side * (width + step)));
      }
    for (const double phi : {0.001, 0.007, 0.04, 1.5 * phi_0, 2.5 * phi_0})
      CHECK_FALSE(masked(o, phi));
  }
  for (const double least : {0.1, 0.4}) {  // a chord of 4 m is blind at 0, at 1/2, and near them
    const FitOptions o{
        .rail_length = 12, .chord = 4, .least_gain = least, .line_half_width = 0.001};
    const double blind = std::acos(1 - std::sqrt(least)) / (units::pi * 4);
    for (const double side : {-1.0, 1.0}) {
      CHECK(masked(o, 0.25 + side * (0.25 - blind + step)));
      CHECK_FALSE(masked(o, 0.25 + side * (0.25 - blind - step)));
    }
  }
}

TEST_CASE("unit: a line is named by its place, its height and how rarely chance makes its like") {
  for (const double times : {4.0, 4.2, 4.3, 4.4, 5.0, 12.0}) {
    Flat flat;
    flat.raise(301, 301, times);
    const double chance = 300 * beyond(8, 8 * times / 1.1);  // eight tenths of 10 averages
    CAPTURE(times, chance);
    const auto stray = flat.stray();
    REQUIRE(stray.has_value() == (chance < 1e-4));
    if (!stray) continue;
    CHECK(stray->phi == 301 * df);
    CHECK(stray->ratio == Approx(times / 1.1).epsilon(1e-12));
    CHECK(stray->chance == Approx(chance).epsilon(1e-9));
  }
  // However many averages, it is twice as high as what is around it.
  CHECK_FALSE(Flat(1000).seen(301, 1.99 * 1.1));
  CHECK(Flat(1000).seen(301, 2.01 * 1.1));
  // Of two, the rarer; of two too rare for a number, the higher.
  for (const double averages : {10.0, 1e5})
    for (const bool first : {false, true}) {
      Flat two(averages);
      two.raise(201, 201, first ? 11 : 10), two.raise(301, 301, first ? 10 : 11);
      CHECK(two.stray().value().phi == (first ? 201 : 301) * df);
    }
}

TEST_CASE(
    "unit: a line is sought in the band, off the rail's own and foreign ones, from bin 8 on") {
  const Flat flat;  // the rail's at bins 83.3, 166.7, 250
  for (const Eigen::Index bin : {80, 83, 87, 163, 170, 250}) CHECK_FALSE(flat.seen(bin));
  for (const Eigen::Index bin : {79, 88, 162, 171, 41, 43, 12}) CHECK(flat.seen(bin));
  Flat wide = flat;
  wide.options.low = 1e-3;
  for (const Eigen::Index bin : {8, 4, 399}) CHECK(wide.seen(bin) == (bin != 4));
  for (const Eigen::Index bin : {7, 400}) CHECK_FALSE(wide.seen(bin));
  Flat band = flat;
  band.options.low = 0.0205, band.options.high = 0.3005;
  for (const Eigen::Index bin : {20, 301}) CHECK_FALSE(band.seen(bin));
  for (const Eigen::Index bin : {21, 300}) CHECK(band.seen(bin));
  Flat old = flat;
  old.options.foreign_lengths = {10};  // 0.1, 0.2, 0.3
  for (const Eigen::Index bin : {295, 305}) CHECK_FALSE(old.seen(bin));
  for (const Eigen::Index bin : {292, 308}) CHECK(old.seen(bin));
}

TEST_CASE("unit: a chord measurement is scaled by its response, and zero where that is zero") {
  Flat flat;
  flat.options.chord = 4, flat.fit.regression.noise = level;
  for (Eigen::Index k = 0; k <= last; ++k)
    flat.spectrum.density[k] *= squared_gain(4, flat.spectrum.frequency(k));
  CHECK_FALSE(flat.stray());
  for (const Eigen::Index bin : {150, 210, 301}) CHECK(flat.seen(bin));
  CHECK_FALSE(flat.seen(30));  // a squared gain of 0.005
}

TEST_CASE("unit: what surrounds a line is the median of the 32 bins from the third on") {
  const auto ratio = [](Eigen::Index from, Eigen::Index to, Eigen::Index bin = 301) {
    Flat flat(1000);
    flat.options.low = df;
    flat.raise(from, to, 3);
    flat.spectrum.density[bin] = 30 * level;
    return flat.stray().value().ratio;
  };
  const double low = 30 / 1.1, high = 10 / 1.1;
  CHECK(ratio(299, 303) == Approx(low));   // the skirts of the line
  CHECK(ratio(304, 319) == Approx(high));  // half of the 32
  CHECK(ratio(283, 298) == Approx(high));
  for (const auto& [from, to] : {std::pair{305, 319}, {304, 318}, {284, 298}, {283, 297}})
    CHECK(ratio(from, to) == Approx(low));
  // Near an end of the spectrum its last bin stands for those beyond,
  CHECK(ratio(391, 400, 388) == Approx(high));
  CHECK(ratio(392, 400, 388) == Approx(low));
  CHECK(ratio(1, 5, 8) == Approx(high));  // as the first one does for those before
  CHECK(ratio(1, 4, 8) == Approx(low));
  CHECK(ratio(2, 5, 8) == Approx(low));
}

TEST_CASE("unit: old rails, longer or shorter, have sidebands at their difference from the new") {
  for (const double length : {9.5, 10.0, 14.0, 15.5}) {
    const FitOptions o{.rail_length = 12, .foreign_lengths = {length}};
    const double difference = std::abs(1 / length - phi_0);
    for (const double side : {-1.0, 1.0})
      for (const double within : {0.0, 0.0059}) {
        CAPTURE(length, side, within);
        CHECK(near_foreign_line(o, 2 * phi_0 + side * (difference + within)));
        CHECK(near_foreign_line(o, 2 * phi_0 + side * (difference - within)));
        CHECK(near_foreign_line(o, 1 / length + side * within));
      }
  }
}
