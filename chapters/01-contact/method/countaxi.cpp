#include "method/countaxi.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include <railbook/contact/geometry.hpp>
#include <railbook/contact/influence.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "method/parts.hpp"

namespace railbook::contact_chapter {

using namespace contact;

namespace {

void check(const CountaxiOptions& o) {
  units::require_between("rings", o.rings, 3, 5000);
  units::require_between("grading", o.grading, 1, 10);
  units::require_between("tolerance of the boundary", o.tolerance, 1e-14, 1);
  units::require_between("iterations", o.most_iterations, 1, 1e6);
}

void place_rings(RingContact& c, const CountaxiOptions& o) {
  const int n = o.rings;
  c.edges.resize(n + 1);
  for (int k = 0; k <= n; ++k) c.edges[k] = c.radius * (1 - std::pow(1 - double(k) / n, o.grading));
  c.r = (c.edges.head(n) + c.edges.tail(n)) / 2;
}

// Rings share their edges: one disc integral for each edge and field point.
Eigen::MatrixXd ring_matrix(const RingContact& c) {
  const auto n = c.r.size();
  Eigen::MatrixXd b(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    double inner = 0;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double outer = disc_influence(c.edges[j + 1], c.r[i]);
      b(i, j) = outer - inner;
      inner = outer;
    }
  }
  return b;
}

void solve_rings(RingContact& c, const Gap& gap, double modulus) {
  const auto n = c.r.size();
  Eigen::VectorXd d(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double f = gap(c.r[i], 0);
    if (!std::isfinite(f)) throw InputError{"gap is not finite inside the contact region"};
    d[i] = (c.approach - f) * units::pi * modulus;  // eq. (16)
  }
  Eigen::MatrixXd b = ring_matrix(c);
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> lu(b);
  c.p = lu.solve(d);
  const Eigen::ArrayXd widths = c.edges.tail(n) - c.edges.head(n);
  c.force = (2 * units::pi * c.p.array() * c.r.array() * widths).sum();
  Eigen::Index at = 0;
  c.p_max = c.p.maxCoeff(&at);
  c.r_p_max = c.r[at];
  c.work += n * n;
  ++c.iterations;
}

// The radius at which the pressure asks for no move, between one too small and one too large.
class RadiusSearch {
 public:
  explicit RadiusSearch(double first) : high_{first} {}

  // The next radius, after `radius` asked for `move`; stuck: a rising edge pressure asks for more,
  // not how much.
  double next(double radius, double move, bool stuck) {
    (move > 0 || stuck ? low_ : high_) = radius;
    double candidate =
        radius + move;  // the paper's plain move, improved by the secant where there is one
    if (!stuck && known_) {
      const double slope = (move - move_before_) / (radius - radius_before_);
      if (slope < 0) candidate = radius - move / slope;
    }
    known_ = !stuck;
    radius_before_ = radius, move_before_ = move;
    const bool inside = !stuck && candidate > low_ && candidate < high_;
    return inside ? candidate : (low_ + high_) / 2;
  }
  double width() const { return high_ - low_; }

 private:
  double low_ = 0, high_, radius_before_ = 0, move_before_ = 0;
  bool known_ = false;
};

}  // namespace

RingContact countaxi(const Gap& gap, double approach, double modulus, const CountaxiOptions& o) {
  units::require_finite("approach", approach, "m");
  units::require_positive("effective modulus", modulus, "Pa");
  check(o);
  RingContact c;
  c.approach = approach;
  if (approach <= 0) {
    c.converged = true;
    c.reason = empty_contact_reason;
    return c;
  }
  const double first = interpenetration_distance(gap, approach, 0);
  const bool sharp = !std::isfinite(gap(first * (1 + 1e-9), 0));
  RadiusSearch search{first};
  double next = first;
  while (!c.converged && c.reason.empty()) {
    c.radius = next;
    place_rings(c, o);
    solve_rings(c, gap, modulus);
    const detail::Zero zero = detail::find_zero(c.r, c.p, c.radius, o.fit, false);
    if (zero.stuck && sharp && c.radius == first) {
      c.converged = true;
      c.reason = "sharp edge: the pressure there is singular";
      break;
    }
    const double move = zero.at - c.radius;
    c.converged = !zero.stuck && std::abs(move) < o.tolerance * c.radius;
    next = search.next(c.radius, move, zero.stuck);
    const bool coarse =
        std::count_if(c.r.begin(), c.r.end(), [&](double r) { return r >= c.r_p_max; }) < 3;
    if (c.converged && coarse)
      c.converged = false, c.reason = "too few rings between the largest pressure and the boundary";
    else if (!(c.p[0] > 0))
      c.converged = false, c.reason = "collapsed: no pressure is left at the centre";
    else if (!c.converged && search.width() < 0.1 * o.tolerance * c.radius)
      c.reason = "the pressure does not fall towards the boundary: too few rings there";
    else if (!c.converged && c.iterations >= o.most_iterations)
      c.reason =
          "the boundary still moves by " + std::to_string(move / c.radius) + " of the radius";
  }
  return c;
}

}  // namespace railbook::contact_chapter
