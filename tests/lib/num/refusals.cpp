// What the numerics refuse, and the ends of what they take.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <new>

#include <railbook/num/banded.hpp>
#include <railbook/num/dense_lu.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/num/even_filter.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/num/gmres.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("input: sizes of transforms, frames and rules") {
  CHECK_THROWS_WITH(num::RealFft(0), Contains("transform length is 0; allowed: 1 to 2^31 - 1"));
  CHECK_THROWS_AS(num::RealFft(std::size_t{1} << 31), InputError);
  CHECK_THROWS_AS(num::RealFft2d(3, 0), InputError);
  CHECK_THROWS_AS(num::RealFft2d(0, 3), InputError);
  CHECK_THROWS_WITH(num::EvenFilter(4, 3, 3, 6),
                    Contains("frame of the filter is 3 long; allowed: 4 to"));
  CHECK_THROWS_AS(num::EvenFilter(4, 3, 8, 2), InputError);
  CHECK_THROWS_AS(num::EvenFilter(0, 0, 0, 1), InputError);
  CHECK_THROWS_AS(num::EvenFilter(4, 3, std::size_t{1} << 31, 4), InputError);
  CHECK_THROWS_AS(num::EvenFilter(4, 3, 4, std::size_t{1} << 31), InputError);
  CHECK_NOTHROW(num::EvenFilter(4, 3, 4, 3));
  CHECK_THROWS_WITH(num::gauss_legendre(0), Contains("n is 0; allowed: at least 1"));
  const num::GaussRule one = num::gauss_legendre(1, 2, 6);
  CHECK(one.x[0] == 4);
  CHECK(one.w[0] == 4);
  CHECK(num::good_fft_size(0) == 1);
  CHECK(num::good_fft_size(121) == 125);
#ifndef __SANITIZE_ADDRESS__  // which ends the program instead
  CHECK_THROWS_AS(num::Workspace(std::size_t{1} << 58), std::bad_alloc);
#endif
}

TEST_CASE("input: a banded matrix without a positive pivot is named with its row") {
  for (const int m : {1, 3}) {  // the general band and the beam's
    Eigen::MatrixXd band = Eigen::MatrixXd::Zero(m + 1, 5);
    band.row(0).setConstant(2);
    band.row(1).setConstant(-1);
    CHECK_NOTHROW(num::BandedCholesky(band, "chain"));
    band(0, 0) = band(0, 4) = 1;  // a chain without a support: singular, but for rounding
    CHECK_THROWS_WITH(num::BandedCholesky(band, "chain"),
                      Contains("chain: no pivot left in row 5 of 5"));
    band(0, 2) = -3;
    CHECK_THROWS_WITH(num::BandedCholesky(band, "chain"), Contains("in row 3 of 5"));
    band(0, 1) = std::nan("");
    CHECK_THROWS_WITH(num::BandedCholesky(band, "chain"), Contains("in row 2 of 5"));
  }
}

TEST_CASE("input: a singular dense matrix has no sign and no solution") {
  num::DenseLu lu;
  Eigen::Matrix3d a;
  a << 1, 2, 3, 2, 4, 6, 1, 0, 1;
  lu.factor(a);
  CHECK(lu.sign() == 0);
  Eigen::VectorXd b = Eigen::Vector3d{1, 2, 3};
  lu.solve_in_place(b);
  CHECK(b.array().isNaN().all());
  a << 0, 1, 0, 1, 0, 0, 0, 0, 1;  // one exchange of rows
  lu.factor(a);
  CHECK(lu.sign() == -1);
  a(0, 1) = -1;
  lu.factor(a);
  CHECK(lu.sign() == 1);
  a(2, 2) = -1;
  lu.factor(a);
  CHECK(lu.sign() == -1);
}

TEST_CASE("input: eigenvalues of a matrix that holds NaN are refused") {
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(3, 3);
  a(1, 2) = std::nan("");
  CHECK_THROWS_AS(num::eigenvalues(a), std::runtime_error);
  CHECK_THROWS_AS(num::eigenpairs(a), std::runtime_error);
  CHECK_THROWS_AS(num::symmetric_eigenvalues(a), std::runtime_error);
}

