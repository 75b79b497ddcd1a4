#include "half_space.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>

#include <railbook/contact/bounded_cg.hpp>
#include <railbook/contact/convolution.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/kalker_table.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/rolling/transient.hpp>
#include <railbook/rolling/unlike_materials.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::peer_bank {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<HalfSpaceCase> read_half_space(const std::string& file) {
  table::CsvReader csv(file);
  std::vector<HalfSpaceCase> all;
  const auto at = [&](const char* column) { return csv.number(csv.column(column)); };
  const auto text = [&](const char* column) { return std::string(csv.cell(csv.column(column))); };
  while (csv.next()) {
    HalfSpaceCase c{};
    c.file = text("file"), c.kind = text("kind"), c.reason = text("reason");
    c.number = int(at("case")), c.fresh = int(at("fresh"));
    c.nu1 = at("nu1"), c.nu2 = at("nu2"), c.g1 = at("g1"), c.g2 = at("g2"), c.mu = at("mu");
    c.curvature_x = at("curvature_x"), c.curvature_y = at("curvature_y");
    c.nx = at("nx"), c.ny = at("ny"), c.x0 = at("x0"), c.y0 = at("y0");
    c.dx = at("dx"), c.dy = at("dy"), c.load = at("load"), c.pen = at("pen");
    c.cksi = at("cksi"), c.fx_share = at("fx_share"), c.ceta = at("ceta");
    c.fy_share = at("fy_share"), c.cphi = at("cphi"), c.chi = at("chi"), c.dq = at("dq");
    c.fn = at("fn"), c.approach = at("approach"), c.p_max = at("p_max");
    c.contact_cells = at("contact_cells"), c.stick_cells = at("stick_cells");
    c.fx = at("fx"), c.fy = at("fy"), c.mz = at("mz"), c.motion_x = at("motion_x");
    all.push_back(c);
  }
  return all;
}

std::vector<HalfSpaceCase> read_creep_table(const std::string& file) {
  table::CsvReader csv(file);
  const auto at = [&](const char* column) { return csv.number(csv.column(column)); };
  const double poisson = 0.28, shear = 1, mu = 0.3, cells = 11, scale = cells / (cells - 4);
  std::vector<HalfSpaceCase> all;
  while (csv.next()) {
    HalfSpaceCase c{};
    c.file = "testbank/test_table_mx11", c.kind = "steady_table", c.number = int(all.size()) + 1;
    c.nu1 = c.nu2 = poisson, c.g1 = c.g2 = shear, c.mu = mu, c.load = c.fn = 1;
    const double ratio = at("axis_ratio"), modulus = shear / (1 - poisson);  // E* of both, MPa
    const auto hertz = [&](double curvature_y) {
      return contact::hertz_from_force(contact::relative_curvature({2, 2 * curvature_y, 0}, {}),
                                       modulus, c.load);
    };
    c.curvature_x = 1;
    c.curvature_y = std::exp(num::find_root(
                                 [&](double log_y) {
                                   const auto h = hertz(std::exp(log_y));
                                   return std::log(h.a / h.b / ratio);
                                 },
                                 -6, 6, 1e-12)
                                 .x);
    const auto h = hertz(c.curvature_y);
    c.nx = c.ny = cells, c.x0 = -scale * h.a, c.y0 = -scale * h.b;
    c.dx = 2 * scale * h.a / cells, c.dy = 2 * scale * h.b / cells;
    const double length = std::sqrt(h.a * h.b), radius = 2 / (1 + c.curvature_y);
    const double angle = at("angle_deg") * units::pi / 180, size = at("magnitude") * mu;
    c.cksi = size * std::cos(angle) * length / radius;
    c.ceta = size * std::sin(angle) * length / radius;
    c.cphi = mu * at("spin") / radius;
    c.fx = mu * at("fx"), c.fy = mu * at("fy"), c.mz = mu * length * at("mz");
    c.pen = c.fx_share = c.fy_share = c.contact_cells = c.stick_cells = c.p_max = units::nan;
    c.motion_x = units::nan, c.approach = h.approach, c.dq = c.dx;
    all.push_back(c);
  }
  return all;
}

namespace {

auto materials(const HalfSpaceCase& c) {
  return rolling::combine({2 * c.g1 * mpa * (1 + c.nu1), c.nu1},
                          {2 * c.g2 * mpa * (1 + c.nu2), c.nu2});
}

}  // namespace

