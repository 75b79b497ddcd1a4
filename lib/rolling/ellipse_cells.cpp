#include <railbook/rolling/detail/ellipse_cells.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

// Integrals of l^n, l = sqrt(1 - y^2), from 0 to y.
double l1(double y) {
  return (y * std::sqrt(std::max(0.0, 1 - y * y)) + std::asin(y)) / 2;
}
double l2(double y) {
  return y - y * y * y / 3;
}
double l3(double y) {
  return (y * (5 - 2 * y * y) * std::sqrt(std::max(0.0, 1 - y * y)) + 3 * std::asin(y)) / 8;
}

}  // namespace

EllipseCells::EllipseCells(int along, int strips) {
  units::require_between("cells along rolling", along, 1, 4096);
  units::require_between("strips", strips, 1, 4096);
  for (int j = 0; j < strips; ++j) {
    const double low = -1 + 2.0 * j / strips, high = -1 + 2.0 * (j + 1) / strips;
    const double i1 = l1(high) - l1(low), i2 = l2(high) - l2(low), i3 = l3(high) - l3(low);
    const double of_y = (std::pow(std::max(0.0, 1 - low * low), 1.5) -
                         std::pow(std::max(0.0, 1 - high * high), 1.5)) /
                        3;
    strips_.push_back({.y = of_y / i1,
                       .width = high - low,
                       .growth = i2 / i1,
                       .weight = i1 * 2 / along,
                       .parabolic = 2 / units::pi * i3 / i1,
                       .elliptic = 1.5 / units::pi * i2 / i1});
  }
  for (int i = 0; i < along; ++i) {
    const double low = 1 - 2.0 * (i + 1) / along, high = 1 - 2.0 * i / along;
    parabolic_.push_back((l2(high) - l2(low)) * along / 2);
    elliptic_.push_back((l1(high) - l1(low)) * along / 2);
  }
}

CellTractions::CellTractions(bool wanted, const EllipseCells& cells, const RollingCase& c)
    : wanted_(wanted), a_(c.a), b_(c.b), unit_(c.friction * c.load / (c.a * c.b)) {
  if (!wanted) return;
  const auto n = static_cast<Eigen::Index>(cells.strips().size()) * cells.along();
  for (Eigen::VectorXd* v : {&tractions_.x, &tractions_.y, &tractions_.dx, &tractions_.dy,
                             &tractions_.px, &tractions_.py, &tractions_.bound, &tractions_.stick})
    v->resize(n);
}

void CellTractions::add(const EllipseCells::Strip& strip, double x, double px, double py,
                        double bound, bool sticks) {
  if (!wanted_) return;
  const Eigen::Index n = next_++;
  tractions_.x[n] = a_ * x;
  tractions_.y[n] = b_ * strip.y;
  tractions_.dx[n] = a_ * strip.weight / strip.width;
  tractions_.dy[n] = b_ * strip.width;
  tractions_.px[n] = unit_ * px;
  tractions_.py[n] = unit_ * py;
  tractions_.bound[n] = unit_ * bound;
  tractions_.stick[n] = sticks ? 1 : 0;
}

}  // namespace railbook::rolling
