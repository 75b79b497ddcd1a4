/***
### Kalker's coefficients

For small creepages nothing slides, and the forces are linear: $F_x=C_{11}G\,ab\,\xi$,
$F_y=G[ab\,C_{22}\eta+(ab)^{3/2}C_{23}\varphi]$, $M_z=G[-(ab)^{3/2}C_{23}\eta+(ab)^2C_{33}\varphi]$. Kalker's table of 1967, from series
of few terms, is what most vehicle programs still use. We compute it twice. The method below takes many terms of such series, and is
what the chapter's fast theories use where their coefficients are called computed; the grids of the full theory are its check.

A traction that is a polynomial of degree $n$ over $\sqrt{1-x^2/a^2-y^2/b^2}$ gives a displacement that is a polynomial of the same
degree (Galin). So the slip can be made to vanish exactly within the polynomials, and what is left free is a displacement of $y$ only. The
leading edge decides on it: material that enters is not strained yet, the traction must begin without singularity. No polynomial
vanishes on half a rim, and Kalker made it small there. The way of doing so matters. Two singular tractions $p$, $q$ exchange at the
edge the energy of a growing crack, $\tfrac{\pi}{2}b\oint\cos t\;q^{T}A\,p\,dt$, with $A$ the half-space's response to a wave in the direction $t$.
Taking the leading half of this off the equation of no slip is to a rim what upwinding is to a flow. The equations become those of rolling backwards when
transposed, and the error of a coefficient is the product of two errors of tractions: it falls with the power 3.5 of the degree.
All integrals are along the rim and the tractions need never be known inside. At the degree of 16, two systems of some 150 equations,
the coefficients are within 0.01 % from a/b = 0.1 on. $C_{23}$ from spin and from lateral creepage agree to {{reciprocity}}.

{{table-coefficients}}

{{fig-coefficients}}

The printed table is good to half a per cent over most of its range. It is off, and mostly too low, by up to {{table-worst}} % in the rows at both
ends, and in one entry between them: $C_{11}$ at a/b = 0.5 and $\nu$ = 0.5, printed {{c11-odd-printed}} and out of line with its
neighbours, is {{c11-odd}}. Of its {{entries}} entries, {{entries-off}} are off by more than half a unit of their last digit. For the rig's
ellipse, a/b = 1.568 and $\nu$ = 0.3, the computation gives $C_{11}$ = {{c11-rig}},
$C_{22}$ = {{c22-rig}}, $C_{23}$ = {{c23-rig}}, $C_{33}$ = {{c33-rig}}.
*/

#include "rolling/kalker_coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "items.hpp"
#include "rig.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

struct Entry {
  std::string key, ratio_text;
  double ratio = 0, nu = 0;
  rolling::ComputedCoefficients computed;
};

// "0.1" or "1/0.7".
double ratio_of(const std::string& text) {
  return text.starts_with("1/") ? 1 / std::stod(text.substr(2)) : std::stod(text);
}

const std::vector<Entry>& entries(const report::Item& item) {
  static const auto all = [&] {
    std::vector<Entry> list;
    const auto printed = item.printed("kalker.csv");
    for (const auto& cells : printed.rows) {
      const std::string& key = cells.front();
      Entry e{key, printed.at(key, "ratio"), 0, std::stod(printed.at(key, "nu")), {}};
      e.ratio = ratio_of(e.ratio_text);
      e.computed = rolling::kalker_coefficients(e.ratio, e.nu);
      list.push_back(e);
    }
    return list;
  }();
  return all;
}

struct Column {
  const char* name;
  double rolling::ComputedCoefficients::*member;
};
const std::array<Column, 4> columns{{{"c11", &rolling::ComputedCoefficients::c11},
                                     {"c22", &rolling::ComputedCoefficients::c22},
                                     {"c23", &rolling::ComputedCoefficients::c23},
                                     {"c33", &rolling::ComputedCoefficients::c33}}};

int decimals(const std::string& text) {
  const auto point = text.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(text.size() - point) - 1;
}

void tabulate(report::Item& item) {
  const auto printed = item.printed("kalker.csv");
  item.columns({"a/b", "C11", "table", "C22", "table", "C23", "table", "C33", "table"});
  item.expect_checks(static_cast<int>(4 * entries(item).size()));
  const auto allowed =
      report::relative(0.0125, "truncated series of the table, worst in its end rows");
  double reciprocity = 0, worst = 0;
  int off = 0;
  for (const Entry& e : entries(item)) {
    const auto& c = e.computed;
    reciprocity = std::max(reciprocity, std::abs(c.c32 / c.c23 - 1));
    for (const Column& column : columns) {
      const double computed = c.*column.member;
      const std::string& text = printed.at(e.key, column.name);
      item.row(printed, e.key).check(column.name, computed, allowed);
      const double gap = std::abs(report::printed_number(text) - computed);
      worst = std::max(worst, gap / computed);
      if (gap > 0.5 * std::pow(10.0, -decimals(text))) ++off;
    }
    if (e.key == "0p5-nu-0p5") {
      item.value("c11-odd", c.c11, "", "{:.3f}");
      item.value("c11-odd-printed", printed.at(e.key, "c11"));
    }
    if (e.nu != 0.25) continue;
    std::vector<std::string> cells{e.ratio_text};
    for (const Column& column : columns) {
      cells.push_back(fmt::format("{:.4g}", c.*column.member));
      cells.push_back(printed.at(e.key, column.name));
    }
    item.add_row(cells);
  }
  item.value("reciprocity", std::max(reciprocity, 1e-16), "", "{:.0e}");
  item.value("table-worst", 100 * worst, "", "{:.1f}");
  item.value("entries", static_cast<double>(4 * entries(item).size()), "", "{:.0f}");
  item.value("entries-off", off, "", "{:.0f}");
  const auto rig = rolling::kalker_coefficients(axis_ratio, poisson);
  item.value("c11-rig", rig.c11, "", "{:.3f}");
  item.value("c22-rig", rig.c22, "", "{:.3f}");
  item.value("c23-rig", rig.c23, "", "{:.3f}");
  item.value("c33-rig", rig.c33, "", "{:.3f}");
}

void figure(report::Item& item) {
  item.explained(
      "Kalker's printed table and its computation; the lower panels show their difference");
  const auto printed = item.printed("kalker.csv");
  auto& data = item.data({"nu", "ratio", "c11", "c22", "c23", "c33", "d11", "d22", "d23", "d33"});
  for (const double nu : {0.0, 0.25, 0.5}) {
    for (const Entry& e : entries(item)) {
      if (e.nu != nu) continue;
      std::array<double, 4> c{}, d{};
      for (std::size_t k = 0; k < 4; ++k) {
        c[k] = e.computed.*columns[k].member;
        d[k] = 100 * (report::printed_number(printed.at(e.key, columns[k].name)) / c[k] - 1);
      }
      data.add(nu, e.ratio, c[0], c[1], c[2], c[3], d[0], d[1], d[2], d[3]);
    }
    data.gap();
  }
}

}  // namespace

void creep_chapter::add_coefficients(report::Chapter& chapter) {
  chapter.table("table-coefficients", "Kalker's coefficients for nu = 0.25, computed and printed",
                tabulate);
  chapter.figure("fig-coefficients", "Kalker's coefficients for nu = 0, 0.25 and 0.5", figure);
}
