/*** ## Can the stated error be trusted?

Yes, as a bound: CG-FFT states an error of the force and of the peak, and the true one was smaller
in {{estimates-force-covered}} forces and {{estimates-peak-covered}} peaks. For this test {{drawn}}
contacts with a closed form were drawn at random: Hertz's of any slenderness, along the axes and
turned, and punches with rounded edges, on 32 to 48 cells a side. None of them has a jump of the
radius, for which there is no closed form. On the jump and the stamp of the tables above, on 24 to
255 cells, the true error is below the stated one in {{stated-force}} forces and in {{stated-peak}}
peaks for which the solver states one; for the other peaks it says that the edge is under-resolved. The solver called {{estimates-force-unresolved}} of the
{{drawn}} *under-resolved*, that is with too few cells to state a force, and
{{estimates-peak-unresolved}} for the peak. The figures show the others. The stated error
is more than ten times the true one in {{estimates-force-wide}} of the forces and
{{estimates-peak-wide}} of the peaks.

{{estimates-force}}

{{estimates-peak}}

## How many digits do the closed forms have?

The closed forms against extended precision (80 bits), at {{arguments}} arguments each. $b/a$ is the
ratio of the half-widths of Hertz's ellipse, $\mathrm K$ and its part $\mathrm K_a$ are the elliptic
integrals of his formulas, $r$ is the distance from the middle of a disc of radius $c$, and $(x,y)$
the corner of a cell:

{{digits}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/bench/evidence.hpp>
#include <railbook/contact/influence.hpp>
#include <railbook/num/parallel.hpp>

#include "method/punch.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

struct Runs {
  std::vector<bench::Estimate> force, peak;
  // Keeps what the solver gave a number for.
  void add(const std::string& label, const NormalContact& c, double exact_force,
           double exact_peak) {
    if (std::isfinite(c.force_error))
      force.push_back({label, c.force_error, std::abs(c.force / exact_force - 1)});
    if (std::isfinite(c.p_max_error))
      peak.push_back({label, c.p_max_error, std::abs(c.p_max / exact_peak - 1)});
  }
};

// Case k of contacts of closed form, one of three kinds in turn.
Runs contact(std::size_t k) {
  Runs runs;
  bench::RandomStream draw{1, k};
  CgFftOptions options;
  options.nx = static_cast<Eigen::Index>(draw(32, 49)),
  options.ny = static_cast<Eigen::Index>(draw(32, 49));
  if (k % 3 == 2) {
    const RoundedPunch shape{0.5, draw.decades(0.01, 100)};
    const PunchContact exact = punch_from_approach(shape, 1, 1e-3);
    runs.add(fmt::format("punch {:.3g}", shape.edge_radius),
             solve_cg_fft(rounded_punch_gap(shape), 1e-3, 1, options).contact, exact.force,
             punch_peak(exact).pressure);
  } else {
    const bool turned = k % 3 == 1;
    const RelativeCurvature curvature{1, draw.decades(1, turned ? 1e2 : 1e8),
                                      turned ? draw(0, units::pi) : 0};
    const HertzContact exact = hertz_from_approach(curvature, 1, 1e-4);
    runs.add(fmt::format("Hertz {:.3g}", curvature.b),
             solve_cg_fft(quadratic_gap(curvature), 1e-4, 1, options).contact, exact.force,
             exact.p_max);
  }
  return runs;
}

std::size_t drawn(const report::Item& item) {
  return item.full() ? 20000 : 600;
}

Runs sweep(std::size_t cases) {
  Runs all;
  for (const Runs& one : num::map_in_parallel(cases, contact)) {
    all.force.insert(all.force.end(), one.force.begin(), one.force.end());
    all.peak.insert(all.peak.end(), one.peak.begin(), one.peak.end());
  }
  return all;
}

// 600 keep the page within its seconds; three grids of the ladder, which 32 cells have, are what an
// estimate needs.
const Runs& random_contacts(const report::Item& item) {
  static const Runs runs = sweep(drawn(item));
  return runs;
}

void estimates(report::Item& item, const std::vector<bench::Estimate>& runs) {
  item.expect_checks(1);
  bench::estimates_against_truth(item, runs);
  item.value("drawn", static_cast<double>(drawn(item)), "", "{:.0f}");
  item.value(item.id() + "-covered",
             fmt::format("{:.1f} % of {}", 100 * bench::covered(runs), runs.size()));
  item.value(item.id() + "-unresolved", static_cast<double>(drawn(item) - runs.size()), "",
             "{:.0f}");
  const auto wide = std::ranges::count_if(
      runs, [](const bench::Estimate& run) { return run.stated > 10 * run.truth; });
  item.value(item.id() + "-wide", 100 * double(wide) / double(runs.size()), "%", "{:.0f}");
  double worst = 0;
  for (const bench::Estimate& run : runs) worst = std::max(worst, run.truth / run.stated);
  item.stability(
      {.id = item.id() + "-worst",
       .what = fmt::format("the {} of the worst of {} random contacts",
                           item.id() == "estimates-force" ? "force" : "peak", runs.size()),
       .stress = "slenderness, direction, rounded edges, few cells",
       .allowed = 2,
       .reference = "true over stated error; a bound that holds in 95 of 100 is passed by "
                    "less than 2 in a thousand normal ones"},
      [&] {
        return report::Found{fmt::format("{:.2g} times the stated error", worst), worst};
      });
  item.added("a study of methods");
}

// K, and its parts B and D, as in hertz.hpp: the descending Landen transformation in 80 bits.
struct Integrals {
  long double k, b, d;
};
Integrals extended(long double log_m1) {
  const long double square = -std::expm1(log_m1);  // k^2
  long double a = 1, g = std::exp(log_m1 / 2), sum = 0.5L, c2 = square;
  for (long double power = 1; c2 > 1e-40L * square; power *= 2) {
    const long double next = (a + g) / 2;
    c2 = c2 / (4 * next) * (c2 / (4 * next));
    g = std::sqrt(a * g), a = next;
    sum += power * c2 / square;
  }
  const long double k = 2 * std::atan(1.0L) / a;
  return {k, k - k * sum, k * sum};
}

// Hertz's force for curvatures 1 and the ratio of an ellipse with ln (b/a)^2 = t, at approach and
// modulus 1.
long double hertz_force(long double t) {
  const Integrals i = extended(t);
  return 8 * std::atan(1.0L) / 3 * std::sqrt(i.d / i.k) / i.k;
}

void digits(report::Item& item) {
  constexpr int arguments = 2000;
  std::vector<double> logs, ratios;  // ln (b/a)^2 down to -80, and three decades to both sides of 1
  for (int n = 1; n <= arguments; ++n) {
    logs.push_back(-80.0 * n * n / (arguments * arguments));
    ratios.push_back(std::pow(10, 6.0 * n / arguments - 3) * (1 + 1e-9));
  }
  std::vector<bench::Digits> rows;
  const auto row = [&](const char* id, const char* function, double allowed, bool slender,
                       auto value, auto exact) {
    rows.push_back(bench::worst_digits({.id = id,
                                        .function = function,
                                        .range = slender ? "b/a from 1 to 1e-17" : "1e-3 to 1000",
                                        .against = "Landen's transformation and asinh in 80 bits; "
                                                   "the bound is the one that the library states",
                                        .allowed = allowed},
                                       slender ? logs : ratios, value, exact));
  };
  const auto force = [](double t) {
    const Integrals i = extended(t);
    const long double ratio = i.b / i.d * std::exp(-static_cast<long double>(t));
    return hertz_from_approach({1, static_cast<double>(ratio), 0}, 1, 1).force;
  };
  const auto disc = [](long double r) {
    const Integrals i = extended(std::log1p(-(r < 1 ? r * r : 1 / (r * r))));
    return r < 1 ? 4 * (i.b + (1 - r * r) * i.d) : 4 / r * i.b;
  };
  const auto corner = [](long double y) { return std::asinh(y) + y * std::asinh(1 / y); };
  row(
      "k", "the integral K", 1e-15, true, [](double t) { return elliptic_integrals(t).k; },
      [](double t) { return extended(t).k; });
  row(
      "d", "the part K<sub>a</sub> of K", 1e-15, true,
      [](double t) { return elliptic_integrals(t).d; }, [](double t) { return extended(t).d; });
  row("hertz", "Hertz's force, from the curvatures", 1e-13, true, force, hertz_force);
  row(
      "disc", "a disc, from r/c", 5e-15, false, [](double r) { return disc_influence(1, r); },
      disc);
  row(
      "corner", "a cell's corner, from y/x", 1e-15, false,
      [](double y) { return corner_function(1, y); }, corner);
  item.expect_checks(static_cast<int>(rows.size()));
  bench::digits_table(item, rows);
  item.value("arguments", arguments, "", "{:.0f}");
  item.added("a study of methods");
}

}  // namespace

const report::Section errors{
    report::figure("estimates-force",
                   [](report::Item& item) { estimates(item, random_contacts(item).force); }),
    report::figure("estimates-peak",
                   [](report::Item& item) { estimates(item, random_contacts(item).peak); }),
    report::table("digits", digits)};

}  // namespace railbook::contact_chapter
