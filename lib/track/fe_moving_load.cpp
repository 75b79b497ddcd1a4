#include <railbook/track/fe_moving_load.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/track/moving_load.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Real = long double;  // the condition grows with the fourth power of the number of elements

// Integrals over the cubic Hermite element of unit length, unknowns (y, y') at each end, as whole
// numbers.
Matrix4d bending() {  // of v'' w''
  Matrix4d m;
  m << 12, 6, -12, 6,   //
      6, 4, -6, 2,      //
      -12, -6, 12, -6,  //
      6, 2, -6, 4;
  return m;
}
Matrix4d mass() {  // 420 times that of v w
  Matrix4d m;
  m << 156, 22, 54, -13,  //
      22, 4, 13, -3,      //
      54, 13, 156, -22,   //
      -13, -3, -22, 4;
  return m;
}
Matrix4d geometric() {  // 30 times that of v' w'
  Matrix4d m;
  m << 36, 3, -36, 3,   //
      3, 4, -3, -1,     //
      -36, -3, 36, -3,  //
      3, -1, -3, 4;
  return m;
}
Matrix4d convection() {  // 60 times that of v w', v the row
  Matrix4d m;
  m << -30, 6, 30, -6,  //
      -6, 0, 6, -1,     //
      -30, -6, 30, 6,   //
      6, 1, -6, 0;
  return m;
}

// The matrix of the steady element of length h for the unknowns (y, h y') at each end, times h^3:
// all entries of bending are exact, and the others as small beside them as they are.
std::array<std::array<Real, 4>, 4> steady_element(double theta, double zeta, double h) {
  const Real h2 = Real{h} * h, tension = Real{-4 * theta} * theta * h2 / 30,
             drag = Real{-8 * theta} * zeta * h2 * h / 60, support = h2 * h2 * 4 / 420;
  std::array<std::array<Real, 4>, 4> element;
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < 4; ++j)
      element[std::size_t(i)][std::size_t(j)] = tension * geometric()(i, j) +
                                                drag * convection()(i, j) + support * mass()(i, j) +
                                                bending()(i, j);
  return element;
}

// Elimination with partial pivoting, for the matrix is not definite, of identical elements between
// clamped ends under a `load` at the node `loaded`: (y, h y') at all nodes.
std::vector<double> solve_band(const std::array<std::array<Real, 4>, 4>& element, std::size_t nodes,
                               std::size_t loaded, Real load) {
  constexpr std::size_t band = 3, width = 2 * band + 1;
  // A row: its entries from the column that is eliminated next, the unknown of its own at first
  // `band` further; the right side.
  using Row = std::array<Real, width + 1>;
  const std::size_t n = 2 * (nodes - 2);  // the ends are clamped
  std::vector<Row> rows(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t kind = i % 2, first = std::max(i, band) - band;  // 0: y, 1: its slope
    for (std::size_t j = 0; j < 4; ++j)
      for (const std::size_t element_row : {kind, kind + 2}) {
        const std::size_t column = i + j - element_row;  // wraps below 0
        if (column < n) rows[i][column - first] += element[element_row][j];
      }
  }
  rows[2 * (loaded - 1)][width] = load;
  const auto size = [](const Row& row) { return std::abs(row[0]); };
  for (std::size_t j = 0; j < n; ++j) {
    const auto top = rows.begin() + std::ptrdiff_t(j),
               end = rows.begin() + std::ptrdiff_t(std::min(j + band + 1, n));
    std::iter_swap(top, std::ranges::max_element(top, end, {}, size));
    for (auto row = top + 1; row != end; ++row) {
      const Real factor = (*row)[0] / (*top)[0];
      for (std::size_t k = 1; k < width; ++k) (*row)[k - 1] = (*row)[k] - factor * (*top)[k];
      (*row)[width - 1] = 0;
      (*row)[width] += -(factor * (*top)[width]);
    }
  }
  std::vector<double> x(2 * nodes, 0.0);
  for (std::size_t j = n; j-- > 0;) {  // the right sides become the solution
    Real& unknown = rows[j][width];
    for (std::size_t k = 1; k < width && j + k < n; ++k)
      unknown += -(rows[j][k] * rows[j + k][width]);
    unknown = unknown / rows[j][0];
    x[j + 2] = double(unknown);
  }
  return x;
}

// The slowest rate at which a side of the shape decays: the smaller real part of its two roots.
double decay_rate(const MovingLoadSide& side) {
  const double half = 0.5 * side.damping;
  const double w2 = side.stiffness - half * half;
  return w2 >= 0 ? half : side.stiffness / (half + std::sqrt(-w2));
}

FeShape nodal_values(const double* x, std::size_t nodes, std::size_t loaded, double h) {
  FeShape fe;
  fe.unknowns = static_cast<int>(2 * nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    fe.s.push_back(h * (static_cast<double>(i) - static_cast<double>(loaded)));
    fe.y.push_back(x[2 * i]);
    fe.slope.push_back(x[2 * i + 1]);
  }
  fe.at_load = fe.y[loaded];
  return fe;
}

}  // namespace

FeShape fe_steady(double theta, double zeta, const FeSteadyOptions& options) {
  const double h = units::require_between("element length", options.element, 1e-3, 1e3, "1/beta");
  units::require_between("neglected amplitude", options.neglect, 1e-15, 0.1);
  const MovingLoadShape shape = moving_load(theta, zeta);  // for the length of the frame only
  const double reach = -std::log(options.neglect);
  const double back = std::ceil(reach / decay_rate(shape.behind) / h);
  const double front = std::ceil(reach / decay_rate(shape.ahead) / h);
  units::require_between("number of elements of the moving frame", back + front, 1.0, 2e6);
  const auto loaded = static_cast<std::size_t>(back);
  const std::size_t nodes = loaded + static_cast<std::size_t>(front) + 1;
  std::vector<double> x =
      solve_band(steady_element(theta, zeta, h), nodes, loaded, Real{h} * h * h * 8);
  for (std::size_t i = 1; i < x.size(); i += 2) x[i] /= h;
  return nodal_values(x.data(), nodes, loaded, h);
}

double largest_difference(const FeShape& fe, double theta, double zeta, double low, double high) {
  const MovingLoadShape exact = moving_load(theta, zeta);
  double worst = 0;
  for (std::size_t i = 0; i < fe.s.size(); ++i)
    if (fe.s[i] >= low && fe.s[i] <= high)
      worst = std::max(worst, std::abs(fe.y[i] - exact.deflection(fe.s[i])));
  return worst;
}

}  // namespace railbook::track