Normal solve_normal(const HalfSpaceCase& c, int finer) {
  Normal n;
  n.grid = {c.x0 * mm,         c.y0 * mm,           c.dx * mm / finer,
            c.dy * mm / finer, Index(c.nx) * finer, Index(c.ny) * (c.ny > 1 ? finer : 1)};
  if (c.ny == 1) n.grid.dy = c.dy * mm;
  if (std::cos(c.chi * units::pi / 180) < 0)  // rolling backwards: the plane turned by 180 degrees
    n.grid.x0 = -(n.grid.x0 + double(n.grid.nx) * n.grid.dx);
  const double modulus = materials(c).effective_modulus;
  const VectorXd gap = contact::sample(
      [&](double x, double y) { return (c.curvature_x * x * x + c.curvature_y * y * y) / mm; },
      n.grid);
  contact::Convolution a(n.grid, modulus);
  n.p = VectorXd::Zero(n.grid.cells());
  const auto force_at = [&](double approach) {
    const auto done = contact::solve_bounded_cg(a, gap, approach, n.p, {});
    if (!done.converged) throw std::runtime_error("the normal contact does not converge");
    n.approach = approach;
    return n.force = n.p.sum() * n.grid.dx * n.grid.dy;
  };
  if (std::isfinite(c.pen)) {
    force_at(c.pen * mm);
  } else {
    double x1 = c.approach * mm, f1 = force_at(x1), x2 = x1 * std::pow(c.load / f1, 2.0 / 3);
    for (int k = 0; k < 40 && std::abs(f1 / c.load - 1) > 1e-8; ++k) {
      const double f2 = force_at(x2);
      if (f2 == f1) break;
      const double x3 = x2 - (f2 - c.load) * (x2 - x1) / (f2 - f1);
      x1 = x2, f1 = f2, x2 = std::max(x3, x1 / 2);
    }
    if (std::abs(n.force / c.load - 1) > 1e-4)  // a contact of a few cells: force in steps
      throw std::runtime_error(fmt::format("the load is not met: {:.5f}", n.force / c.load));
  }
  n.p_max = n.p.maxCoeff();
  n.area = double((n.p.array() > 0).count()) * n.grid.dx * n.grid.dy;
  return n;
}

namespace {

struct Tangential {
  double fx = units::nan, fy = units::nan, mz = units::nan, stick = units::nan, motion = units::nan;
};

// The library's forces are those of body 1 on body 2; the bank's are those on body 1. Both have x
// along rolling, z into opposite bodies, and the same rigid slip.
Tangential in_bank_frame(const rolling::CreepForces& f, double sign, double motion) {
  if (!f.converged) throw std::runtime_error(f.reason);
  return {-sign * f.fx, -sign * f.fy, -f.mz, f.stick_share, sign * motion};
}

rolling::RollingCase rolling_case(const HalfSpaceCase& c, double sign) {
  const auto pair = materials(c);
  rolling::RollingCase r;
  r.shear_modulus = pair.shear_modulus, r.poisson = pair.poisson, r.friction = c.mu;
  const auto known = [](double v) { return std::isfinite(v) ? v : 0; };
  r.creepage = {sign * known(c.cksi), sign * known(c.ceta), c.cphi / mm};
  return r;
}

Tangential steady(const HalfSpaceCase& c, const Normal& n, bool own_cells) {
  const double sign = std::cos(c.chi * units::pi / 180) < 0 ? -1 : 1;
  rolling::RollingCase r = rolling_case(c, sign);
  const double unlike = materials(c).dissimilarity;
  const rolling::RollingOptions options{.remedy = !own_cells, .estimate = false};
  if (own_cells) r.creepage.lateral -= r.creepage.spin * n.grid.dx / 3;  // the bank's slip point
  const auto at = [&](double creepage) {
    r.creepage.longitudinal = creepage;
    return std::abs(unlike) > 1e-9 ? rolling::solve_rolling_unlike(n.grid, n.p, r, options, unlike)
                                   : rolling::solve_rolling(n.grid, n.p, r, options);
  };
  if (!std::isfinite(c.fx_share))
    return in_bank_frame(at(r.creepage.longitudinal), sign, units::nan);
  const double bound = c.mu * n.force, wanted = -sign * c.fx_share;
  const auto off = [&](double x) { return at(x).fx / bound - wanted; };
  const double guess = sign * c.motion_x, reach = 0.2 * std::abs(guess) + 1e-9;
  const num::Root found = num::find_root(off, guess - reach, guess + reach, 1e-6);
  if (!found.converged) throw std::runtime_error("no creepage has the force");
  return in_bank_frame(at(found.x), sign, found.x);
}

Tangential fastsim(const HalfSpaceCase& c, int finer) {
  const double sign = std::cos(c.chi * units::pi / 180) < 0 ? -1 : 1;
  const auto h = contact::hertz_from_force(
      contact::relative_curvature({2 * c.curvature_x / mm, 2 * c.curvature_y / mm, 0}, {}),
      materials(c).effective_modulus, c.load);
  rolling::RollingCase r = rolling_case(c, sign);
  r.a = h.a, r.b = h.b, r.load = c.load;
  const auto bound =
      c.kind == "fastsim_parabolic" ? rolling::Bound::parabolic : rolling::Bound::elliptic;
  const int along = int(std::lround(2 * h.a / (c.dx * mm))) * finer;
  const int strips = int(std::lround(2 * h.b / (c.dy * mm))) * finer;
  return in_bank_frame(rolling::fastsim_grid(r, rolling::kalker_table(h.a / h.b, r.poisson),
                                             {.bound = bound, .along = along, .strips = strips}),
                       sign, units::nan);
}

}  // namespace

