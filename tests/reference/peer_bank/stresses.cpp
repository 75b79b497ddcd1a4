#include "stresses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <railbook/contact/subsurface.hpp>
#include <railbook/table/csv.hpp>

namespace railbook::peer_bank {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Cells {
  contact::Grid grid;
  VectorXd pressure, traction;  // traction: its size; empty where nothing is shifted
};

Cells solve_cells(const HalfSpaceCase& c, int finer) {
  const Normal n = solve_normal(c, finer);
  Cells out{n.grid, n.p, {}};
  if (c.kind != "shift") return out;
  const auto shifted = start_history(c, n)->shift_for(-c.fx_share * c.mu * n.force).forces;
  if (!shifted.converged) throw std::runtime_error(shifted.reason);
  out.traction = VectorXd::Zero(n.p.size());
  const auto& t = shifted.tractions;
  for (Index k = 0; k < t.x.size(); ++k) {
    const Index i = Index(std::lround((t.x[k] - n.grid.x(0)) / n.grid.dx));
    const Index j = Index(std::lround((t.y[k] - n.grid.y(0)) / n.grid.dy));
    if (i >= 0) out.traction[j * n.grid.nx + i] = std::hypot(t.px[k], t.py[k]);
  }
  return out;
}

// The mean over the bank's cell whose middle is at (x, y).
double mean(const Cells& cells, const VectorXd& values, double x, double y, int finer) {
  const contact::Grid& g = cells.grid;
  const auto first = [finer](double from_edge, double cell) {
    return finer * Index(std::floor(from_edge / (finer * cell)));
  };
  const Index i0 = first(x - g.x0, g.dx), j0 = g.ny == 1 ? 0 : first(y - g.y0, g.dy);
  const Index rows = g.ny == 1 ? 1 : finer;
  double sum = 0;
  for (Index j = j0; j < j0 + rows; ++j)
    for (Index i = i0; i < i0 + finer; ++i) sum += values[j * g.nx + i];
  return sum / double(rows * finer);
}

// The unit square of the bank's example: 5 x 5 cells of 0.2 in the middle of 15 x 15, whose middles
// are among the bank's points.
struct UnitSquare {
  contact::Grid grid{-1.5, -1.5, 0.2, 0.2, 15, 15};
  contact::Subsurface below;
  explicit UnitSquare(double traction) : below(grid, 0.28, load(1), load(traction), load(0)) {}
  VectorXd load(double value) const {
    VectorXd p = VectorXd::Zero(grid.cells());
    for (Index j = 5; j < 10; ++j) p.segment(j * grid.nx + 5, 5).setConstant(value);
    return p;
  }
};

double of(const std::string& quantity, const contact::Stress& s) {
  if (quantity.ends_with("Mises stress")) return contact::von_mises(s);
  if (quantity == "mean stress") return s.head<3>().mean();
  if (quantity == "shear stress zx") return s[5];
  return 2 * contact::largest_shear(s);  // Tresca's
}

}  // namespace

std::vector<Comparison> answer_stresses(const std::vector<HalfSpaceCase>& cases,
                                        const std::string& file) {
  table::CsvReader csv(file);
  const auto at = [&](const char* column) { return csv.number(csv.column(column)); };
  std::map<std::string, std::pair<Cells, Cells>> solved;
  const UnitSquare pressed(0), pulled(0.999);
  std::vector<Comparison> out;
  while (csv.next()) {
    Comparison c{};
    c.file = csv.cell(csv.column("file")), c.number = int(at("case"));
    c.quantity = csv.cell(csv.column("quantity")), c.theirs = at("value");
    const double x = at("x"), y = at("y"), z = at("z");
    if (c.quantity.ends_with("of a cell")) {
      const auto it = std::ranges::find_if(cases, [&](const HalfSpaceCase& one) {
        return one.file == c.file && one.number == c.number;
      });
      if (it == cases.end()) throw std::runtime_error(fmt::format("no case {}", c.file));
      if (!solved.contains(c.file)) solved[c.file] = {solve_cells(*it, 1), solve_cells(*it, 2)};
      const auto& [same, fine] = solved[c.file];
      const bool normal = c.quantity.starts_with("pressure");
      const auto value = [&](const Cells& cells, int finer) {
        return mean(cells, normal ? cells.pressure : cells.traction, x * mm, y * mm, finer) / mpa;
      };
      c.same = value(same, 1), c.fine = value(fine, 2);
    } else {  // exact for the square
      const UnitSquare& square = c.number == 1 ? pressed : pulled;
      const contact::Stresses all = square.below.at(z);
      if (c.quantity.starts_with("largest")) {
        for (Index k = 0; k < all.rows(); ++k)
          c.fine = std::max(c.fine, of(c.quantity, all.row(k)));
      } else {
        const auto cell = [](double v) { return Index(std::lround(v / 0.2)) + 7; };
        c.fine = of(c.quantity, all.row(cell(y) * square.grid.nx + cell(x)));
      }
      c.same = c.fine;
    }
    out.push_back(c);
  }
  return out;
}

}  // namespace railbook::peer_bank
