// The accuracy that lib/track states of rail, foundation, ties and joints, on seeded inputs over
// its range; exact values in 80-bit arithmetic, by another formula or another method.
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/track/beam_elements.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::track;
using namespace railbook::tests;

namespace {

using Complex = std::complex<Long>;

Long beta_of(const WinklerBeam& b) {
  return std::sqrt(std::sqrt(Long{b.foundation_modulus} / b.bending_stiffness / 4));
}

// EI y'''' + K y = P by its roots: y = P beta/(2 K) Re[(1 - i) exp(-(1 - i) beta |x|)], and its
// derivatives times EI.
struct LongState {
  Long y, slope, moment, shear;
};
LongState point_load(const WinklerBeam& b, Long force, Long x) {
  const Long beta = beta_of(b), side = x > 0 ? 1 : x < 0 ? -1 : 0;
  const Complex r = Complex{-1, 1} * beta;
  const Complex y =
      force * beta / (2 * Long{b.foundation_modulus}) * Complex{1, -1} * std::exp(r * std::abs(x));
  const Long ei = b.bending_stiffness;
  return {y.real(), side * (r * y).real(), -ei * (r * r * y).real(),
          -side * ei * (r * r * r * y).real()};
}

WinklerBeam random_beam(RandomStream& draw) {
  return {draw.decades(1e-6, 1e12), draw.decades(1e-6, 1e14)};
}

// The mean of 1/(C - r) over a period of C = cos(phi), r off [-1, 1]; u = 1 - r is given, where
// nothing cancels.
Complex mean_of_pole(Complex u) {
  Complex root = std::sqrt(-u) * std::sqrt(Complex{2} - u);  // of r^2 - 1
  const Complex r = Complex{1} - u;
  if (std::abs(r + root) < std::abs(r - root)) root = -root;
  return -Long{1} / root;
}

// Over discrete ties by residues. With C = cos(phi), u = 1 - C, the response is N(u)/(48 u^2 + tie
// (12 - 4 u)).
Long tie_ratio(Long b, LoadPlace place) {
  const Long tie = 4 * std::pow(b, Long{4}), k = tie / 12;
  const Complex root = std::sqrt(Complex{k * k / 4 - k * 3});
  const Complex u[] = {k / 2 + root, k / 2 - root};  // u^2 - k u + 3 k = 0
  // N: over the tie 12 - 4 u; at midspan (1 - u/2)(12 - 4u) + 6 u (1 - u/2) + (tie + 24 u) u/32.
  const auto top = [&](Complex v) {
    if (place == LoadPlace::over_tie) return Complex{12} - Long{4} * v;
    const Complex c2 = Complex{1} - v / Long{2}, s2 = v / Long{2};
    return c2 * (Complex{12} - Long{8} * s2) + Long{12} * s2 * c2 +
           (tie + Long{48} * s2) * s2 / Long{16};
  };
  // At midspan the quotient's whole part, -1/192, and the bending of the span between two ties,
  // 1/192, cancel.
  Long y = 0;
  // With C - r_i = u_i - u: sum of N(u_i)/(48 (u_i - u_j)) times the mean of 1/(u - u_i).
  for (int i = 0; i < 2; ++i)
    y += (top(u[i]) / (Long{48} * (u[i] - u[1 - i])) * -mean_of_pole(u[i])).real();
  return 1 / (8 * b * b * b * y);
}

}  // namespace

