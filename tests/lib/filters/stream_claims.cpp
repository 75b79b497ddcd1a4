// The accuracy that lib/filters states of its streams, on seeded records: what goes in is known,
// and comes out again; and of the closed forms that need no series.
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/high_pass.hpp>
#include <railbook/filters/hybrid_filter.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::filters;
using namespace railbook::tests;

namespace {

using LongComplex = std::complex<Long>;

double off(LongComplex found, LongComplex exact, Long scale) {
  return static_cast<double>(std::abs(found - exact) / scale);
}

// A second-order low-pass under a constant input u: output and rate after T, by its two modes.
void advance(const SecondOrderLowPass& f, Long u, Long T, Long& y, Long& v) {
  const Long mean = f.damping * Long{f.omega}, square = mean * mean - Long{f.omega} * f.omega;
  const LongComplex w = std::sqrt(LongComplex{square});
  const LongComplex s = std::abs(w) * T < 1e-9L ? LongComplex{T} : std::sinh(w * T) / w,
                    c = std::cosh(w * T);
  const Long d = y - u, e = std::exp(-mean * T);
  y = u + e * (d * c + (v + mean * d) * s).real();
  v = e * (v * c - (mean * v + Long{f.omega} * f.omega * d) * s).real();
}

}  // namespace

TEST_CASE("claim: responses and corners") {
  Claim first("filters::first_order_analog"), second("filters::second_order_analog"),
      sinc("filters::sinc_limit"), constant("filters::time_constant"),
      digital("filters::low_pass_gain"), chord("filters::short_chord");
  RandomStream draw(51);
  for (int k = 0; k < 1000; ++k) {
    const double kappa = draw.decades(1e-8, 1e3),
                 theta = k % 2 == 0 ? draw.decades(1e-8, 3.14)
                                    : kappa * (1 + draw.decades(1e-15, 1e-1));
    const LongComplex one = Long{kappa} / LongComplex{kappa, theta};
    first.error(off(first_order_analog(kappa, theta), one, std::abs(one)));
    const SecondOrderLowPass f{draw.decades(1e-3, 1e3), draw.decades(1e-9, 3)};
    const double T = kappa / f.omega;
    const Long x = Long{f.omega} * T;
    const LongComplex two =
        x * x / LongComplex{(x - theta) * (x + theta), 2 * f.damping * x * theta};
    // At resonance the rounding of omega T counts as much as the damping lets it.
    second.error(off(second_order_analog(f, T, theta), two, std::abs(two) * (1 + std::abs(two))));
    sinc.error(off(sinc_limit(theta), std::sin(Long{theta} / 2) / (Long{theta} / 2), 1));
    const double tau = draw.decades(1e-3, 1e3), step = tau * draw.decades(1e-9, 10),
                 hertz = draw.decades(1e-6, 0.5) / step;
    constant.error(off(time_constant(tau), 1 / (2 * long_pi * tau), 1 / (2 * long_pi * tau)));
    const int poles = 1 + k % 8;
    const Long rest = -std::expm1(-Long{step} / tau), a = std::exp(-Long{step} / tau),
               half = long_pi * Long{hertz} * step, s = std::sin(half);
    const LongComplex gain =
        std::pow(rest / (rest + a * LongComplex{2 * s * s, 2 * s * std::cos(half)}), poles);
    digital.error(off(low_pass_gain(tau, poles, hertz, step), gain, std::abs(gain) * poles));
    const LongComplex smooth =
        std::pow(Long{1} / LongComplex{1, 2 * long_pi * Long{hertz} * tau}, poles);
    digital.error(off(low_pass_gain(tau, poles, hertz), smooth, std::abs(smooth) * poles));
    const TwoIntervals mean{draw(-10, 10), draw.decades(1e-4, 1), draw.decades(1e-4, 1)};
    const double z = draw(-0.1, 0.1);
    const Long curve = Long{mean.T_after} * (Long{mean.T_before} + mean.T_after) * mean.mean / 2,
               change = (Long{mean.T_after} / mean.T_before - 1) * z;
    chord.error(off(short_chord(mean, z), -(curve + change) / 2,
                    std::abs(curve) + std::abs(z) * (1 + Long{mean.T_after} / mean.T_before)));
  }
}

