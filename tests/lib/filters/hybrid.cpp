#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/dopri5.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::filters;

namespace {

constexpr double f1 = 2 * units::pi;  // 1 Hz

// The analog filter integrated step by step, with an input nobody can mistake for a constant.
double input(double t) {
  return std::sin(3 * t) + 0.4 * std::cos(11 * t + 1) + 0.1 * t;
}
std::vector<double> analog(const SecondOrderLowPass& f, const std::vector<double>& times,
                           bool first) {
  using State = Eigen::Vector2d;
  const auto rate = [&](double t, const State& y, State& dy) {
    if (first) {
      dy = {f.omega * (input(t) - y[0]), 0};
    } else {
      dy = {y[1], f.omega * f.omega * (input(t) - y[0]) - 2 * f.damping * f.omega * y[1]};
    }
  };
  num::Dopri5<2> solver{State::Constant(1e-13), 1e-3};
  std::vector<double> out;
  State y{0.3, -2};
  double t = 0;
  for (const double end : times) {
    if (end > t) {
      solver.restart(rate, t, y);
      while (solver.t() < end) REQUIRE(solver.step(rate, end));
      y = solver.y();
      t = end;
    }
    out.push_back(y[0]);
  }
  return out;
}

// Intervals that vary by a factor of 1000 from one to the next.
std::vector<double> uneven_times(int n) {
  const num::RandomSource random{7, 1};
  std::vector<double> t{0};
  for (int k = 1; k < n; ++k)
    t.push_back(t.back() + std::pow(10.0, -3 + 3 * random.uniform(static_cast<std::uint64_t>(k))));
  return t;
}

// The integral of weight(t) input(t) from a to b, and of the weight, by Gauss with 5 points on
// panels.
template <class Weight>
double weighted_mean(const Weight& weight, const std::vector<double>& knots) {
  constexpr std::array<double, 5> x{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                    0.9061798459386640};
  constexpr std::array<double, 5> w{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                    0.4786286704993665, 0.2369268850561891};
  double sum = 0, area = 0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    for (int panel = 0; panel < 64; ++panel)
      for (std::size_t i = 0; i < 5; ++i) {
        const double h = (knots[k + 1] - knots[k]) / 64;
        const double t = knots[k] + h * (panel + 0.5 + 0.5 * x[i]);
        sum += w[i] * h * weight(t) * input(t);
        area += w[i] * h * weight(t);
      }
  return sum / area;
}

}  // namespace

TEST_CASE("C gives the weighted mean over one interval for any speed history") {
  const auto times = uneven_times(40);
  const auto y = analog({f1, 1}, times, true);
  FirstOrderHybrid c{f1};
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double u = c.push(y[k], k == 0 ? 1 : times[k] - times[k - 1]);
    if (k == 0) {
      CHECK(std::isnan(u));
      continue;
    }
    const auto weight = [&](double t) { return std::exp(-f1 * (times[k] - t)); };
    const double a = std::exp(-f1 * (times[k] - times[k - 1]));
    CHECK(u == Approx(weighted_mean(weight, {times[k - 1], times[k]})).margin(2e-11 / (1 - a)));
  }
}

TEST_CASE(
    "G forgets what came before two intervals, for real and complex poles and any speed history") {
  for (const double damping : {1.0, 0.7, 0.2, 0.999999, 1.000001, 3.0, 40.0}) {
    const SecondOrderLowPass f{2, damping};
    const auto times = uneven_times(40);
    const auto y = analog(f, times, false);
    SecondOrderHybrid g{f};
    for (std::size_t k = 0; k < times.size(); ++k) {
      const TwoIntervals u = g.push(y[k], k == 0 ? 1 : times[k] - times[k - 1]);
      if (k < 2) {
        CHECK(std::isnan(u.mean));
        continue;
      }
      const double t0 = times[k - 2], t1 = times[k - 1], t2 = times[k];
      CHECK(u.T_before == t1 - t0);
      CHECK(u.T_after == t2 - t1);
      // Impulse response q, cut off before t0 by construction: q(t2-t) - alpha q(t1-t) = -beta
      // q(t0-t) in between.
      const double s = f.damping * f.omega, split = f.omega * f.omega - s * s;
      const double w = std::sqrt(std::abs(split));
      const auto sine = [&](double t) {
        return split > 0 ? std::sin(w * t) / w : split < 0 ? std::sinh(w * t) / w : t;
      };
      const auto weight = [&](double t) {
        const double late = std::exp(-s * (t2 - t)) * sine(t2 - t);
        return t > t1 ? late
                      : std::exp(-s * (t2 - t)) * sine(t2 - t1) / sine(t1 - t0) * sine(t - t0);
      };
      const double area = 0.5 * (t2 - t1) * (t2 - t0) * f.omega * f.omega;
      CHECK(u.mean == Approx(weighted_mean(weight, {t0, t1, t2}))
                          .epsilon(1e-9)
                          .margin(1e-11 * (1 + (t2 - t1) / (t1 - t0)) / std::min(area, 1.0)));
    }
  }
}

TEST_CASE("A constant passes C and G unchanged, exactly") {
  FirstOrderHybrid c{f1};
  SecondOrderHybrid g{{f1, 1}};
  c.push(0.7, 1);
  g.push(0.7, 1);
  g.push(0.7, 0.3);
  for (const double T : {0.3, 1e-9, 20.0, 1e-3, 1e4, 0.01}) {
    CHECK(c.push(0.7, T) == 0.7);
    CHECK(g.push(0.7, T).mean == 0.7);
  }
}

TEST_CASE("Approximate decays leave what they miss") {
  for (const double kappa : {0.0535, 0.476}) {
    const double a = std::exp(-kappa);
    CHECK(decay(kappa).a == a);
    CHECK(decay(kappa, Decay::linear).a == Approx(1 - kappa));
    CHECK(decay(kappa, Decay::reciprocal).a == Approx(1 / (1 + kappa)));
    CHECK(decay(kappa, Decay::pade11).a == Approx(a).epsilon(kappa * kappa * kappa / 11));
    CHECK(decay(kappa, Decay::pade22).a == Approx(a).epsilon(std::pow(kappa, 5) / 700));
    for (const auto how :
         {Decay::exact, Decay::linear, Decay::reciprocal, Decay::pade11, Decay::pade22})
      CHECK(decay(kappa, how).a + decay(kappa, how).rest == Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("The centroid of the kernel of BC") {
  for (const double kappa : {1e-6, 0.01, 0.29999, 0.30001, 1.0, 10.0}) {
    const auto exact =
        1 / static_cast<long double>(kappa) - 1 / std::expm1(static_cast<long double>(kappa));
    CHECK(centroid_delay(kappa) ==
          Approx(static_cast<double>(exact)).epsilon(kappa < 1e-3 ? 1e-12 : 1e-14));
  }
}

TEST_CASE("Constant acceleration becomes its short chord") {
  // z = t^2/2 with uneven intervals; the low corner is the limit in which D is exact.
  SecondOrderHybrid g{{1e-3, 1}};
  double t = 0, before = 0, now = 0;
  for (const double T : {0.1, 0.1, 0.13, 0.05, 0.2}) {
    const double last = now;
    t += T;
    now = 0.5 * t * t;
    const TwoIntervals a = g.push(1.0, T);
    if (std::isfinite(a.mean)) {
      CHECK(short_chord(a, last - before) == Approx(last - 0.5 * (before + now)).epsilon(1e-12));
    }
    before = last;
  }
}