TEST_CASE("claim: the rail on its foundation") {
  Claim shapes("track::winkler_shapes"), beams("track::WinklerBeam"), state("track::beam_state"),
      felt("track::stiffness_under_wheel"), masses("track::effective_mass"),
      cut("track::cut_on_mass"), frequency("track::cut_on_frequency"),
      speed("track::critical_speed");
  RandomStream draw(11);
  for (int k = 0; k < 1000; ++k) {
    const double xi = draw.decades(1e-12, 700);
    const auto s = winkler_shapes(xi);
    const Long x = xi, e = std::exp(-x);
    for (const auto& [found, exact] :
         {std::pair{s.a, std::cos(x) + std::sin(x)}, std::pair{s.b, std::sin(x)},
          std::pair{s.c, std::cos(x) - std::sin(x)}, std::pair{s.d, std::cos(x)}})
      shapes.error(static_cast<double>(std::abs(found / e - exact)));
    const WinklerBeam beam = random_beam(draw);
    const Long beta = beta_of(beam);
    beams.relative(beam.beta(), beta);
    beams.relative(beam.point_stiffness(),
                   2 * std::sqrt(std::sqrt(4 * Long{beam.bending_stiffness})) *
                       std::pow(std::sqrt(std::sqrt(Long{beam.foundation_modulus})), Long{3}));
    beams.relative(beam.zero_distance(), 3 * long_pi / (4 * beta));
    std::vector<WheelLoad> wheels;
    const int count = 1 + k % 5;
    for (int i = 0; i < count; ++i)
      wheels.push_back({static_cast<double>(draw(-6, 6) / beta), draw.decades(1, 1e6)});
    const double at = static_cast<double>(draw(-8, 8) / beta);
    LongState sum{};
    Long load = 0, under = 0;
    const std::size_t chosen = static_cast<std::size_t>(k) % wheels.size();
    Long size = 0;
    for (const auto& w : wheels) {
      const auto one = point_load(beam, w.force, Long{at} - w.x);
      sum.y += one.y, sum.slope += one.slope, sum.moment += one.moment, sum.shear += one.shear;
      load += w.force;
      const Long here = point_load(beam, w.force, Long{wheels[chosen].x} - w.x).y;
      under += here, size += std::abs(here);
    }
    const auto found = beam_state(beam, wheels, at);
    const Long unit = load * beta / (2 * Long{beam.foundation_modulus});
    state.error(static_cast<double>(std::abs(found.deflection - sum.y) / unit));
    state.error(static_cast<double>(std::abs(found.slope - sum.slope) / (unit * beta)));
    state.error(static_cast<double>(std::abs(found.moment - sum.moment) * beta / load));
    state.error(static_cast<double>(std::abs(found.shear - sum.shear) / load));
    const Long stiffness = wheels[chosen].force / under;
    felt.error(static_cast<double>(
        std::abs((stiffness_under_wheel(beam, wheels, chosen) / stiffness - 1) * under / size)));
    const double rho = draw.decades(1e-3, 1e6), b = draw.decades(1e-3, 1e3);
    masses.relative(effective_mass(rho, b), 3 * Long{rho} / (2 * Long{b}));
    cut.relative(cut_on_mass(rho, b), 2 * Long{rho} / b);
    const Long w0 = std::sqrt(Long{beam.foundation_modulus} / rho);
    frequency.relative(cut_on_frequency(beam, rho), w0);
    // The smallest phase speed is at k = sqrt(2) beta: sqrt((EI k^4 + K)/rho)/k.
    const Long wave = std::sqrt(Long{2}) * beta;
    speed.relative(critical_speed(beam.bending_stiffness, beam.foundation_modulus, rho),
                   std::sqrt((Long{beam.bending_stiffness} * std::pow(wave, Long{4}) +
                              beam.foundation_modulus) /
                             rho) /
                       wave);
  }
}

TEST_CASE("claim: the deflection by Fourier's integral where it says converged") {
  Claim claim("track::deflection_by_fourier");
  RandomStream draw(12);
  for (int k = 0; k < 1000; ++k) {
    const WinklerBeam beam = random_beam(draw);
    const double x = draw(0, 4) / beam.beta(), asked = 1e-8;
    const auto found = deflection_by_fourier(beam, 1e5, x, asked);
    if (!found.converged) continue;
    const auto exact = point_load(beam, 1e5, x);
    claim.error(
        static_cast<double>(std::abs(found.value - exact.y) * beam.point_stiffness() / 1e5));
  }
}

