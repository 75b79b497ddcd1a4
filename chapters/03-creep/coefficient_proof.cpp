/***
Is it right? Three exact answers, the digits against the degree, and the other method.

{{table-coefficient-limits}}

Without Poisson's coupling the lateral traction of spin is Hertz's semi-ellipsoid, since its displacement
$p_0(A_0-A_1x^2-\ldots)$ has the slope asked for: $C_{23}=\pi/3A_1$, on a circle 4/3. A contact short along rolling consists of plane strips.
In one that is long the semi-ellipsoid carries all of $C_{23}$, with $\Lambda=\ln(16a^2/b^2)$ and $d=(1-\nu)\Lambda-2+4\nu$; its displacement along
rolling leaves only the part $[(1-2\nu)\Lambda-2+8\nu]/d$ of the longitudinal slip of spin to a traction with singular edges. The work of spin is
that of these edges, hence $C_{33}=\tfrac{\pi}{4}$ times the square of this part.

{{table-coefficient-degree}}

The grids are those of the full theory without a bound on the traction: 16 x 32 cells (24 x 24 beyond a/b = 2), half and a quarter of it,
extrapolated by a parabola. They share nothing with the polynomials but the half-space.

{{table-coefficient-methods}}

The grids keep to {{grids-typical}} % but where C23 is small (a/b = 0.1, {{grids-c23}} %) and in long contacts, where $C_{33}$ is the small
difference of large moments ({{grids-c33}} %). There it is the grids that err: the polynomials meet the limit of the long contact.
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "items.hpp"
#include "num/quadrature.hpp"
#include "rolling/kalker_grids.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

using rolling::ComputedCoefficients;
using rolling::kalker_coefficients;

struct Column {
  const char* name;
  double ComputedCoefficients::*member;
};
const std::array<Column, 4> columns{{{"C11", &ComputedCoefficients::c11},
                                     {"C22", &ComputedCoefficients::c22},
                                     {"C23", &ComputedCoefficients::c23},
                                     {"C33", &ComputedCoefficients::c33}}};

// C23 at Poisson's ratio zero; s = t^2 in A1 = ab/2 int (a^2 + s)^-3/2 (b^2 + s)^-1/2 s^-1/2 ds, with ab = 1.
double semi_ellipsoid(double ratio) {
  const auto integrand = [&](double t) {
    return 1 / (std::pow(ratio + t * t, 1.5) * std::sqrt(1 / ratio + t * t));
  };
  const double a1 =
      num::integrate(integrand, 0, std::numeric_limits<double>::infinity(), 1e-12).value;
  return units::pi / (3 * a1);
}

void limits(report::Item& item) {
  item.columns({"a/b", "ν", "coefficient", "exact", "computed", "relative difference"});
  item.expect_checks(12);
  const auto line = [&](const std::string& id, const std::string& ratio, double nu,
                        const std::string& name, double computed, double exact, double allowed,
                        const char* method) {
    item.add_row({ratio, fmt::format("{:g}", nu), name, fmt::format("{:.7g}", exact),
                  fmt::format("{:.7g}", computed), fmt::format("{:.0e}", computed / exact - 1)});
    item.agree(id, name + " at a/b = " + ratio, "", computed, exact, allowed, method);
  };
  for (const double ratio : {0.1, 1.0, 10.0})
    line(fmt::format("ellipsoid-{:g}", ratio), fmt::format("{:g}", ratio), 0, "C23",
         kalker_coefficients(ratio, 0).c23, semi_ellipsoid(ratio), 1e-10,
         "Hertz's semi-ellipsoid as lateral traction");
  const double g = 1e-4, lambda = std::log(16 / (g * g)), square = units::pi * units::pi;
  for (const double nu : {0.0, 0.25, 0.5}) {
    const auto narrow = kalker_coefficients(g, nu), slender = kalker_coefficients(1 / g, nu);
    const auto id = fmt::format("{:g}", nu);
    if (nu == 0.25) {
      const char* strips = "plane strips";
      line("strip-c11", "0.0001", nu, "C11", narrow.c11, square / 4 / (1 - nu), 1e-4, strips);
      line("strip-c22", "0.0001", nu, "C22", narrow.c22, square / 4, 1e-4, strips);
      line("strip-c33", "0.0001", nu, "C33", narrow.c33, square / 16 / (1 - nu) / g, 3e-4, strips);
    }
    const double d = (1 - nu) * lambda - 2 + 4 * nu;
    const double part = ((1 - 2 * nu) * lambda - 2 + 8 * nu) / d;
    line("long-c23-" + id, "10000", nu, "C23", slender.c23,
         2 * units::pi / 3 / std::pow(g, 1.5) / d, 1e-6, "the semi-ellipsoid's limit");
    line("long-c33-" + id, "10000", nu, "C33", slender.c33, units::pi / 4 * part * part, 3e-5,
         "work of the edges of a long contact");
  }
}

double worst_change(const ComputedCoefficients& one, const ComputedCoefficients& other) {
  double worst = 0;
  for (const Column& column : columns)
    worst = std::max(worst, std::abs(one.*column.member / other.*column.member - 1));
  return worst;
}

void degrees(report::Item& item) {
  item.explained("convergence of our own method; largest relative error of the four, nu = 0.25");
  item.columns(
      {"degree", "a/b = 0.1", "estimated", "a/b = 1", "estimated", "a/b = 10", "estimated"});
  for (const int degree : {8, 12, 16, 32}) {
    std::vector<std::string> cells{fmt::format("{}", degree)};
    for (const double ratio : {0.1, 1.0, 10.0}) {
      const auto c = kalker_coefficients(ratio, 0.25, degree);
      cells.push_back(fmt::format("{:.1e}", worst_change(c, kalker_coefficients(ratio, 0.25, 40))));
      cells.push_back(fmt::format("{:.1e}", c.error));
    }
    item.add_row(cells);
  }
}

// How far the extrapolated grids may be off.
double allowed(double ratio, const std::string& name) {
  if (ratio > 9) return name == "C33" ? 0.025 : 0.008;
  if (name == "C33" && ratio > 1.5) return 0.006;
  return name == "C23" && ratio < 0.15 ? 0.005 : 0.003;
}

void methods(report::Item& item) {
  const auto printed = item.printed("kalker.csv");
  item.columns({"a/b", "ν", "C11: table %", "grids %", "C22: table %", "grids %", "C23: table %",
                "grids %", "C33: table %", "grids %"});
  const std::array<const char*, 6> ratios{"0p1", "0p3", "1p0", "over-0p5", "over-0p3", "over-0p1"};
  item.expect_checks(72);
  double typical = 0, c23 = 0, c33 = 0;
  for (const char* ratio_key : ratios)
    for (const char* poisson_key : {"0", "0p25", "0p5"}) {
      const std::string key = fmt::format("{}-nu-{}", ratio_key, poisson_key);
      const std::string text = printed.at(key, "ratio"), nu = printed.at(key, "nu");
      const double ratio = text.starts_with("1/") ? 1 / std::stod(text.substr(2)) : std::stod(text);
      const auto c = kalker_coefficients(ratio, std::stod(nu));
      const auto grids = rolling::kalker_coefficients_by_grids(ratio, std::stod(nu));
      std::vector<std::string> cells{text, nu};
      for (const Column& column : columns) {
        const double best = c.*column.member, cell = grids.*column.member;
        const std::string name = column.name;
        const double table = report::printed_number(printed.at(key, "c" + name.substr(1)));
        cells.push_back(fmt::format("{:+.2f}", 100 * (table / best - 1)));
        cells.push_back(fmt::format("{:+.2f}", 100 * (cell / best - 1)));
        const double off = 100 * std::abs(cell / best - 1), limit = allowed(ratio, name);
        item.agree(key + "-" + name, name + " at " + key, "", cell, best, limit,
                   "the polynomials of degree 16");
        if (limit < 0.004) typical = std::max(typical, off);
        if (name == "C23" && ratio < 1) c23 = std::max(c23, off);
        if (name == "C33") c33 = std::max(c33, off);
      }
      item.add_row(cells);
    }
  item.value("grids-typical", typical, "", "{:.2f}");
  item.value("grids-c23", c23, "", "{:.2f}");
  item.value("grids-c33", c33, "", "{:.1f}");
}

}  // namespace

void creep_chapter::add_kalker_proof(report::Chapter& chapter) {
  chapter.table("table-coefficient-limits", "Kalker's coefficients where they are known exactly",
                limits);
  chapter.table("table-coefficient-degree", "Error of the coefficients against the degree",
                degrees);
  chapter.table("table-coefficient-methods",
                "Printed table and extrapolated grids, less the polynomials of degree 16", methods);
}
