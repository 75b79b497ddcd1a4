#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

#include "items.hpp"
#include "num/gsl.hpp"
#include "num/quadrature.hpp"
#include "track/beam_elements.hpp"
#include "track/moving_load.hpp"
#include "track/typical_track.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// What a case that must be refused says; "not refused" is the failure.
std::string refusal(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const InputError& error) {
    return error.what();
  } catch (const num::NumericalError& error) {
    return error.what();
  }
  return "not refused";
}

const char* refused(const std::string& text) {
  return text == "not refused" ? "fails" : "refused";
}
const char* holds(double error, double allowed) {
  return error <= allowed ? "holds" : "fails";
}

// k_b of a pyramid in inches and psi, eq. (6) rearranged, against the integral over its slices.
void ballast_case(report::Item& item, const char* id, const char* what, double length, double width,
                  double depth, double degrees) {
  const double slope = 2 * std::tan(degrees * units::degree), modulus = 30000;
  const double ours = ballast_compliance(length, width, depth, modulus, degrees * units::degree);
  const auto slice = [&](double z) {
    return 1 / (modulus * (length + slope * z) * (width + slope * z));
  };
  const double quadrature = num::integrate(slice, 0, depth, 1e-13).value;
  const double error = std::abs(ours / quadrature - 1);
  item.stability(id, what, "eq. (6) as printed is 0/0 there, or loses digits",
                 fmt::format("k_b = {:.8g} lb/in", 1 / ours), error, holds(error, 1e-12));
}

void ballast(report::Item& item) {
  ballast_case(item, "ballast-square", "l = w = 9 in", 9, 9, 12, 20);
  ballast_case(item, "ballast-near-square", "l = w (1 + 1e-12)", 9 * (1 + 1e-12), 9, 12, 20);
  ballast_case(item, "ballast-vertical", "alpha = 0", 30, 9, 12, 0);
  ballast_case(item, "ballast-near-vertical", "alpha = 1e-10 degrees", 30, 9, 12, 1e-10);
  ballast_case(item, "ballast-narrow", "l < w", 9, 30, 12, 20);
  const double none_left = ballast_compliance(30, 9, 0, 30000, 20 * units::degree);
  item.stability("ballast-none", "h = 0, tie on the soil", "k_b must become rigid, 1/k_b zero",
                 fmt::format("1/k_b = {}", none_left), none_left, holds(none_left, 0));
}

void chain_cases(report::Item& item) {
  auto support = typical_support();
  support.tie_stiffness = rigid;
  const double dropped = stiffness_chain(support).seat;
  support.tie_stiffness = 1e40;
  const double error = std::abs(stiffness_chain(support).seat / dropped - 1);
  item.stability(
      "rigid-tie", "rigid pad and rigid tie", "infinite stiffness in (4): no inf - inf",
      fmt::format("the term drops; k = {:.1f} lb/in", dropped / units::lbf * units::inch), error,
      holds(error, 1e-14));
  const auto massless = refusal([&] {
    support.tie_stiffness = rigid;
    (void)rail_beta(typical_rail().bending_stiffness(), support);
  });
  item.stability("rigid-seat", "rigid pad and rigid tie in (17)", "beta_o -> inf, M_rail -> 0",
                 massless, none, refused(massless));
  support.soil_modulus = support.ballast_modulus = rigid;
  const auto all = refusal([&] { (void)stiffness_chain(support); });
  item.stability("rigid-all", "everything rigid", "1/k = 0", all, none, refused(all));
}

void foundation_cases(report::Item& item) {
  // K_r ~ K^(3/4) over 200 decades, and a rail whose cut follows 1/beta.
  const double ei = typical_rail().bending_stiffness();
  double worst = 0;
  for (double k = 1e-200; k < 1e6; k *= 1e10)
    worst = std::max(worst, std::abs(WinklerBeam{ei, k}.point_stiffness() /
                                         WinklerBeam{ei, k * 1e-4}.point_stiffness() -
                                     1e3) /
                                1e3);
  item.stability("soft", "K from 1e6 down to 1e-200 Pa", "K^3 in eq. (2) as printed underflows",
                 "K_r follows K^(3/4) throughout, by 2 K / beta", worst, holds(worst, 1e-13));
  double slowest = 0;
  for (double k = 1e-200; k < 1e6; k *= 1e10) {
    const double rho = typical_rail().mass_per_length;
    const double ratio = critical_speed(ei, k, rho) / critical_speed(ei, k * 1e-4, rho);
    slowest = std::max(slowest, std::abs(ratio / 10 - 1));
  }
  item.stability("soft-critical", "the same K in eq. (9)", "critical speed goes to zero",
                 "V_c follows K^(1/4) throughout", slowest, holds(slowest, 1e-13));
  const WinklerBeam soft{ei, 1.0};
  const auto cut = [&](double end) {
    const BeamModel model{.bending_stiffness = ei,
                          .foundation_modulus = soft.foundation_modulus,
                          .x = Eigen::VectorXd{{-end, 0.0, end}}};
    return std::abs(solve_beam(model, {{1, 1.0}}).deflection(1) * soft.point_stiffness() - 1);
  };
  item.stability("soft-cut", "K = 1 Pa, rail of fixed 200 m by elements",
                 "ample at 1500 psi (beta L = 76), now shorter than the wave",
                 fmt::format("1/beta = {:.0f} m; the free ends are felt", 1 / soft.beta()),
                 cut(100), "degraded");
  const double error = cut(14 / soft.beta());
  item.stability("soft-follow", "the same, cut at beta L = 14", "length must follow 1/beta",
                 fmt::format("{:.0f} m a side", 14 / soft.beta()), error, holds(error, 1e-10));
  const auto none_at_all = refusal([&] { (void)require_valid(WinklerBeam{ei, 0.0}); });
  item.stability("no-foundation", "K = 0", "nothing holds the rail", none_at_all, none,
                 refused(none_at_all));
}

