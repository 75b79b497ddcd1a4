// Closed orbits, their stability and their harmonics against oscillators whose cycle is known in
// closed form: of any size and pace, stable and unstable, lopsided, grazing a kink, critically
// damped, with other coordinates that ride along.
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include <railbook/cycles/multipliers.hpp>
#include <railbook/vehicle/refine_cycle.hpp>

#include "support/claim.hpp"
#include "support/exact_cycle.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using namespace railbook::tests;
using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// An exact cycle as the first of n coordinates in disguise: q = S p, p_0 the cycle's, the others
// damped springs that it drives.
struct Disguised {
  ExactCycle cycle;
  double size, pace, push;
  bool backwards;          // run backwards in time, so that it repels
  MatrixXd mixing, rides;  // S; stiffness, damping and drive of each that rides
  Oscillator oscillator;
  VectorXd row;                      // p_0 of q
  std::vector<Complex> multipliers;  // over a period, 1 left out

  double period() const { return static_cast<double>(cycle.period) / pace; }
  double amplitude() const { return static_cast<double>(cycle.amplitude()) * size; }
  // p_0 and its rate.
  Eigen::Vector2d at(double share) const {
    const Long t = cycle.period * share;
    const auto p = cycle.at(backwards ? -t : t);
    return {size * static_cast<double>(p.q) + push,
            (backwards ? -1 : 1) * size * pace * static_cast<double>(p.v)};
  }
};

struct Draft {
  Eigen::Index n = 1;
  bool symmetric = true, backwards = false, scaled = true;
  double inner_to = 10, outer_to = 100;  // of the pace; from 1e-3
};

Disguised disguised(RandomStream& draw, const Draft& draft) {
  // One in five is damped critically beyond the kink.
  const double share_of_critical = draw(0, 1), inner = draw.decades(1e-3, draft.inner_to),
               any = draw.decades(1e-3, draft.outer_to),
               outer = share_of_critical < 0.2 && draft.outer_to > 2 ? 2 : any,
               left = draft.symmetric ? 1 : draw.decades(1, 3);
  Disguised d{ExactCycle(1, inner, outer, left, 1),
              draft.scaled ? draw.decades(1e-12, 1e6) : 1,
              draft.scaled ? draw.decades(1e-2, 1e3) : 1,
              0,
              draft.backwards,
              {},
              {},
              {},
              {},
              {}};
  const Eigen::Index n = draft.n;
  const double turn = draft.backwards ? -1 : 1;
  // p_0'' + pace^2 p_0 + f(p_0') = push.
  const double v = d.size * d.pace;
  if (!draft.symmetric) d.push = draw(-30, 30) * d.size;
  const double up = (draft.backwards ? left : 1) * v, down = (draft.backwards ? 1 : left) * v,
               in = turn * inner * d.pace, out = turn * outer * d.pace;
  Eigen::Vector4d knots{-down - v, -down, up, up + v};
  Eigen::RowVector4d values{in * down - out * v, in * down, -in * up, -in * up + out * v};
  values.array() -= d.push * d.pace * d.pace;
  MatrixXd stiffness = MatrixXd::Zero(n, n), damping = stiffness;
  stiffness(0, 0) = d.pace * d.pace;
  const double T = d.period();
  d.multipliers = {turn > 0 ? static_cast<double>(d.cycle.multiplier)
                            : static_cast<double>(1 / d.cycle.multiplier)};
  double w = 1, zeta = 1;
  for (Eigen::Index j = 1; j < n; ++j) {
    // All that ride have the same pace: twins among the multipliers.
    if (j < 2) w = d.pace * draw.decades(0.3, 3), zeta = draw(0.05, 0.9);
    stiffness(j, j) = w * w, damping(j, j) = 2 * zeta * w;
    stiffness(j, 0) = draw(-1, 1) * d.pace * d.pace;
    const Complex rate{-zeta * w, w * std::sqrt(1 - zeta * zeta)};
    d.multipliers.push_back(std::exp(rate * T));
    d.multipliers.push_back(std::conj(d.multipliers.back()));
  }
  d.mixing = MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) d.mixing(i, j) += n > 1 ? draw(-0.4, 0.4) : 0.0;
  const MatrixXd back = d.mixing.inverse();
  const double share = draw(0, 1), slowness = draw.decades(0.01, 1);
  d.row = back.row(0).transpose();
  d.oscillator = {back.transpose() * back,
                  share * back.transpose() * damping * back,
                  (1 - share) / slowness * back.transpose() * damping * back,
                  back.transpose() * stiffness * back,
                  slowness,
                  {},
                  {}};
  d.oscillator.channels.push_back({d.row, true, -d.row, {knots, values}});
  return d;
}