TEST_CASE("input: what a Krylov method says when it cannot") {
  const auto copy = [](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = in; };
  const Eigen::VectorXd b = Eigen::Vector3d{3, 0, 4};
  const num::Gmres nothing = num::gmres(copy, copy, Eigen::Vector3d::Zero(), 1e-10, 5);
  CHECK(nothing.converged);
  CHECK(nothing.iterations == 0);
  CHECK(nothing.x == Eigen::Vector3d::Zero());
  CHECK_FALSE(num::gmres(copy, copy, b, 1e-10, 0).converged);
  const num::Gmres exact = num::gmres(copy, copy, b, 1e-10, 9);
  CHECK(exact.converged);
  CHECK(exact.iterations == 1);
  CHECK((exact.x - b).norm() < 1e-15);
  // A turns e1 to e2 to e3 to e1: no iterate before the third is nearer than x = 0.
  const auto turn = [](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
    out = Eigen::Vector3d{in[2], in[0], in[1]};
  };
  const Eigen::VectorXd e1 = Eigen::Vector3d{1, 0, 0};
  const num::Gmres stuck = num::gmres(turn, copy, e1, 1e-10, 2);
  CHECK_FALSE(stuck.converged);
  CHECK(stuck.iterations == 2);
  CHECK(stuck.residual == Approx(1));
  const num::Gmres turned = num::gmres(turn, copy, e1, 1e-10, 9);
  CHECK(turned.converged);
  CHECK(turned.iterations == 3);
  CHECK((turned.x - Eigen::Vector3d{0, 0, 1}).norm() < 1e-15);
  const auto zero = [](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = 0 * in; };
  const num::Gmres singular = num::gmres(zero, copy, b, 1e-10, 9);
  CHECK_FALSE(singular.converged);
  CHECK(singular.x == Eigen::Vector3d::Zero());
  CHECK(singular.residual == 1);
}

TEST_CASE("input: integrals to either infinity, and limits of accuracy") {
  const double inf = std::numeric_limits<double>::infinity();
  const auto tail = [](double x) { return 1 / (1 + x * x); };
  CHECK(num::integrate(tail, 1, inf).value == Approx(units::pi / 4).epsilon(1e-10));
  CHECK(num::integrate(tail, -inf, 1).value == Approx(3 * units::pi / 4).epsilon(1e-10));
  CHECK(num::integrate(tail, -inf, inf).value == Approx(units::pi).epsilon(1e-10));
  const num::Integral loose = num::integrate(tail, 0, 1, 1e-3);
  CHECK(loose.evaluations == 21);  // the first rule suffices
  CHECK(loose.converged);
  CHECK_NOTHROW(num::check_gsl(15, "underflow"));
  CHECK_THROWS_WITH(num::check_gsl(1, "range"), Contains("range: "));
}

TEST_CASE("input: a root at an end of the bracket, and the width of one within") {
  const auto line = [](double x) { return x - 2; };
  for (const num::Root& root : {num::find_root(line, 2, 5), num::find_root(line, -1, 2)}) {
    CHECK(root.x == 2);
    CHECK(root.width == 0);
    CHECK(root.converged);
    CHECK(root.evaluations == 2);
  }
  const auto cubic = [](double x) { return x * x * x - 2; };
  for (const double relative : {1e-3, 1e-6, 1e-12}) {
    const num::Root root = num::find_root(cubic, 0, 5, relative);
    CHECK(root.converged);
    CHECK(root.width <= relative * root.x);
    CHECK(std::abs(root.x - std::cbrt(2.0)) <= root.width);
  }
  CHECK_THROWS_WITH(num::find_root(cubic, 2, 5), Contains("no change of sign between 2.0"));
  CHECK_THROWS_AS(num::find_root([](double x) { return x < 1 ? -1.0 : std::nan(""); }, 0, 5),
                  InputError);
}
