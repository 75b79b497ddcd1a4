/***
### Kalker's coefficients

For small creepages nothing slides, and the forces are linear: $F_x=C_{11}G\,ab\,\xi$,
$F_y=G[ab\,C_{22}\eta+(ab)^{3/2}C_{23}\varphi]$, $M_z=G[-(ab)^{3/2}C_{23}\eta+(ab)^2C_{33}\varphi]$. Kalker's table of 1967, from series
of few terms, is what most vehicle programs still use. The same rows of cells without a traction bound compute it, on three grids
of 16 x 32 cells (24 x 24 beyond a/b = 2), half and a quarter of it, extrapolated by a parabola: the whole table in a few seconds. The same coefficient $C_{23}$ comes from spin and from lateral
creepage. The two agree to {{reciprocity}}: the equations for one direction of rolling are the transpose of those for the other.

{{table-coefficients}}

{{fig-coefficients}}

The printed table proves good to its last digit for most entries of C11 and C22. The largest differences stand where the ellipse is long
along rolling: there $C_{33}$ is the small difference of large moments, ours is uncertain by one per cent at a/b = 10, and
the series had its own trouble. Elsewhere our grids leave about 0.1 %. For the rig's ellipse, a/b = 1.568 and $\nu$ = 0.3, the computation gives $C_{11}$ = {{c11-rig}},
$C_{22}$ = {{c22-rig}}, $C_{23}$ = {{c23-rig}}, $C_{33}$ = {{c33-rig}}.
*/

#include "contact/kalker_coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "items.hpp"
#include "rig.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

struct Entry {
  std::string key, ratio_text;
  double ratio = 0, nu = 0;
  contact::ComputedCoefficients computed;
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
      e.computed = contact::kalker_coefficients(e.ratio, e.nu);
      list.push_back(e);
    }
    return list;
  }();
  return all;
}

struct Column {
  const char* name;
  double contact::ComputedCoefficients::*member;
};
const std::array<Column, 4> columns{{{"c11", &contact::ComputedCoefficients::c11},
                                     {"c22", &contact::ComputedCoefficients::c22},
                                     {"c23", &contact::ComputedCoefficients::c23},
                                     {"c33", &contact::ComputedCoefficients::c33}}};

// How far the printed table and ours may differ, of the coefficient.
report::Tolerance allowed(const Entry& e, const std::string& column) {
  if (column == "c33" && e.ratio > 4)
    return report::relative(0.03,
                            "small difference of large moments, uncertain here and in the series");
  if (column == "c23" && e.ratio < 0.15)
    return report::relative(0.025,
                            "the smallest of the four; the series of the table has few terms");
  return report::relative(0.01, "truncated series of the table, up to 0.9 % in its end rows");
}

void table(report::Item& item) {
  const auto printed = item.printed("kalker.csv");
  item.columns({"a/b", "C11", "table", "C22", "table", "C23", "table", "C33", "table"});
  item.expect_checks(static_cast<int>(4 * entries(item).size()));
  double reciprocity = 0;
  for (const Entry& e : entries(item)) {
    const auto& c = e.computed;
    reciprocity = std::max(reciprocity, std::abs(c.c32 / c.c23 - 1));
    for (const Column& column : columns)
      item.row(printed, e.key).check(column.name, c.*column.member, allowed(e, column.name));
    if (e.nu != 0.25) continue;
    std::vector<std::string> cells{e.ratio_text};
    for (const Column& column : columns) {
      cells.push_back(fmt::format("{:.4g}", c.*column.member));
      cells.push_back(printed.at(e.key, column.name));
    }
    item.add_row(cells);
  }
  item.value("reciprocity", reciprocity, "", "{:.0e}");
  const auto rig = contact::kalker_coefficients(axis_ratio, poisson);
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
                table);
  chapter.figure("fig-coefficients", "Kalker's coefficients for nu = 0, 0.25 and 0.5", figure);
}