// Where it goes round: p_0 in closed form, those that ride by their Fourier series.
VectorXd start_of(const Disguised& d, double share) {
  const Eigen::Index n = d.oscillator.coordinates();
  const MatrixXd back = d.mixing.inverse();
  MatrixXd stiffness = d.mixing.transpose() * d.oscillator.stiffness * d.mixing,
           damping =
               d.mixing.transpose() *
               (d.oscillator.damping + d.oscillator.inverse_speed * d.oscillator.damping_by_speed) *
               d.mixing;
  const Eigen::Vector2d first = d.at(share);
  VectorXd p = VectorXd::Zero(n), v = p;
  p[0] = first[0], v[0] = first[1];
  if (n > 1) {
    const int samples = 1024;
    const double w = 2 * units::pi / d.period();
    std::vector<double> drive;
    for (int j = 0; j < samples; ++j) drive.push_back(d.at(double(j) / samples)[0]);
    for (int k = 0; k <= 60; ++k) {
      Complex c = 0;
      for (int j = 0; j < samples; ++j)
        c += drive[std::size_t(j)] * std::polar(1.0, -2 * units::pi * k * j / samples);
      c *= (k == 0 ? 1.0 : 2.0) / samples;
      for (Eigen::Index j = 1; j < n; ++j) {
        const Complex x = -stiffness(j, 0) * c /
                          Complex{stiffness(j, j) - k * w * k * w, k * w * damping(j, j)} *
                          std::polar(1.0, 2 * units::pi * k * share);
        p[j] += x.real(), v[j] += (Complex{0, k * w} * x).real();
      }
    }
  }
  VectorXd y(2 * n);
  y << d.mixing * p, d.mixing * v;
  return y;
}

// The largest distance of an exact multiplier from the nearest found, relative to 1 or its size.
double mismatch(const std::vector<Complex>& exact, const std::vector<Complex>& found) {
  double worst = 0;
  for (const Complex m : exact) {
    double nearest = 1e300;
    for (const Complex other : found) nearest = std::min(nearest, std::abs(other - m));
    worst = std::max(worst, nearest / std::max(1.0, std::abs(m)));
  }
  return worst;
}

// How far p_0 and its rate are from the exact cycle, relative to its size, at the best phase near a
// share of it.
double off_cycle(const Disguised& d, const VectorXd& y, double& share) {
  const Eigen::Index n = d.oscillator.coordinates();
  const Eigen::Vector2d found{d.row.dot(y.head(n)), d.row.dot(y.tail(n))},
      unit{d.amplitude(), d.amplitude() * d.pace};
  Eigen::Vector2d off;
  for (int k = 0; k < 20; ++k) {
    constexpr double h = 1e-7;
    const Eigen::Vector2d along = (d.at(share + h) - d.at(share - h)).cwiseQuotient(2 * h * unit);
    off = (found - d.at(share)).cwiseQuotient(unit);
    share += std::clamp(off.dot(along) / along.squaredNorm(), -0.02, 0.02);
  }
  off = (found - d.at(share)).cwiseQuotient(unit);
  return off.norm();
}

}  // namespace