TEST_CASE("claim: hybrid filters give back what the analog ones were given") {
  Claim first("filters::FirstOrderHybrid"), second("filters::SecondOrderHybrid"),
      roll("filters::ComplementaryFilter");
  RandomStream draw(52);
  for (int k = 0; k < 60; ++k) {
    const double corner = draw.decades(1e-2, 1e3);
    FirstOrderHybrid filter(corner);
    Long y = draw(-1, 1);
    filter.push(static_cast<double>(y), 1);
    const double tau = draw.decades(1e-2, 100);
    const int poles = 1 + k % 4;
    ComplementaryFilter mixed(tau, poles);
    std::vector<Long> theta(static_cast<std::size_t>(poles), 0);
    for (int i = 0; i < 21; ++i) {
      const double T = draw.decades(1e-4, 1e2) / corner, u = draw(-1, 1);
      const Long rest = -std::expm1(-Long{corner} * T);
      y += rest * (u - y);
      // The output is read with rounding, which the filter magnifies by 1/(1 - a).
      first.error(off(filter.push(static_cast<double>(y), T), u, 1 / rest));
      const double step = tau * draw.decades(1e-6, 10), level = draw(-0.1, 0.1),
                   turn = draw(-0.01, 0.01);
      const double found = mixed.push(level, turn, step);
      Long input = level;
      const Long keep = std::exp(-Long{step} / tau);
      for (Long& t : theta) {
        t = i == 0 ? Long{level} : keep * (t + turn) + -std::expm1(-Long{step} / tau) * input;
        input = t;
      }
      roll.error(off(found, input, 0.1L));
    }
    for (int i = 0; i < 20; ++i) {
      // Critical, next to it, or any other.
      const double damping = i % 4 == 0   ? 1
                             : i % 4 == 1 ? 1 + draw(-1, 1) * draw.decades(1e-15, 1e-2)
                                          : draw.decades(0.05, 5);
      const SecondOrderLowPass f{draw.decades(1e-2, 1e3), damping};
      SecondOrderHybrid hybrid(f);
      Long out = draw(-1, 1), rate = draw(-1, 1) * f.omega;
      const double u = draw(-1, 1), before = draw.decades(1e-2, 2) / f.omega,
                   after = i % 3 == 0 ? before : before * draw(0.3, 3);
      hybrid.push(static_cast<double>(out), 1);
      advance(f, u, before, out, rate);
      hybrid.push(static_cast<double>(out), before);
      advance(f, u, after, out, rate);
      const auto found = hybrid.push(static_cast<double>(out), after);
      const Long x = f.omega * std::min(before, after);
      if (f.damping < 1 && f.omega * std::max(before, after) > 2) continue;  // near half a period
      second.error(off(found.mean, u, (1 + 1 / (x * x)) * (1 + f.damping)));
    }
  }
}

TEST_CASE("claim: the composite filter") {
  Claim reached("filters::reach"), integers("filters::space_curve_integers"),
      chain("filters::GeometryChain"), whole("filters::geometry");
  RandomStream draw(53);
  for (int k = 0; k < 80; ++k) {
    const HighPass filter{3 + 2 * (k % 6), 1 + k % 3, 1};
    const auto curve = space_curve_integers(filter);
    std::vector<std::int64_t> box{1};
    for (int pass = 0; pass < filter.passes; ++pass) {
      std::vector<std::int64_t> wider(box.size() + static_cast<std::size_t>(filter.length) - 1, 0);
      for (std::size_t i = 0; i < box.size(); ++i)
        for (std::size_t j = 0; j < static_cast<std::size_t>(filter.length); ++j)
          wider[i + j] += box[i];
      box = wider;
    }
    const auto total = static_cast<std::int64_t>(std::pow(filter.length, filter.passes));
    const std::size_t middle = box.size() / 2;
    for (int i = 0; i < 20; ++i) reached.error(reach(filter) == middle ? 0 : 1);
    // The curve's own short chord is the high-pass: twice it, -c[i-1] + 2 c[i] - c[i+1] = 2 (M^p
    // delta - box).
    const auto at = [&](std::ptrdiff_t i) {
      return i < 0 || i >= static_cast<std::ptrdiff_t>(curve.size())
                 ? std::int64_t{0}
                 : curve[static_cast<std::size_t>(i)];
    };
    for (std::size_t i = 0; i < box.size(); ++i) {
      const auto j = static_cast<std::ptrdiff_t>(i) - 1;
      const std::int64_t high = (i == middle ? total : 0) - box[i];
      integers.error(-at(j - 1) + 2 * at(j) - at(j + 1) == 2 * high ? 0 : 1);
    }
    GeometryChainOptions options;
    options.high_pass = filter, options.half_chord = 2 + k % 6;
    std::vector<double> x;
    for (int i = 0; i < 120; ++i) x.push_back(draw(-0.01, 0.01));
    const Geometry found = geometry(x, options);
    std::vector<double> streamed;
    GeometryChain stream(options, [&](std::span<const double> space, std::span<const double>) {
      streamed.insert(streamed.end(), space.begin(), space.end());
    });
    for (std::size_t i = 0; i < x.size(); i += 12) stream.push({x.data() + i, 12});
    stream.finish();
    REQUIRE(streamed.size() == x.size());
    const std::size_t side = curve.size() / 2;
    std::vector<Long> exact(x.size(), 0);
    for (std::size_t i = 22; i < 98; ++i)
      for (std::size_t j = 0; j < curve.size(); ++j)
        exact[i] += static_cast<Long>(curve[j]) / static_cast<Long>(total) * x[i + j - side];
    Long size = 0;  // of what is added up
    for (const std::int64_t c : curve)
      size += 0.01L * std::abs(static_cast<Long>(c)) / static_cast<Long>(total);
    const auto half = static_cast<std::size_t>(options.half_chord);
    for (std::size_t i = 30; i < 90; ++i) {
      chain.error(off(streamed[i], exact[i], size));
      whole.error(off(found.space_curve[i], exact[i], size));
      whole.error(off(found.chord[i], exact[i] - (exact[i - half] + exact[i + half]) / 2, size));
    }
  }
}
