// The accuracy that lib/quality states of the descriptor's filter, its index and its corners: sums
// in 80 bits, and scans.
#include <cmath>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/quality/descriptor_filter.hpp>
#include <railbook/quality/quality_index.hpp>
#include <railbook/quality/vehicle.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::quality;
using namespace railbook::tests;

namespace {

Descriptor drawn(RandomStream& draw) {
  const Suspension s{draw.decades(0.3, 3), draw.decades(0.05, 0.7)};
  const Car car = make_car(draw.decades(100, 2000), draw.decades(1000, 2e4),
                           {draw.decades(0.5, 5), draw.decades(0.05, 0.7)});
  const ForceLimit force{car, static_force(car) * (1 + draw.decades(0.05, 2))};
  return {stroke_limit_of_level(s, draw.decades(2e-3, 0.05)), force, draw.decades(5, 80)};
}

// The sum over the taps at phi (cycle/m).
Long gain(const std::vector<double>& half, double spacing, Long phi) {
  Long sum = half[0];
  for (std::size_t j = 1; j < half.size(); ++j)
    sum += 2 * half[j] * std::cos(2 * long_pi * phi * spacing * Long(j));
  return sum;
}

}  // namespace

TEST_CASE("claim: the descriptor's filter") {
  Claim response("quality::impulse_response"), designed("quality::design_filter"),
      periodic("quality::filter_periodic"), direct("filters::filter_direct"),
      stream("filters::FilterStream"), whole("quality::filter");
  RandomStream draw(95);
  for (int k = 0; k < 100; ++k) {
    Descriptor d = drawn(draw);
    d.force.reset();
    const Envelope envelope(d);
    const double longest = d.speed / d.stroke->suspension.frequency, spacing = longest / 60;
    const double shortest = k % 2 ? 0 : spacing * draw(3, 8);
    const std::size_t n = 512;
    const std::vector<double> h = impulse_response(envelope, spacing, shortest, n);
    const filters::FilterTaps taps = design_filter(envelope, {spacing, shortest, 6 * longest});
    Long size = 0, most = 0;
    for (std::size_t j = 0; j < taps.half.size(); ++j) size += (j ? 2 : 1) * std::abs(taps.half[j]);
    for (std::size_t i = 0; i <= n / 2; ++i)
      most =
          std::max<Long>(most, filter_gain(envelope, shortest, double(i) / (double(n) * spacing)));
    for (int i = 0; i < 10; ++i) {
      // The last of the response stands on both sides at once.
      const auto at = std::size_t(draw(0, double(n) / 2));
      const double own = double(at) / (double(n) * spacing);
      const Long last = (at % 2 ? -1 : 1) * h.back();
      response.error(static_cast<double>(
          std::abs(gain(h, spacing, own) - last - filter_gain(envelope, shortest, own)) / most));
      const double phi = 1 / draw.decades(std::max(1.25 * shortest, 2 * spacing), 6 * longest);
      const double wanted = filter_gain(envelope, shortest, phi);
      designed.error(static_cast<double>(std::abs(gain(taps.half, spacing, phi) - wanted)) /
                     (wanted * taps.gain_error));
    }

    std::vector<double> x(1000), wave(96);
    for (double& v : x) v = draw.normal(1);
    const std::vector<double> one = filter_direct(taps, x), all = filter(taps, x);
    const auto reach = taps.half.size() - 1;
    for (std::size_t i = reach; i + reach < x.size(); i += 17) {
      Long sum = taps.half[0] * Long{x[i]};
      for (std::size_t j = 1; j <= reach; ++j) sum += taps.half[j] * (Long{x[i - j]} + x[i + j]);
      direct.error(static_cast<double>(std::abs(one[i] - sum) / size));
    }
    std::vector<double> pieces;
    filters::FilterStream filter_in_pieces(taps, [&](std::span<const double> out) {
      pieces.insert(pieces.end(), out.begin(), out.end());
    });
    for (std::size_t i = 0; i < x.size(); i += 33)
      filter_in_pieces.push(std::span{x}.subspan(i, std::min<std::size_t>(33, x.size() - i)));
    filter_in_pieces.finish();
    REQUIRE(pieces.size() == x.size());
    for (std::size_t i = 0; i < x.size(); i += 50) {
      stream.error(static_cast<double>(std::abs(pieces[i] - Long{one[i]}) / size));
      whole.error(static_cast<double>(std::abs(all[i] - Long{one[i]}) / size));
    }
    const auto turns = std::size_t(draw(1, 48));
    const double phase = draw(0, 7);
    for (std::size_t i = 0; i < wave.size(); ++i)
      wave[i] = std::cos(2 * units::pi * double(turns * i % 96) / 96 + phase);
    const std::vector<double> out = filter_periodic(envelope, spacing, wave);
    const Long factor = envelope(double(turns) / (96 * spacing));
    for (std::size_t i = 0; i < wave.size(); i += 9)
      periodic.error(static_cast<double>(std::abs(out[i] - factor * wave[i]) / most));
  }
}

