#include <railbook/rolling/smooth_force.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::rolling {

namespace {

constexpr double half_way = 1.5;     // |t| at p = 1/sqrt(2)
constexpr double outermost = 0.995;  // |p| of creepages that stand for infinite ones
constexpr double linear_up_to = 0.05;

using Vector3 = std::array<double, 3>;

double length(const Vector3& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// What the cubic has to be asked for to give a force.
std::array<double, 2> asked(double x, double y) {
  const double size = std::min(std::hypot(x, y), 1.0);
  if (size == 0) return {0, 0};
  const double part = 3 * (1 - std::cbrt(1 - size)) / std::hypot(x, y);
  return {part * x, part * y};
}

// The linear force, bounded: what is tabulated is the difference to it.
std::array<double, 2> bounded(const Vector3& t) {
  const double x = t[0], y = t[1] + t[2], part = 1 / std::hypot(1, x / 3, y / 3);
  return {part * x, part * y};
}

// Nothing is added to the linear force where it is small.
double weight(const Vector3& t) {
  const double s = length(t);
  return s * s / (s * s + linear_up_to * linear_up_to);
}

// Keys' weights of four neighbours at u in [0, 1] between the middle ones.
std::array<double, 4> cubic_weights(double u) {
  return {0.5 * u * (-1 + u * (2 - u)), 0.5 * (2 + u * u * (-5 + 3 * u)),
          0.5 * u * (1 + u * (4 - 3 * u)), 0.5 * u * u * (u - 1)};
}

std::array<double, 4> cubic_slope_weights(double u) {
  return {0.5 * (-1 + u * (4 - 3 * u)), 0.5 * u * (-10 + 9 * u), 0.5 * (1 + u * (8 - 9 * u)),
          0.5 * u * (3 * u - 2)};
}

}  // namespace

SmoothForce::SmoothForce(const ShareFunction& theory, const KalkerCoefficients& linear, int nodes)
    : nodes_(nodes) {
  units::require_between("nodes of a half axis", nodes, 4, 100);
  const int n = nodes - 1;
  std::vector<std::array<double, 2>> values;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = -n; k <= n; ++k) {
        Vector3 p{double(i) / n, double(j) / n, double(k) / n};
        const double far = length(p);
        if (far == 0) {
          values.push_back({0, 0});
          continue;
        }
        // Outside of the unit ball nothing is looked up; the values go on as on it.
        const double inward = std::min(1.0, outermost / far);
        for (double& x : p) x *= inward;
        const double stretch = half_way / std::sqrt(1 - length(p) * length(p));
        const Vector3 t{stretch * p[0], stretch * p[1], stretch * p[2]};
        const ForceShares f = theory({t[0] / linear.c11, t[1] / linear.c22, t[2] / linear.c23});
        const auto w = asked(f.fx, f.fy), from = bounded(t);
        const double share = weight(t);
        values.push_back({(w[0] - from[0]) / share, (w[1] - from[1]) / share});
      }
  // The other signs, and one layer more: longitudinal creepage turns x, lateral creepage and spin
  // turn y.
  std::vector<std::array<double, 2>> all;
  for (int i = -n - 1; i <= n + 1; ++i)
    for (int j = -n - 1; j <= n + 1; ++j)
      for (int k = -n - 1; k <= n + 1; ++k) {
        const int x = std::min(std::abs(i), n), y = std::min(std::abs(j), n);
        const int z = std::clamp(j < 0 ? -k : k, -n, n);
        const int at = (x * nodes + y) * (2 * nodes - 1) + z + n;
        const auto& c = values[std::size_t(at)];
        all.push_back({i < 0 ? -c[0] : c[0], j < 0 ? -c[1] : c[1]});
      }
  correction_ = std::make_shared<const std::vector<std::array<double, 2>>>(std::move(all));
}

void SmoothForce::operator()(const double* linear, double* share, double* slope) const {
  const Vector3 t{linear[0], linear[1], linear[2]};
  const int n = nodes_ - 1, side = 2 * n + 3;
  const double size = length(t), r = std::hypot(half_way, size);
  std::array<std::array<double, 4>, 3> w{}, dw{};
  std::array<int, 3> first{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double p = n * t[d] / r;
    const int low = std::clamp(int(std::floor(p)), -n, n - 1);
    first[d] = low + n;  // of the node before, counted from -n - 1
    w[d] = cubic_weights(p - low);
    dw[d] = cubic_slope_weights(p - low);
  }
  double c[2] = {0, 0}, dc[2][3] = {};  // the correction, and by p
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const int start = ((first[0] + int(i)) * side + first[1] + int(j)) * side + first[2];
      const auto* line = correction_->data() + start;
      for (std::size_t m = 0; m < 2; ++m) {
        double at = 0, by = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          at += w[2][k] * line[k][m];
          by += dw[2][k] * line[k][m];
        }
        c[m] += w[0][i] * w[1][j] * at;
        dc[m][0] += dw[0][i] * w[1][j] * at;
        dc[m][1] += w[0][i] * dw[1][j] * at;
        dc[m][2] += w[0][i] * w[1][j] * by;
      }
    }
  // What the cubic is asked for, and by t.
  const auto from = bounded(t);
  const double own = weight(t), x = t[0], y = t[1] + t[2];
  const double v[2] = {from[0] + own * c[0], from[1] + own * c[1]};
  const double s = std::hypot(v[0], v[1]);
  const double part = s < 3 ? 1 - s / 3 + s * s / 27 : 1 / s;
  share[0] = part * v[0];
  share[1] = part * v[1];
  if (!slope) return;
  const double b = 1 / std::hypot(1, x / 3, y / 3), b3 = b * b * b / 9;
  const double by_own =
      2 * linear_up_to * linear_up_to / std::pow(size * size + linear_up_to * linear_up_to, 2);
  const double bend = s == 0 ? 0 : s < 3 ? (-1.0 / 3 + 2 * s / 27) / s : -1 / (s * s * s);
  for (std::size_t e = 0; e < 3; ++e) {
    const double along[2] = {e == 0 ? 1.0 : 0.0, e == 0 ? 0.0 : 1.0};
    const double turned = x * along[0] + y * along[1];
    double dv[2];
    for (std::size_t m = 0; m < 2; ++m) {
      double sum = b * along[m] - b3 * turned * (m == 0 ? x : y) + by_own * t[e] * c[m];
      for (std::size_t d = 0; d < 3; ++d)
        sum += own * dc[m][d] * n * ((d == e ? 1 / r : 0.0) - t[d] * t[e] / (r * r * r));
      dv[m] = sum;
    }
    const double longer = bend * (v[0] * dv[0] + v[1] * dv[1]);
    for (std::size_t m = 0; m < 2; ++m) slope[3 * m + e] = part * dv[m] + longer * v[m];
  }
}

std::array<double, 2> SmoothForce::at(double longitudinal, double lateral, double spin) const {
  const double linear[3] = {longitudinal, lateral, spin};
  std::array<double, 2> share{};
  (*this)(linear, share.data(), nullptr);
  return share;
}

}  // namespace railbook::rolling
