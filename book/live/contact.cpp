// Chapter 1: a wheel on a rail whose crown changes its radius, pressed together at any place of it.
#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/units/constants.hpp>

#include "live.hpp"
#include "method/countact.hpp"

namespace railbook::live {
namespace {

using namespace contact;
using units::inch, units::psi;

constexpr Material steel{30e6 * psi, 0.3};

// The bodies of the paper's Example 2, touching at `place` on the rail (0: where its radius
// changes, > 0: on the corner). Depths over the plane of first touch, x from the place of first
// touch.
struct Bodies {
  double place, wheel, tread, crown, corner;

  explicit Bodies(const Inputs& in)
      : place(in["place"]),
        wheel(in["wheel"]),
        tread(in["tread"]),
        crown(in["crown"]),
        corner(in["corner"]) {}

  double rail(double x) const {  // depth of the rail's top
    const double here = place > 0 ? corner : crown, there = place > 0 ? crown : corner;
    const double depth = x * x / (2 * here), over = place + x;
    const bool beyond = place > 0 ? over < 0 : over > 0;
    return beyond ? depth + over * over / 2 * (1 / there - 1 / here) : depth;
  }
  double tread_depth(double x) const { return x * x / (2 * tread); }
  Gap gap() const {
    return [b = *this](double x, double y) {
      return y * y / (2 * b.wheel) + b.rail(x) - b.tread_depth(x);
    };
  }
  RelativeCurvature curvature() const {
    return relative_curvature({1 / (place > 0 ? corner : crown), 0}, {-1 / tread, 1 / wheel});
  }
};

std::vector<Input> with_bodies(std::vector<Input> inputs) {
  inputs.insert(inputs.end(), {{"place", "m", 0, -0.03, 0.01},
                               {"approach", "m", 0.005 * inch, 1e-6, 4e-4},
                               {"wheel", "m", 18 * inch, 0.1, 2},
                               {"tread", "m", 12.34 * inch, 0.26, 10},
                               {"crown", "m", 10 * inch, 0.01, 0.255},
                               {"corner", "m", 1.25 * inch, 0.01, 0.255}});
  return inputs;
}

void add_contact(const NormalContact& c, Answer& out) {
  out.value("force", c.force);
  out.value("p_max", c.p_max);
  out.value("x_p_max", c.x_p_max);
  out.value("area", c.area);
  out.value("x_min", c.x_min);
  out.value("x_max", c.x_max);
  out.value("y_min", c.y_min);
  out.value("y_max", c.y_max);
  out.value("converged", c.converged ? 1 : 0);
}

void contact_answer(const Inputs& in, Answer& out) {
  const Bodies bodies(in);
  const double modulus = effective_modulus(steel, steel), approach = in["approach"];
  CgFftOptions options{in.whole("cells"), in.whole("cells")};
  options.edge_x = -bodies.place;
  const NormalContact c = solve_cg_fft(bodies.gap(), approach, modulus, options).contact;
  const HertzContact h = hertz_from_approach(bodies.curvature(), modulus, approach);
  add_contact(c, out);
  out.value("force_error", c.force_error);
  // On one radius; the ellipse's own axes are x and y here.
  out.value("hertz", h.a < std::abs(bodies.place) || bodies.crown == bodies.corner ? 1 : 0);
  out.value("hertz_a", h.a);
  out.value("hertz_b", h.b);
  out.value("hertz_force", h.force);
  out.value("hertz_p_max", h.p_max);
  out.table("cells", {"x", "y", "dx", "dy", "p"});
  for (Eigen::Index i = 0; i < c.p.size(); ++i) out.row({c.x[i], c.y[i], c.dx[i], c.dy[i], c.p[i]});
  out.table("section", {"x", "rail", "wheel"});
  constexpr int n = 160;
  const double reach = std::max({0.02, -2 * c.x_min, 2 * c.x_max});
  for (int i = 0; i <= n; ++i) {
    const double x = reach * (2.0 * i / n - 1);
    out.row({x, -bodies.rail(x), -bodies.tread_depth(x) - approach});
  }
}

void countact_answer(const Inputs& in, Answer& out) {
  using namespace contact_chapter;
  const Bodies bodies(in);
  const int columns = in.whole("columns"), rows = in.whole("rows") | 1;
  const int right = 2 * columns / 5;  // 18 and 12 of 30, as for Example 2
  const CountactResult found =
      countact_1(bodies.gap(), in["approach"], effective_modulus(steel, steel),
                 {.columns = graded_columns(columns - right, right), .rows = rows});
  add_contact(found.contact, out);
  out.value("iterations", static_cast<double>(found.history.size()));
  out.table("steps", {"iteration", "force", "p_max", "move"});
  for (std::size_t k = 0; k < found.history.size(); ++k) {
    const CountactStep& s = found.history[k];
    out.row({static_cast<double>(k), s.force, s.p_max, s.move});
  }
  out.table("outlines", {"iteration", "left", "right", "half"});
  for (std::size_t k = 0; k < found.history.size(); ++k) {
    const ColumnMesh& m = found.history[k].mesh;
    for (Eigen::Index j = 0; j < m.half_width.size(); ++j)
      out.row({static_cast<double>(k), m.x_edges[j], m.x_edges[j + 1], m.half_width[j]});
  }
  out.table("cells", {"iteration", "x", "y", "dx", "dy", "p"});
  for (std::size_t k = 0; k < found.history.size(); ++k) {
    const CountactStep& s = found.history[k];
    for (Eigen::Index j = 0; j < s.p.cols(); ++j) {
      const double dy =
          2 * s.mesh.half_width[j] / 9;  // nine rows, of which the middle one is whole
      for (Eigen::Index i = 0; i < s.p.rows(); ++i)
        out.row({static_cast<double>(k), (s.mesh.x_edges[j] + s.mesh.x_edges[j + 1]) / 2,
                 static_cast<double>(i) * dy, s.mesh.x_edges[j + 1] - s.mesh.x_edges[j], dy,
                 s.p(i, j)});
    }
  }
}

}  // namespace

std::span<const Function> contact_functions() {
  static const std::array<Function, 2> all{
      {{"contact", nullptr, with_bodies({{"cells", "", 48, 8, 96}}), contact_answer},
       {"countact", nullptr, with_bodies({{"columns", "", 15, 6, 40}, {"rows", "", 9, 5, 21}}),
        countact_answer}}};
  return all;
}

}  // namespace railbook::live