TEST_CASE("claim: the index of a record") {
  Claim built("quality::IndexBuilder");
  RandomStream draw(96);
  for (int k = 0; k < 1000; ++k) {
    const double scale = draw.decades(1e-3, 10), spacing = draw.decades(0.1, 1);
    std::vector<double> p;
    for (int i = 0; i < 60; ++i) p.push_back(draw(0, 1) < 0.05 ? std::nan("") : draw.normal(scale));
    IndexBuilder builder({spacing, scale});
    builder.push({p.data(), 23});
    builder.push({p.data() + 23, 37});
    builder.finish();
    const QualityIndex index = builder.index();
    Long sum = 0, square = 0, count = 0, above = 0, largest = 0;
    for (const double v : p)
      if (!std::isnan(v)) {
        sum += std::abs(v), square += Long{v} * v, ++count;
        above += std::abs(v) > scale;
        largest = std::max<Long>(largest, std::abs(v));
      }
    const Long rms = std::sqrt(square / count), mean = sum / count;
    const auto off = [&](Long found, Long exact) {
      built.error(static_cast<double>(std::abs(found - exact) / rms));
    };
    off(index.mean, mean), off(index.rms, rms), off(index.largest, largest);
    off(index.deviation, std::sqrt(rms * rms - mean * mean));
    built.error(Long(index.above) == above && Long(index.samples - index.missing) == count ? 0 : 1);
  }
}

TEST_CASE("claim: where one mode takes over, and where the force has no peak") {
  Claim corner("quality::lower_corner"), least("quality::least_damping_without_peak");
  RandomStream draw(97);
  for (int k = 0; k < 400; ++k) {
    const Descriptor d = drawn(draw);
    const double found = lower_corner(d);
    const auto ratio = [&](double length) {
      return severity(*d.force, d.speed, 1 / length) / severity(*d.stroke, d.speed, 1 / length);
    };
    if (found > 0) corner.error(std::abs(ratio(found) - 1));
    const double centre = d.speed / d.stroke->suspension.frequency;
    for (int i = 0; i < 5;
         ++i) {  // below it the force governs; without one, one of them everywhere
      const double length =
          found > 0 ? found * draw.decades(1e-4, 0.999) : centre * draw.decades(1e-3, 1e3);
      const bool short_waves = ratio(1e-6 * centre) > 1;
      corner.error((ratio(length) > 1) == (found > 0 || short_waves) ? 0 : 1);
    }
  }
  for (int k = 0; k < 1000; ++k) {
    const double mass_ratio = draw.decades(0.1, 1e3),
                 damping = least_damping_without_peak(mass_ratio);
    const auto peaked = [&](double rho) {
      return force_peak(make_car(1, mass_ratio, {1, rho})).found;
    };
    least.error(!peaked(damping * (1 + 1e-6)) && peaked(damping * (1 - 1e-6)) ? 0 : 1);
  }
}