TEST_CASE("claim: closed orbits", "[thorough]") {
  Claim closed("cycles::shoot"), series("cycles::harmonics"), verdict("cycles::stability"),
      in("cycles::padded"), out("cycles::unpadded");
  RandomStream draw(1);
  for (int k = 0; k < 1000; ++k) {
    Draft draft{.n = 1 + k % 3, .symmetric = k % 4 < 2, .backwards = k % 2 == 1};
    // Shooting needs a start whose digits are not lost within a period.
    if (draft.backwards) draft.inner_to = draft.outer_to = 1;
    const Disguised d = disguised(draw, draft);
    double share = draw(0, 1);
    const VectorXd start = start_of(d, share);
    const Orbit o = shoot(d.oscillator, start * (1 + 1e-3), d.period() * (1 + 1e-3),
                          {.symmetric = draft.symmetric});
    REQUIRE(o.converged);
    // What hardly attracts or repels is hardly held in place.
    const double m = d.multipliers[0].real(), hold = std::min(1.0, std::abs(1 - m)),
                 whole = 1 + std::abs(d.push) / d.amplitude();
    closed.error(std::abs(o.period / d.period() - 1) * hold);
    closed.error(off_cycle(d, o.y, share) * hold / whole);
    closed.error(std::abs(amplitude(d.oscillator, o, d.row) / d.amplitude() - 1) * hold / whole);
    const FloquetStability s = stability(o);
    double largest = 0;
    for (const Complex x : d.multipliers) largest = std::max(largest, std::abs(x));
    verdict.error(mismatch(d.multipliers, o.multipliers));
    verdict.error(std::abs(s.largest - largest) / std::max(1.0, largest));
    CHECK(s.stable == (largest < 1));
    if (!s.stable) CHECK(s.loss == "fold");
    const State wide = padded(start);
    in.error((wide.head(draft.n) - start.head(draft.n)).norm() +
             (wide.segment(9, draft.n) - start.tail(draft.n)).norm() +
             wide.segment(draft.n, 9 - draft.n).norm() + wide.tail(9 - draft.n).norm());
    out.error((unpadded(wide, draft.n) - start).norm());
    if (k % 5 != 0) continue;
    const Cycle c = harmonics(d.oscillator, o, 15);
    for (const std::size_t j : {0U, 1U, 2U, 4U, 7U}) {
      constexpr int samples = 2048;
      Complex sum = 0;
      for (int i = 0; i < samples; ++i)
        sum += d.at(share + static_cast<double>(i) / samples)[0] *
               std::polar(1.0, -2 * units::pi * c.orders[j] * i / samples);
      sum *= (c.orders[j] == 0 ? 1.0 : 2.0) / samples;
      series.error(
          std::abs(d.row.cast<Complex>().dot(c.motion.col(static_cast<Eigen::Index>(j))) - sum) /
          (d.amplitude() * whole));
    }
  }
}

TEST_CASE("claim: cycles of harmonics and their stability", "[thorough]") {
  Claim balanced("cycles::balance", 297), examined("vehicle::refine_cycle", 890),
      odd("cycles::is_odd", 300), rates("cycles::multipliers", 297),
      hill("cycles::hill_exponent", 147);
  RandomStream draw(2);
  int lost = 0;
  for (int k = 0; k < 300; ++k) {
    Draft draft{.n = 1 + k % 3, .symmetric = k % 4 < 2, .backwards = k % 2 == 1};
    draft.inner_to = draft.outer_to = draft.backwards ? 1 : 3;
    const Disguised d = disguised(draw, draft);
    const double T = d.period(), m = d.multipliers[0].real();
    const Orbit o = shoot(d.oscillator, start_of(d, draw(0, 1)), T, {.symmetric = draft.symmetric});
    REQUIRE(o.converged);
    const Cycle c = harmonics(d.oscillator, o, 63);
    odd.error(is_odd(c) == draft.symmetric ? 0 : 1);
    Cycle start = with_orders(c, 23, !draft.symmetric);
    start.motion *= 1 + draw(-0.02, 0.02);
    const Cycle found = balance(d.oscillator, start);
    const RefinedCycle e = refine_cycle(d.oscillator, start);
    if (!found.converged || !e.converged) {
      // A start within the straight piece meets no force to balance, and both say so.
      CHECK_FALSE((found.reason.empty() && e.reason.empty()));
      ++lost;
      continue;
    }
    balanced.error(std::abs(found.omega * T / (2 * units::pi) - 1));
    const double hold = std::min(1.0, std::abs(1 - m)),
                 whole = 1 + std::abs(d.push) / d.amplitude();
    examined.error(std::abs(e.omega * T / (2 * units::pi) - 1) * hold);
    examined.error(std::abs(e.amplitude / d.amplitude() - 1) * hold / whole);
    examined.error(mismatch(d.multipliers, e.orbit.multipliers));
    Multipliers found_rates = multipliers(d.oscillator, c);
    for (Complex& x : found_rates.map) x = found_rates.symmetric ? x * x : x;
    const double h = T / (draft.symmetric ? 512 : 256) * d.pace *
                     static_cast<double>(1 + d.cycle.inner + d.cycle.outer);
    rates.error(mismatch(d.multipliers, found_rates.map) / (h * h));
    if (!draft.symmetric) continue;
    const Complex exact = std::log(m) / T;
    const HillExponent exponent = hill_exponent(d.oscillator, c, exact * 1.02, 63);
    REQUIRE(exponent.converged);
    hill.error(std::abs(exponent.value - exact) / d.pace);
  }
  CHECK(lost <= 3);
}