TEST_CASE("claim: elements of the beam and ties") {
  Claim exact("track::exact_element"), cubic("track::cubic_element"),
      ties("track::discrete_tie_ratio");
  RandomStream draw(13);
  for (int k = 0; k < 1000; ++k) {
    // The shapes exp(+-(1 +- i) lambda x) of an element of length 1: the forces that hold each,
    // over its end motions.
    const double lambda = k % 2 == 0 ? draw.decades(1e-6, 3e2) : draw.decades(0.3, 3),
                 ei = draw.decades(1e-3, 1e9), h = draw.decades(1e-3, 1e3);
    const double modulus = 4 * ei * std::pow(lambda / h, 4);
    const Long l = std::sqrt(std::sqrt(Long{modulus} / ei / 4)) * h;
    const auto found = exact_element(ei, modulus, h), hermite = cubic_element(ei, modulus, h);
    const Long b = Long{ei} / (Long{h} * h * h);
    // Coefficients from sums without differences: power series of x^n/n! to l = 1.5, hyperbolic
    // functions above.
    Long delta = 0, f5 = 0, f6 = 0, e = 1, sh = std::sinh(l), ch = std::cosh(l);
    if (l < 1.5L) {
      Long twice = 4 * l * l * l / 3, once = l * l * l / 6,
           sign = 4;  // (2 l)^n/n!, l^n/n!, 4 (-4)^j
      for (int n = 3; n < 43; n += 4, sign *= -4) {
        f5 += twice, f6 += sign * once, delta += twice * 2 * l / (n + 1);
        for (int i = n + 1; i <= n + 4; ++i) twice *= 2 * l / i, once *= l / i;
      }
    }
    if (l > 100) e = std::exp(-l), sh = ch = 0.5L;  // all over exp(2 l)
    const Long s = std::sin(l), c = std::cos(l), e2 = l > 100 ? e * e : 1;
    if (l >= 1.5L)
      delta = sh * sh - s * s * e2, f5 = sh * ch - s * c * e2, f6 = e * (ch * s - sh * c);
    const Long f1 = sh * ch + s * c * e2, f2 = sh * sh + s * s * e2, f3 = e * (ch * s + sh * c),
               f4 = e * sh * s;
    const Long g = 2 * b * l / delta;
    const Long size[2] = {2 * g * l * l * f1, g * h * Long{h} * f5};
    const Long want[4][4] = {
        {2 * g * l * l * f1, g * l * h * f2, -2 * g * l * l * f3, 2 * g * l * h * f4},
        {0, g * h * h * f5, -2 * g * l * h * f4, g * h * h * f6},
        {0, 0, 2 * g * l * l * f1, -g * l * h * f2},
        {0, 0, 0, g * h * h * f5}};
    const Long f = Long{modulus} * h / 420, hh = h;
    const Long plain[4][4] = {
        {12 * b + 156 * f, (6 * b + 22 * f) * hh, -12 * b + 54 * f, (6 * b - 13 * f) * hh},
        {0, (4 * b + 4 * f) * hh * hh, (-6 * b + 13 * f) * hh, (2 * b - 3 * f) * hh * hh},
        {0, 0, 12 * b + 156 * f, -(6 * b + 22 * f) * hh},
        {0, 0, 0, (4 * b + 4 * f) * hh * hh}};
    for (int i = 0; i < 4; ++i)
      for (int j = i; j < 4; ++j) {
        const Long scale = std::sqrt(size[i % 2] * size[j % 2]);
        exact.error(static_cast<double>(std::abs(found(i, j) - want[i][j]) / scale));
        const Long other = std::sqrt(plain[i % 2][i % 2] * plain[j % 2][j % 2]);
        cubic.error(static_cast<double>(std::abs(hermite(i, j) - plain[i][j]) / other));
        REQUIRE(found(i, j) == found(j, i));
      }
    const double spacing = k % 10 == 0 ? draw.decades(1e-3, 50) : draw.decades(0.05, 50);
    const LoadPlace place = k % 20 < 10 ? LoadPlace::over_tie : LoadPlace::midspan;
    ties.relative(discrete_tie_ratio(spacing, place), tie_ratio(spacing, place));
  }
}

