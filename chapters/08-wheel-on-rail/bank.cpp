/*** ## Against a peer's bank

How far are these answers from another program's, not on one wheel but on everything that it is tested
with? CONTACT's examples and test bank print the inputs and results of some 1,700 cases. The chapter's
library answers those with elastic bodies and Coulomb's friction on paraboloids and on the benchmark's
wheels: pressing, shifting, rolling from rest, steady rolling and FASTSIM.

{{fig-bank}}

Each case is solved twice: on the bank's own cells with the bank's own scheme, whose error falls in
proportion to the cells; and on cells of half the size, a history of rolling from rest also in steps
of half the size. Three outcomes are possible. The answer on finer cells is within 1 % of the
bank's; or only the one on the same cells is, so that the bank's cells make the difference; or
neither. Where both answers have an error of first order in the cells, as in a history, they lead on
to what cells of no size would give, and the last column of the table is the mean of that.

{{bank}}

**Whose cells?** On the same cells the two programs give the same forces: 377 of 377 along and 284 of 286 across
are within 1 %. On finer cells ours stay within it for 326 and 218, and the others move away by up to 3 %. Led on to
cells of no size, ours are 0.9 and 1.4 % below the bank's. Since ours on the bank's cells are not, this is
what its cells make of these forces. In the creep table, whose contacts are seven cells long, it is 2 % along on
the mean, and small forces across scatter by 17 %.

**What differs?** FASTSIM in the bank adds up its tractions at the ends of cells, and on cells a fifth of
the size it comes nearer to ours. The power of friction that the bank prints is below the product of its
own forces and creepages, by 3 % even where the whole patch slides. An area, and the part of it that
sticks, is counted in whole cells, which on a flange are four across. The seven largest pressures that differ, by
1.2 to 1.9 %, are those of the flange, and the two forces those of the wheels in their middle position.

The run draws the comparisons that stand in the chapter's data. A test solves all cases again
and holds both the data and the table to what it finds. Of the creep table's 3220 cases 192 are compared, from
each of its five ellipses. Not answered are layers between the bodies,
friction that depends on slip or temperature, viscous bodies, gaps given point by point, switches and
worn wheels, contacts of fewer than five cells, rolling in steps other than a cell, and unlike bodies whose
tractions change the pressure. A wheel is left out, too, where the bank has one patch and this program two (the
right one at 5 mm), and so is the moment of a rolling sphere, which differs for a reason that we have not found.
Of cases with such layers or friction only the pressing is compared. Pressings that the bank repeats are
counted once. Measured forces or pressures that are printed with their uncertainty, to be shown beside these, were
not found in a text that we could read.

{{fold}}
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>

#include <railbook/table/csv.hpp>
#include <railbook/wheel_contact/model_error.hpp>

#include "case_a.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::wheel_contact;

namespace {

void bank(report::Item& item) {
  item.added("CONTACT's test bank is no paper of the book");
  item.columns({"quantity",
                {"values", "{:.0f}"},
                {"within 1 %", "{:.0f}"},
                {"within 1 % on the same cells", "{:.0f}"},
                {"differ", "{:.0f}"},
                {"bias, %", "{:.2f}"},
                {"scatter, %", "{:.2f}"},
                {"bias without cells, %", "{:.2f}"}});
  for (const ModelError& m : model_errors)
    if (m.count > 0)
      item.add_row(m.quantity, double(m.count), double(m.agree), double(m.cells), double(m.differ),
                   100 * m.bias, 100 * m.scatter, 100 * m.limit);
}

constexpr std::array panels{"normal force",       "largest pressure", "approach",
                            "contact area",       "stick area",       "power of friction",
                            "longitudinal force", "lateral force",    "moment"};

void fig_bank(report::Item& item) {
  item.added("CONTACT's test bank is no paper of the book");
  table::CsvReader csv(std::filesystem::path(RAILBOOK_CHAPTER_DIR) / "data" / "peer-bank.csv");
  report::Data& data = item.data({"panel", "theirs", "ours"});
  std::set<std::array<long, 3>> drawn;  // of points on one another one is enough
  while (csv.next()) {
    const std::string_view quantity = csv.cell(csv.column("quantity"));
    const auto panel = std::ranges::find_if(
        panels, [&](std::string_view name) { return quantity.starts_with(name); });
    const auto number = [&](const char* column) {
      return std::abs(csv.number(csv.column(column)));
    };
    if (panel == panels.end()) continue;
    const double theirs = number("theirs"), ours = number("finer_cells");
    const auto at = [](double v) { return std::lround(50 * std::log10(v)); };
    if (drawn.insert({panel - panels.begin(), at(theirs), at(ours)}).second)
      data.add(double(panel - panels.begin()), theirs, ours);
  }
}

}  // namespace

const report::Section against_bank{
    report::figure(
        "fig-bank",
        "Over five decades the two programs' answers lie on one line. Ours against CONTACT's, "
        "without signs, over the cases of its test bank; the line is equality. Nothing is grossly "
        "wrong; differences of a few per cent cannot be seen here, the next table has them. Forces "
        "in N, pressures in MPa, lengths in mm, power in W, moments in N mm; those with FASTSIM "
        "stand in the same panels.",
        fig_bank),
    report::table(
        "bank",
        "The two programs differ by less than their cells make. Values of each quantity "
        "compared, how many agree, and mean and standard deviation of the logarithm of "
        "ours over CONTACT's, ours on the finer cells; last, the mean with ours led on to "
        "cells of no size",
        bank)};
