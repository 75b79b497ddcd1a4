/***
Where the two curves differ, which is nearer the truth? The cells of CONTACT can be had here as well: n x n equal ones over the
diameters, a staircase for a rim, the pressure not Hertz's but that of the same cells, pressed with the load. With them our solver
gives the program's numbers digit for digit, so influence numbers, slip and friction are the same on either side:

{{pixels}}

So only the step to infinitely small cells is open. It is not safe. The error is of first order, and how the cells happen to meet the
rim adds a part that jumps from grid to grid: lines over 1/n through any two of the program's grids of 63 to 255 cells end up to {{pixel-spread}}
apart. Our value lies among these ends at all three creepages; the extrapolated one of {{table-full-curve}} is above
all of them at {{pixel-above}} of three. The listed curve is then, if anything, a little high, and two grids of placed cells, which
agree to {{grids-apart}}, say more about the limit than it does.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/cg_fft.hpp"
#include "full.hpp"
#include "items.hpp"
#include "rig.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

using contact::Grid;
using Eigen::Index;

// n x n cells over the diameters, and an empty one around.
Grid pixels(const contact::HertzContact& h, Index n) {
  const double dx = 2 * h.a / static_cast<double>(n), dy = 2 * h.b / static_cast<double>(n);
  return {-h.a - dx, -h.b - dy, dx, dy, n + 2, n + 2};
}

// The pressure of these cells for the load of `h`: the approach is found by secants.
Eigen::VectorXd pressure(const Grid& grid, const contact::HertzContact& h) {
  const auto gap = contact::sample(
      [&](double x, double y) { return h.curvature.a * x * x + h.curvature.b * y * y; }, grid);
  contact::CgFftOptions options;
  options.remedy = false;
  options.cg.tolerance = 1e-10;
  double approach = h.approach, last = 0, force = 0;
  for (int k = 0; k < 12; ++k) {
    const auto solved = contact::solve_cg_fft(grid, gap, approach, modulus(), options).contact;
    if (std::abs(solved.force / h.force - 1) < 1e-9) {
      Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.cells());
      for (Index m = 0; m < solved.p.size(); ++m) {
        const auto i = static_cast<Index>((solved.x[m] - grid.x0) / grid.dx);
        const auto j = static_cast<Index>((solved.y[m] - grid.y0) / grid.dy);
        p[j * grid.nx + i] = solved.p[m];
      }
      return p;
    }
    const double slope =
        k > 0 ? (solved.force - force) / (approach - last) : 1.5 * h.force / h.approach;
    last = approach, force = solved.force;
    approach += (h.force - force) / slope;
  }
  throw InputError{"the cells' pressure was not found for the load"};
}

// Where the lines over 1/n through two of the program's grids, coarse ones left out, meet 1/n = 0.
struct Ends {
  double low = 2, high = -2;
};
Ends ends(const table::CsvTable& program, const std::string& key) {
  const std::vector<int> n{63, 127, 181, 255};
  std::vector<double> f;
  for (const int k : n) f.push_back(report::printed_number(program.at(key, fmt::format("n{}", k))));
  Ends e;
  for (std::size_t i = 0; i < n.size(); ++i)
    for (std::size_t j = i + 1; j < n.size(); ++j) {
      const double limit = (n[j] * f[j] - n[i] * f[i]) / (n[j] - n[i]);
      e.low = std::min(e.low, limit), e.high = std::max(e.high, limit);
    }
  return e;
}

// f at the three creepages on n x n cells.
std::vector<double> forces(Index n, const std::vector<std::string>& keys) {
  const auto ellipse = rig_contact(paper_load, profile_radius(true));
  const Grid grid = pixels(ellipse, n);
  const Eigen::VectorXd p = pressure(grid, ellipse);
  std::vector<double> f;
  for (const auto& key : keys) {
    const auto c = rolling::with_reduced_creepage(rig_case(), {std::stod(key), 0, 0});
    const auto solved = rolling::solve_rolling(grid, p, c, {.remedy = false, .estimate = false});
    if (!solved.converged) throw InputError{solved.reason};
    f.push_back(solved.fx / (c.friction * c.load));
  }
  return f;
}

void show_limits(report::Item& item, const std::vector<std::string>& keys,
                 std::vector<std::vector<std::string>> rows) {
  const auto program = item.printed("contact-pixels.csv"),
             listed = item.printed("contact-curve.csv");
  const auto& curve = reference_curve(item.full());
  double spread = 0;
  int above = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const Ends e = ends(program, keys[k]);
    const auto point = std::find_if(curve.begin(), curve.end(), [&](const CurvePoint& p) {
      return fmt::format("{}", p.x) == keys[k];
    });
    const std::string& theirs = listed.at(keys[k], "f");
    const double middle = (e.low + e.high) / 2;
    item.agree("among-" + keys[k], "f at X = " + keys[k], "", point->force, middle,
               (e.high - e.low) / 2 / middle,
               "lines through two grids of CONTACT, low to high end");
    spread = std::max(spread, e.high - e.low);
    above += report::printed_number(theirs) > e.high ? 1 : 0;
    rows[k].insert(rows[k].end(), {fmt::format("{:.5f} to {:.5f}", e.low, e.high),
                                   fmt::format("{:.5f}", point->force), theirs});
    item.add_row(rows[k]);
  }
  item.value("pixel-spread", spread, "", "{:.1e}");
  item.value("pixel-above", above, "", "{:.0f}");
}

void tabulate(report::Item& item) {
  item.explained("CONTACT's grids solved again, to the digits it prints");
  const auto program = item.printed("contact-pixels.csv");
  std::vector<int> sizes{15, 31, 63};
  if (item.full()) sizes.push_back(127);
  const std::vector<std::string> keys{"0.1", "0.2", "0.3"};
  item.expect_checks(static_cast<int>((sizes.size() + 1) * keys.size()));
  std::vector<std::string> headings{"X"};
  std::vector<std::vector<std::string>> rows{{keys[0]}, {keys[1]}, {keys[2]}};
  for (const int n : sizes) {
    headings.push_back(fmt::format("f, {} x {}", n, n));
    const auto f = forces(n, keys);
    for (std::size_t k = 0; k < keys.size(); ++k) {
      item.row(program, keys[k]).check(fmt::format("n{}", n), f[k]);
      rows[k].push_back(fmt::format("{:.6f}", f[k]));
    }
  }
  headings.insert(headings.end(), {"ends of lines through 63 to 255", "f, placed cells",
                                   "f, CONTACT extrapolated"});
  item.columns({headings.begin(), headings.end()});
  show_limits(item, keys, rows);
}

}  // namespace

void creep_chapter::add_pixels(report::Chapter& chapter) {
  chapter.table("pixels", "CONTACT's own grids, and where they lead", tabulate);
}