TEST_CASE("claim: joints, and rails cut and linked by elements") {
  Claim deflection("track::jointed_deflection"), solved("track::solve_beam"),
      ratio("track::joint_stiffness_ratio"), loss("track::rotational_stiffness_for_loss"),
      paper("track::paper_joint_ratio"), worst("track::paper_joint_error"),
      best("track::best_joint_factor");
  RandomStream draw(14);
  for (int k = 0; k < 1000; ++k) {
    const WinklerBeam beam = random_beam(draw);
    const Long beta = beta_of(beam), ei = beam.bending_stiffness;
    const auto spring = [&](Long own) {
      const double pick = draw(0, 4);
      return pick < 1 ? 0.0 : pick < 2 ? rigid : static_cast<double>(own) * draw.decades(1e-8, 1e8);
    };
    const Joint joint{spring(beta * beta * beta * ei), spring(beta * ei)};
    const double at = static_cast<double>(draw(-4, 4) / beta),
                 x = static_cast<double>(draw(-4, 4) / beta);
    // The unjointed rail's moment and shear at the joint open a kink and a step, which raise x as a
    // load there would them.
    const auto here = point_load(beam, 1, std::abs(Long{at})),
               there = point_load(beam, 1, std::abs(Long{x}));
    const Long side = (at < 0) == (x < 0) ? 1 : -1;
    const Long exact =
        point_load(beam, 1, Long{x} - at).y +
        here.moment * there.moment / (joint.rotational_stiffness + beta * ei / 2) +
        side * here.shear * there.shear / (joint.shear_stiffness + beta * beta * beta * ei);
    const Long unit = beta / (2 * Long{beam.foundation_modulus});
    deflection.error(
        static_cast<double>(std::abs(jointed_deflection(beam, joint, 1, at, x) - exact) / unit));

    // The same rail by elements of beta h >= 0.1, 40 from the joint to each free end.
    if (k % 4 == 0) {
      std::vector<double> nodes{
          -40, -8, at * static_cast<double>(beta), x * static_cast<double>(beta), 0, 8, 40};
      std::sort(nodes.begin(), nodes.end());
      bool close = false;
      for (std::size_t i = 1; i < nodes.size(); ++i) close |= nodes[i] - nodes[i - 1] < 0.1;
      if (!close) {
        BeamModel model{.bending_stiffness = beam.bending_stiffness,
                        .foundation_modulus = beam.foundation_modulus,
                        .x = Eigen::VectorXd(7)};
        Eigen::Index load = 0;
        for (Eigen::Index i = 0; i < 7; ++i) {
          model.x(i) = static_cast<double>(nodes[static_cast<std::size_t>(i)] / beta);
          if (nodes[static_cast<std::size_t>(i)] == at * static_cast<double>(beta)) load = i;
          if (nodes[static_cast<std::size_t>(i)] == 0) model.joints = {{i, joint}};
        }
        const auto found = solve_beam(model, {{load, 1.0}});
        for (Eigen::Index i = 1; i < 6; ++i)
          solved.error(static_cast<double>(
              std::abs(found.deflection(i) -
                       jointed_deflection(beam, joint, 1, model.x(load), model.x(i))) /
              unit));
      }
    }

    const double xi = draw.decades(1e-6, 30), m = draw(0, 1), v = draw(0, 1);
    const Long wave = std::exp(-Long{xi});
    const Long c = wave * (std::cos(Long{xi}) - std::sin(Long{xi})), d = wave * std::cos(Long{xi});
    ratio.relative(joint_stiffness_ratio(xi, m, v), 1 / (1 + m * c * c + 2 * v * d * d));
    const double lost = k % 2 == 0 ? draw.decades(1e-9, 0.5) : 0.5 - draw.decades(1e-15, 0.1);
    loss.relative(rotational_stiffness_for_loss(beam, lost),
                  beta * ei / 2 * (1 - 2 * Long{lost}) / lost);
    const double delta = draw.decades(1e-6, 1), factor = draw(0.3, 2);
    const Long sine = factor * Long{xi} < long_pi / 2 ? std::sin(factor * Long{xi}) : 1;
    paper.relative(paper_joint_ratio(xi, delta, factor),
                   delta * (1 - sine) * (1 - sine) + sine * (2 - sine));
    // No place of a scan deviates more, and the deviation is that of the place.
    const auto fit = paper_joint_error(delta, m, v, factor);
    const auto off = [&](double at_xi, double by) {
      return paper_joint_ratio(at_xi, delta, by) - joint_stiffness_ratio(at_xi, m, v);
    };
    double most = 0;
    for (int i = 0; i <= 300; ++i) most = std::max(most, std::abs(off(4.0 * i / 300, factor)));
    worst.error(std::max(std::abs(fit.error - off(fit.xi, factor)), most - std::abs(fit.error)));
    if (k % 50 == 0) {
      const double chosen = best_joint_factor(delta, m, v);
      const double least = std::abs(paper_joint_error(delta, m, v, chosen).error);
      for (int i = 0; i < 50; ++i)
        best.error(least - std::abs(paper_joint_error(delta, m, v, draw(0.3, 2)).error));
    }
  }
}
