#include "method/countact.hpp"

#include <gsl/gsl_linalg.h>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/influence.hpp>

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

// Example 1 in inches and psi: the half-space problem has no units of its own.
constexpr double modulus = 1.5e7 / 0.91, approach = 0.0004;
const RelativeCurvature curvature{(1 / 10.0 - 1 / 12.34) / 2, 1 / 36.0, 0};

CountactOptions square(int n) {
  CountactOptions options;
  options.columns = uniform_columns(n);
  options.rows = n;
  return options;
}

// Ratio of the largest to the smallest singular value (GSL: Eigen's SVD takes a minute to compile).
double condition(const Eigen::MatrixXd& b) {
  const auto n = static_cast<std::size_t>(b.rows());
  gsl_matrix* u = gsl_matrix_alloc(n, n);
  gsl_matrix* v = gsl_matrix_alloc(n, n);
  gsl_vector* s = gsl_vector_alloc(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      gsl_matrix_set(u, i, j, b(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  gsl_linalg_SV_decomp_jacobi(u, v, s);
  const double ratio = gsl_vector_get(s, 0) / gsl_vector_get(s, n - 1);
  gsl_matrix_free(u);
  gsl_matrix_free(v);
  gsl_vector_free(s);
  return ratio;
}

}  // namespace

TEST_CASE("unit: COUNTACT-2 on Hertz's contact, second order in F and p0") {
  const HertzContact h = hertz_from_approach(curvature, modulus, approach);
  double before = 0;
  for (int n : {7, 13, 25}) {
    const NormalContact c =
        countact_2(quadratic_gap(curvature), approach, modulus, square(n)).contact;
    REQUIRE(c.converged);
    const double error = c.force / h.force - 1;
    CHECK(std::abs(error) < 0.4 / (n * n));
    CHECK(c.p_max / h.p_max - 1 == Approx(0).margin(0.3 / (n * n)));
    CHECK(c.x_max == Approx(h.a).epsilon(0.01));
    CHECK(c.y_max == Approx(h.b).epsilon(0.01));
    if (before != 0) CHECK(before / error > 3);  // halving the cells: near 4
    before = error;
  }
}

TEST_CASE("unit: the result is the sum of its cells") {
  const auto result = countact_2(quadratic_gap(curvature), approach, modulus);
  const NormalContact& c = result.contact;
  const Eigen::ArrayXd load = c.p.array() * c.dx.array() * c.dy.array();
  CHECK(load.sum() == Approx(c.force).epsilon(1e-13));
  CHECK((c.dx.array() * c.dy.array()).sum() == Approx(c.area).epsilon(1e-13));
  CHECK(c.x.size() == 81);
  CHECK(c.p.minCoeff() > 0);
  CHECK(c.iterations == static_cast<int>(result.history.size()));
  CHECK(result.history.back().force == c.force);
  CHECK(std::isnan(c.force_error));
}

TEST_CASE("unit: the pressures satisfy eq. (14) cell by cell") {
  const NormalContact c = countact_2(quadratic_gap(curvature), approach, modulus).contact;
  const double k = 1 / (3.14159265358979323846 * modulus);
  for (Eigen::Index i = 0; i < c.x.size(); i += 7) {
    double sum = 0;
    for (Eigen::Index j = 0; j < c.x.size(); ++j) {
      const double x = c.x[j] - c.x[i], y = c.y[j] - c.y[i], u = c.dx[j] / 2, v = c.dy[j] / 2;
      sum += rectangle_influence(x - u, x + u, y - v, y + v) * c.p[j];
    }
    const double f = quadratic_gap(curvature)(c.x[i], c.y[i]);
    CHECK(k * sum == Approx(approach - f).epsilon(1e-11));
  }
}

TEST_CASE("unit: the interpenetration curve is the first candidate and encloses the contact") {
  const auto result = countact_2(quadratic_gap(curvature), approach, modulus, square(13));
  const ColumnMesh& first = result.history.front().mesh;
  CHECK(first.x_edges[13] == Approx(std::sqrt(approach / curvature.a)).epsilon(1e-13));
  CHECK(first.half_width[6] == Approx(std::sqrt(approach / curvature.b)).epsilon(1e-13));
  CHECK(result.contact.x_max < first.x_edges[13]);
  CHECK(result.contact.y_max < first.half_width[6]);
}

TEST_CASE("unit: exact cell integrals leave eq. (14) well conditioned") {
  // On a rectangle of 2:1, about the region of Example 1; growth like the square root of the
  // unknowns.
  for (auto [n, most] : {std::pair{5, 20.0}, std::pair{13, 80.0}, std::pair{21, 160.0}}) {
    ColumnMesh mesh{Eigen::VectorXd::LinSpaced(n + 1, -2, 2), Eigen::VectorXd::Ones(n)};
    const double folded = condition(countact_matrix(mesh, n, true));
    CHECK(folded > 1);
    CHECK(folded < most);
    mesh.half_width *= 0.01;  // near line contact: not much worse
    CHECK(condition(countact_matrix(mesh, n, true)) < 4 * most);
  }
}

// Converged values of an independent method (conjugate gradients with FFT on uniform grids of 144 x
// 128 up to 1152 x 1024 cells): F = 33 817.53 +- .03 lbf, M = -5295.234 +- .01 in lbf, p_max = 299
// 235 +- 15 psi.
TEST_CASE("unit: COUNTACT-1 on the jump of curvature") {
  const Gap gap = rail_wheel_gap({18, 12.34, 10, 1.25});
  CountactOptions options;
  options.columns = split_columns({12, 6, 0.2}, {8, 4, 0.2});
  options.rows = 17;
  const NormalContact two_widths = countact_1(gap, 0.005, modulus, options).contact;
  REQUIRE(two_widths.converged);
  CHECK(two_widths.force == Approx(33817.53).epsilon(1e-3));
  CHECK(two_widths.moment_y == Approx(-5295.234).epsilon(1.5e-3));
  options.columns = graded_columns(18, 12);
  const NormalContact c = countact_1(gap, 0.005, modulus, options).contact;
  REQUIRE(c.converged);
  CHECK(c.force == Approx(33817.53).epsilon(1e-3));
  CHECK(c.moment_y == Approx(-5295.234).epsilon(1.5e-3));
  CHECK(c.p_max == Approx(299235).epsilon(2e-3));
  CHECK(c.moment_x == 0);
  CHECK(c.x_p_max > 0);
  CHECK(c.x_min == Approx(-0.5684).epsilon(0.01));
  CHECK(c.x_max == Approx(0.0592).epsilon(0.02));
}

TEST_CASE("unit: the paper's mesh takes few unknowns and iterations") {
  const NormalContact c = countact_2(quadratic_gap(curvature), approach, modulus).contact;
  CHECK(c.iterations <= 8);
  CHECK(c.work == long{c.iterations} * 25 * 25);
}