void element_cases(report::Item& item) {
  const auto beam = typical_beam();
  const auto by_elements = [&](int n) {
    const double end = 14 / beam.beta();
    const BeamModel model{.bending_stiffness = beam.bending_stiffness,
                          .foundation_modulus = beam.foundation_modulus,
                          .x = Eigen::VectorXd::LinSpaced(2 * n + 1, -end, end)};
    return std::abs(solve_beam(model, {{n, 1.0}}).deflection(n) * beam.point_stiffness() - 1);
  };
  item.stability("over-refined", "exact elements of beta h = 0.003",
                 "condition of the stiffness matrix, (beta h)^-4",
                 "rounding; the same rail with two elements has the digits of the cut",
                 by_elements(5000), "degraded");
  const double two = by_elements(1);
  item.stability("long-element", "exact elements of beta h = 14", "sinh(14)^2 over and under",
                 "scaled by e^(-2 beta h): no overflow at any length", two, holds(two, 1e-10));
  for (const double b : {2.0, 5.0}) {
    const double ratio = discrete_tie_ratio(b, LoadPlace::over_tie);
    item.stability(
        fmt::format("wide-ties-{:.0f}", b), fmt::format("beta l_t = {:.0f}", b),
        "ties too far apart for a continuous foundation",
        fmt::format("eq. (2) too soft over a tie by a factor of {:.3f}; beta l_t / 2 in the "
                    "end. The elements stay exact",
                    ratio),
        std::abs(1 / ratio - 1), "degraded");
  }
  const BeamModel loose{.bending_stiffness = 5e6,
                        .x = Eigen::VectorXd{{0.0, 1.0, 2.0}},
                        .spring = Eigen::VectorXd{{0.0, 1e7, 0.0}}};
  const auto mechanism = refusal([&] { (void)solve_beam(loose, {{1, 1e5}}); });
  item.stability("mechanism", "a rail on one tie", "rigid rotation: a singular matrix", mechanism,
                 none, refused(mechanism));
}

void joint_cases(report::Item& item) {
  const auto beam = typical_beam();
  double worst = 0;
  for (double k = 1e-300; k < 1e300; k *= 1e10) {
    const double ratio = joint_stiffness_ratio(beam, Joint{k, k}, 0.0);
    worst = std::max({worst, 0.25 - ratio, ratio - 1.0});
  }
  item.stability("joint-springs", "joint springs from 1e-300 to 1e300",
                 "overflow in the ratios of springs", "K_j/K_r stays between 1/4 and 1", worst,
                 holds(worst, 1e-15));
  const double xi = 12.0;
  const auto far = deflection_by_fourier(beam, beam.point_stiffness(), xi / beam.beta(), 1e-8);
  item.stability(
      "fourier-far", "Fourier integral at beta X = 12",
      "a result of 2e-6 from an integrand of order one that oscillates",
      far.converged ? "reaches 1e-8 of itself" : "quadrature says that it did not converge",
      std::abs(far.value / winkler_shapes(xi).a - 1), far.converged ? "holds" : "refused");
}

/***
Towards a square loading area the printed equation (6) loses its digits long before it divides zero by zero; the
rearranged form does not:

{{static-extremes}}
*/

// Relative error of a ballast stiffness against the slices of the pyramid, added up.
void near_square(report::Item& item) {
  item.columns({"l / w - 1", "error of (6) as printed", "error of the rearranged form"});
  const double width = 9, depth = 12, modulus = 30000, angle = 20 * units::degree;
  const double slope = 2 * std::tan(angle);
  item.reconstructed("not in the paper: our own comparison");
  item.expect_checks(5);
  for (const double gap : {1e-2, 1e-5, 1e-8, 1e-11, 1e-14}) {
    const double length = width * (1 + gap);
    const auto slice = [&](double z) {
      return 1 / (modulus * (length + slope * z) * (width + slope * z));
    };
    const double reference = 1 / num::integrate(slice, 0, depth, 1e-13).value;
    const double printed =
        slope * (length - width) * modulus /
        std::log(length * (width + slope * depth) / (width * (length + slope * depth)));
    const double ours = 1 / ballast_compliance(length, width, depth, modulus, angle);
    const auto error = [&](double k) {
      const double e = std::abs(k / reference - 1);
      return e == 0 ? std::string("0") : fmt::format("{:.1e}", e);
    };
    item.add_row({fmt::format("{:.0e}", gap), error(printed), error(ours)});
    item.agree(fmt::format("k_b-{:.0e}", gap), fmt::format("k_b at l/w - 1 = {:.0e}", gap), "lb/in",
               ours, reference, 1e-13, "slices of the pyramid, integrated");
  }
  ballast(item);
  chain_cases(item);
  foundation_cases(item);
  element_cases(item);
  joint_cases(item);
}

}  // namespace

void track_chapter::add_static_extremes(report::Chapter& chapter) {
  chapter.table("static-extremes", "Equation (6) near a square loading area", near_square);
}