std::unique_ptr<rolling::Transient> start_history(const HalfSpaceCase& c, const Normal& n) {
  contact::Grid grid = n.grid;  // with the empty column that Transient wants
  grid.x0 -= grid.dx, ++grid.nx;
  VectorXd p = VectorXd::Zero(grid.cells());
  for (Index j = 0; j < grid.ny; ++j)
    p.segment(j * grid.nx + 1, n.grid.nx) = n.p.segment(j * n.grid.nx, n.grid.nx);
  return std::make_unique<rolling::Transient>(grid, p, rolling_case(c, 1));
}

namespace {

// A sequence of shifts and transient rolling on one grid.
class History {
 public:
  explicit History(int finer) : finer_(finer) {}
  void start(const HalfSpaceCase& c, const Normal& n) {
    contact_ = start_history(c, n);
    bound_ = c.mu * n.force;
  }
  Tangential step(const HalfSpaceCase& c) {
    const bool rolls = c.kind == "transient", force = std::isfinite(c.fx_share);
    if (!rolls && force) return keep(contact_->shift_for(-c.fx_share * bound_), mm);
    if (!rolls) return in_bank_frame(contact_->shift(c.cksi * mm, c.ceta * mm), 1, units::nan);
    Tangential last;
    rolling::Creepage creepage = rolling_case(c, 1).creepage;
    creepage.lateral -= creepage.spin * c.dx * mm / (3 * finer_);  // the bank's slip point
    for (int k = 0; k < finer_; ++k)
      last = force ? keep(contact_->roll_for(-c.fx_share * bound_), 1)
                   : in_bank_frame(contact_->roll(creepage), 1, units::nan);
    return last;
  }

 private:
  static Tangential keep(const rolling::Transient::Step& s, double unit) {
    return in_bank_frame(s.forces, 1, s.motion / unit);
  }
  int finer_;
  double bound_ = 0;
  std::unique_ptr<rolling::Transient> contact_;
};

std::string normal_key(const HalfSpaceCase& c) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {}", c.curvature_x, c.curvature_y,
                     c.nu1, c.nu2, c.g1, c.g2, c.nx, c.ny, c.x0, c.dx, c.dy, c.load, c.pen, c.chi);
}

}  // namespace

HalfSpaceAnswers answer(const std::vector<HalfSpaceCase>& cases) {
  HalfSpaceAnswers out;
  std::set<std::string> seen;
  std::string key;
  std::optional<Normal> same, fine;
  History history(1), fine_history(2);
  bool in_sequence = false;
  for (const HalfSpaceCase& c : cases) {
    bool stepped = false;
    if (c.kind == "none") {
      ++out.refused;
      in_sequence = false;
      continue;
    }
    const auto compare = [&](std::string quantity, double theirs, double ours, double finer,
                             double largest) {
      if (!std::isfinite(theirs)) return;
      if (c.kind.starts_with("fastsim") && largest > 0) quantity += " of FASTSIM";
      if (c.kind == "steady_table") quantity += " of the creep table";
      out.comparisons.push_back({c.file, c.number, quantity, theirs, ours, finer,
                                 std::abs(theirs) < 0.02 * largest, stepped});
    };
    if (key != normal_key(c)) {
      key = normal_key(c);
      same = solve_normal(c, 1);
      fine = solve_normal(c, 2);
    }
    if (seen.insert(key).second) {
      if (std::isfinite(c.pen))
        compare("normal force", c.fn, same->force, fine->force, 0);
      else
        compare("approach", c.kind == "steady_table" ? units::nan : c.approach, same->approach / mm,
                fine->approach / mm, 0);
      compare("largest pressure", c.p_max, same->p_max / mpa, fine->p_max / mpa, 0);
      if (c.contact_cells > 0)
        compare("contact area", c.contact_cells * c.dx * c.dy, same->area / (mm * mm),
                fine->area / (mm * mm), 0);
    }
    if (c.kind == "normal") {
      ++(c.reason.empty() || c.reason.starts_with("bilinear") ? out.answered : out.normal_only);
      in_sequence = false;
      continue;
    }
    Tangential a, b;
    if (c.kind.starts_with("fastsim")) {
      a = fastsim(c, 1), b = fastsim(c, 2);
    } else if (c.kind.starts_with("steady")) {
      a = steady(c, *same, true), b = steady(c, *fine, false);
    } else {
      if (c.fresh == 2 || !in_sequence) {
        history.start(c, *same);
        fine_history.start(c, *fine);
      }
      in_sequence = stepped = true;
      a = history.step(c);
      b = fine_history.step(c);
    }
    ++out.answered;
    const double bound = c.mu * c.fn;
    const double radius = std::sqrt(same->area / units::pi) / mm;
    if (!std::isfinite(c.fx_share))
      compare("longitudinal force", c.fx, a.fx, b.fx, bound);
    else
      compare("creepage or shift of a given force", c.motion_x, a.motion, b.motion, 0);
    compare("lateral force", c.fy, a.fy, b.fy, bound);
    compare("moment", c.mz, a.mz / mm, b.mz / mm, bound * radius);
    if (c.contact_cells > 0 && !c.kind.starts_with("fastsim"))
      compare("stick area", c.stick_cells / c.contact_cells, a.stick, b.stick, 1);
  }
  return out;
}

}  // namespace railbook::peer_bank
