// The accuracy that lib/num states, on seeded inputs over its range; exact values in 80-bit
// arithmetic or by construction.
#include <Eigen/Core>
#include <atomic>
#include <complex>
#include <vector>

#include <railbook/num/banded.hpp>
#include <railbook/num/dense_lu.hpp>
#include <railbook/num/dopri5.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/num/gmres.hpp>
#include <railbook/num/log_spaced.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/num/product.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/num/radau5.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/num/special.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;

namespace {

using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;

Eigen::MatrixXd random_matrix(RandomStream& draw, Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&](Eigen::Index) { return draw(-1, 1); });
}

// Q B Q^T for a product Q of plane rotations, in 80 bits.
Eigen::MatrixXd rotated(RandomStream& draw, const Eigen::MatrixXd& b) {
  LongMatrix a = b.cast<Long>();
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = i + 1; j < a.rows(); ++j) {
      const Long t = draw(0, 7), c = std::cos(t), s = std::sin(t);
      const LongMatrix rows = a;
      a.row(i) = c * rows.row(i) + s * rows.row(j), a.row(j) = c * rows.row(j) - s * rows.row(i);
      const LongMatrix columns = a;
      a.col(i) = c * columns.col(i) + s * columns.col(j);
      a.col(j) = c * columns.col(j) - s * columns.col(i);
    }
  return a.cast<double>();
}

// |A x - b| over |A| |x| + |b|, the largest norms of rows.
double backward_error(const Eigen::MatrixXd& a, const Eigen::VectorXd& x,
                      const Eigen::VectorXd& b) {
  const LongMatrix r = a.cast<Long>() * x.cast<Long>() - b.cast<Long>();
  const double scale =
      a.cwiseAbs().rowwise().sum().maxCoeff() * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff();
  return static_cast<double>(r.cwiseAbs().maxCoeff()) / scale;
}

// Si(x) by its series, or pi/2 - f cos x - g sin x with f + i g = integral of (x + i u) e^-u/(x^2 +
// u^2) du.
Long sine_integral_long(Long x) {
  if (std::abs(x) < 8) {
    Long sum = 0, term = x;
    for (int n = 0; n < 40; ++n) {
      sum += term / (2 * n + 1);
      term *= -x * x / ((2 * n + 2) * (2 * n + 3));
    }
    return sum;
  }
  Long f = 0, g = 0;
  for (int k = -72; k <= 80; ++k) {
    const Long s = k / Long{16}, u = std::exp(s - std::exp(-s));
    const Long part = std::exp(-u) * u * (1 + std::exp(-s)) / 16 / (x * x + u * u);
    f += part * x, g += part * u;
  }
  return long_pi / 2 - f * std::cos(x) - g * std::sin(x);
}

// e^(-d t) turned by w t: exactly what y' = (-d, w; -w, -d) y makes of y.
Eigen::Vector2d damped_turn(double d, double w, double t, const Eigen::Vector2d& y) {
  const Long e = std::exp(-Long{d} * t), c = std::cos(Long{w} * t), s = std::sin(Long{w} * t);
  return {static_cast<double>(e * (c * y[0] + s * y[1])),
          static_cast<double>(e * (c * y[1] - s * y[0]))};
}

}  // namespace

TEST_CASE("claim: special functions") {
  Claim quantile("num::normal_quantile"), integral("num::sine_integral");
  RandomStream draw(1);
  for (int k = 0; k < 2000; ++k) {
    // Also next to 1/2 and to 1, where the distance from there is what counts.
    const double side = k % 8 < 4 ? -1 : 1;
    const double p = k % 4 == 0   ? draw.decades(1e-300, 0.5)
                     : k % 4 == 1 ? draw(0, 1)
                     : k % 4 == 2 ? 0.5 + side * draw.decades(1e-15, 0.4)
                                  : 1 - draw.decades(1e-15, 0.5);
    const double x = num::normal_quantile(p);
    const Long z = Long{x} / std::sqrt(Long{2});
    const Long off = std::abs(p - 0.5) < 0.4 ? (std::erf(z) - 2 * (Long{p} - 0.5L)) / 2
                     : p < 0.5               ? std::erfc(-z) / 2 - p
                                             : (1 - Long{p}) - std::erfc(z) / 2;
    quantile.error(
        static_cast<double>(std::abs(off * std::sqrt(2 * long_pi) * std::exp(z * z) / x)));
    const double y =
        draw.decades(k % 2 == 0 ? 1e-8 : 1e-300, k % 2 == 0 ? 1e8 : 1e300) * (k % 3 == 0 ? -1 : 1);
    integral.relative(num::sine_integral(y),
                      y < 0 ? -sine_integral_long(-y) : sine_integral_long(y));
  }
}

TEST_CASE("claim: roots and integrals") {
  Claim roots("num::find_root"), adaptive("num::integrate"), gauss("num::gauss_legendre"),
      spaced("num::log_spaced");
  RandomStream draw(2);
  for (int k = 0; k < 1000; ++k) {
    const double r = draw.decades(1e-6, 1e6) * (k % 2 == 0 ? 1 : -1),
                 scale = draw.decades(1e-3, 10);
    const auto f = [&](double x) { return std::expm1((x - r) / std::abs(r) * scale); };
    const double low_end = r - draw(0.1, 9) * std::abs(r),
                 high_end = r + draw(0.1, 9) * std::abs(r);
    const num::Root root = num::find_root(f, low_end, high_end);
    roots.error(root.converged ? std::abs(root.x / r - 1) : INFINITY);
    // Flat, steep or bent at the root; scales from 1e-250 to 1e250.
    const double power = draw.decades(0.2, 5), unit = draw.decades(1e-250, 1e250);
    const num::Root flat = num::find_root(
        [&](double x) {
          return std::copysign(std::pow(std::abs(x - r * unit) / std::abs(r * unit), power),
                               x - r * unit);
        },
        low_end * unit, high_end * unit);
    roots.error(flat.converged ? std::abs(flat.x / (r * unit) - 1) : INFINITY);

    const double a = draw(-0.9, 6), width = draw.decades(0.01, 10), middle = draw(-1, 2),
                 s = draw.decades(0.01, 100);
    const num::Integral one = num::integrate([&](double x) { return std::pow(x, a); }, 0, 1);
    const num::Integral peak = num::integrate(
        [&](double x) { return width / (width * width + (x - middle) * (x - middle)); }, 0, 1);
    const num::Integral tail =
        num::integrate([&](double x) { return std::exp(-s * x); }, 0, INFINITY);
    if (one.converged) adaptive.relative(one.value, 1 / (1 + Long{a}));
    if (peak.converged)
      adaptive.relative(peak.value,
                        std::atan((1 - Long{middle}) / width) + std::atan(Long{middle} / width));
    if (tail.converged) adaptive.relative(tail.value, 1 / Long{s});
    const int n = 1 + k % 64, degree = static_cast<int>(draw(0, 2 * n));
    const num::GaussRule rule = num::gauss_legendre(n, 0, 1);
    gauss.relative(rule.w.dot(rule.x.array().pow(degree).matrix()), 1 / Long(degree + 1));
    const double low = draw.decades(1e-9, 1), high = low * draw.decades(1.001, 1e9);
    spaced.relative(num::log_spaced(low, high, 1 + k % 40).back(), high);
  }
}

TEST_CASE("claim: linear systems") {
  Claim banded("num::BandedCholesky"), lu("num::LuFactors"), krylov("num::gmres"),
      solved("num::solved"), product("num::product");
  RandomStream draw(3), parts(31);
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Index n = 2 + k % 19, m = k % std::min<Eigen::Index>(n, 5);
    Eigen::MatrixXd band = random_matrix(draw, m + 1, n);
    for (Eigen::Index j = 0; j < n; ++j)
      band(0, j) = draw.decades(1e-3, 1) + 2 * static_cast<double>(m);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index d = 0; d <= m; ++d)
      for (Eigen::Index j = 0; j + d < n; ++j) a(j + d, j) = a(j, j + d) = band(d, j);
    const Eigen::VectorXd b = random_matrix(draw, n, 1);
    banded.error(backward_error(a, num::BandedCholesky(band, "band").solve(b), b));

    const Eigen::MatrixXd full = random_matrix(draw, n, n);
    num::DenseLu factors;
    factors.factor(full);
    Eigen::VectorXd x = b;
    factors.solve_in_place(x);
    lu.error(backward_error(full, x, b));

    // A complex system as a real one of twice the order.
    const Eigen::MatrixXd imaginary = random_matrix(parts, n, n), c = random_matrix(parts, n, 1);
    const std::complex<double> i{0, 1};
    const Eigen::VectorXcd z = num::solved(full + i * imaginary, b + i * c).col(0);
    Eigen::MatrixXd twice(2 * n, 2 * n);
    twice << full, -imaginary, imaginary, full;
    Eigen::VectorXd parts_of_z(2 * n), right(2 * n);
    parts_of_z << z.real(), z.imag();
    right << b, c;
    solved.error(backward_error(twice, parts_of_z, right));
    solved.error(backward_error(full, num::solved(full, b).col(0), b));
    num::ComplexLu complex_factors;
    complex_factors.factor(full + i * imaginary);
    Eigen::VectorXcd in_place = b + i * c;
    complex_factors.solve_in_place(in_place);
    CHECK(in_place == z);
    CHECK(complex_factors.solve(b + i * c) == z);

    const Eigen::MatrixXd other = random_matrix(parts, n, m + 1);
    const LongMatrix exact = full.cast<Long>() * other.cast<Long>(),
                     of_imaginary = imaginary.cast<Long>() * other.cast<Long>();
    const LongMatrix size = full.cwiseAbs().cast<Long>() * other.cwiseAbs().cast<Long>() +
                            imaginary.cwiseAbs().cast<Long>() * other.cwiseAbs().cast<Long>();
    const Eigen::MatrixXcd turned = num::product(full + i * imaginary, other * i);
    product.error(double(((num::product(full, other).cast<Long>() - exact).array() / size.array())
                             .abs()
                             .maxCoeff()));
    product.error(
        double(((turned.imag().cast<Long>() - exact).array() / size.array()).abs().maxCoeff()));
    product.error(double(
        ((turned.real().cast<Long>() + of_imaginary).array() / size.array()).abs().maxCoeff()));

    // What it says of its residual, beside the residual; scaled rows, the diagonal for a
    // preconditioner.
    const Eigen::MatrixXd near = full + 3 * Eigen::MatrixXd::Identity(n, n);
    const num::Gmres found =
        num::gmres([&](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = near * in; },
                   [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
                     out = in.cwiseQuotient(near.diagonal());
                   },
                   b, draw.decades(1e-12, 1e-2), 60);
    const double residual = (b - near * found.x).norm() / b.norm();
    krylov.error(found.converged ? std::abs(residual - found.residual) : std::nan(""));
  }
}

TEST_CASE("claim: determinant's sign and a singular matrix") {
  num::DenseLu factors;
  factors.factor(Eigen::Matrix2d{{0, 1}, {1, 0}});
  CHECK(factors.sign() == -1);
  factors.factor(Eigen::Matrix2d{{2, 1}, {1, 1}});
  CHECK(factors.sign() == 1);
  CHECK(factors.least_pivot() == 0.25);  // 2 and 1/2
  factors.factor(Eigen::Matrix2d{{1, 2}, {2, 4}});
  CHECK(factors.sign() == 0);
  CHECK(factors.least_pivot() == 0);
  factors.factor(Eigen::Matrix2d::Zero());
  CHECK(factors.least_pivot() == 0);
  Eigen::VectorXd x = Eigen::Vector2d{1, 1};
  factors.solve_in_place(x);
  CHECK(x.hasNaN());

  num::ComplexLu complex_factors;
  const std::complex<double> i{0, 1};
  complex_factors.factor(Eigen::Matrix2cd{{3.0 * i, 0}, {0, 4}});
  CHECK(complex_factors.least_pivot() == 0.75);
  complex_factors.factor(Eigen::Matrix2cd{{i, 1}, {-1, i}});
  CHECK(complex_factors.least_pivot() == 0);
  Eigen::VectorXcd z = Eigen::Vector2cd{1, 1};
  complex_factors.solve_in_place(z);
  CHECK(std::isnan(z[0].real()));
}

TEST_CASE("claim: eigenvalues of normal matrices") {
  Claim general("num::eigenvalues"), pairs("num::eigenpairs"),
      symmetric("num::symmetric_eigenvalues");
  RandomStream draw(4);
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Index n = 2 + 2 * (k % 4);
    Eigen::VectorXd values = random_matrix(draw, n, 1);
    std::sort(values.begin(), values.end());
    const Eigen::MatrixXd s = rotated(draw, values.asDiagonal());
    const double size = values.cwiseAbs().maxCoeff();
    symmetric.error((num::symmetric_eigenvalues(s) - values).cwiseAbs().maxCoeff() / size);
    // Pairs a +- i b by twos.
    Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(n, n);
    std::vector<std::complex<double>> exact;
    for (Eigen::Index i = 0; i < n; i += 2) {
      const double a = draw(-1, 1), b = draw(0.1, 1);
      blocks(i, i) = blocks(i + 1, i + 1) = a, blocks(i, i + 1) = b, blocks(i + 1, i) = -b;
      exact.insert(exact.end(), {{a, b}, {a, -b}});
    }
    const Eigen::MatrixXd turned = rotated(draw, blocks);
    double off = 0;
    for (const auto& value : num::eigenvalues(turned)) {
      const auto nearest = std::min_element(exact.begin(), exact.end(), [&](auto p, auto q) {
        return std::abs(p - value) < std::abs(q - value);
      });
      off = std::max(off, std::abs(*nearest - value));
      exact.erase(nearest);  // each is found once
    }
    general.error(off);
    const num::Eigenpairs found = num::eigenpairs(turned);
    pairs.error(
        (turned * found.vectors - found.vectors * found.values.asDiagonal()).cwiseAbs().maxCoeff());
  }
}

TEST_CASE("claim: sums in blocks and parts of a loop, whatever the threads") {
  Claim sums("num::reduce_in_blocks"), loops("num::in_parallel"), items("num::map_in_parallel");
  RandomStream draw(8);
  for (int k = 0; k < 1000; ++k) {
    const auto count = static_cast<std::size_t>(draw.decades(1, k % 10 == 0 ? 1e6 : 2e4));
    const int threads = k % 5 - 1;  // 0 and -1 are one
    const auto shift = static_cast<std::uint64_t>(k);
    std::atomic<bool> empty = false;
    const double sum = num::reduce_in_blocks(
        threads, count,
        [&](std::size_t begin, std::size_t end) {
          if (begin >= end) empty = true;
          return static_cast<double>((begin + end - 1 + 2 * shift) * (end - begin) / 2);
        },
        std::plus<>{});
    sums.error(!empty && sum == static_cast<double>((count - 1 + 2 * shift) * count / 2) ? 0 : 1);
    std::vector<int> times(count % 1000);
    num::in_parallel(threads, times.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) ++times[i];
    });
    loops.error(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }) ? 0 : 1);
    const auto made = num::map_in_parallel(
        times.size(), [](std::size_t i) { return i; }, threads);
    bool same = made.size() == times.size();
    for (std::size_t i = 0; i < made.size(); ++i) same = same && made[i] == i;
    items.error(same ? 0 : 1);
  }
}

TEST_CASE("claim: random numbers by position are those of the generator that steps") {
  // SplitMix64 as published: a state that grows by a constant, hashed; a stream begins at the hash
  // of its own number.
  Claim claim("num::RandomSource");
  const auto hash = [](std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  };
  constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;
  double mean = 0, square = 0, next = 0, before = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::uint64_t stream = seed * seed;
    const num::RandomSource source(seed, stream);
    std::uint64_t state = hash(hash(seed + step) + step * (2 * stream + 1));
    for (std::uint64_t k = 0; k < 1000; ++k) {
      state += step;
      const double exact = std::ldexp(static_cast<double>(hash(state) >> 12) + 0.5, -52);
      claim.error(source.uniform(k) == exact && exact > 0 && exact < 1 ? 0 : 1);
      const double x = source.normal(k);
      mean += x, square += x * x, next += x * before, before = x;
    }
  }
  CHECK(std::abs(mean) < 3 * std::sqrt(20000.0));
  CHECK(std::abs(square - 20000) < 3 * std::sqrt(40000.0));
  CHECK(std::abs(next) < 3 * std::sqrt(20000.0));
}

TEST_CASE("claim: each step of an integrator is within its tolerance") {
  Claim explicit_steps("num::Dopri5"), implicit_steps("num::Radau5");
  RandomStream draw(6);
  for (int k = 0; k < 300; ++k) {
    const double d = draw(0, 1), w = draw(0.2, 5), tolerance = draw.decades(1e-10, 1e-4);
    const auto f = [&](double, const Eigen::Vector2d& y, Eigen::Vector2d& dy) {
      dy << -d * y[0] + w * y[1], -w * y[0] - d * y[1];
    };
    const auto jacobian = [&](double, const Eigen::Vector2d&, Eigen::Matrix2d& j) {
      j << -d, w, -w, -d;
    };
    const auto held = [&](Claim& claim, auto& solver, const auto& step) {
      for (int n = 0; n < 12 && solver.t() < 5; ++n) {
        const double t = solver.t();
        const Eigen::Vector2d y = solver.y();
        REQUIRE(step());
        const Eigen::Vector2d exact = damped_turn(d, w, solver.t() - t, y);
        claim.error((solver.y() - exact).norm() / std::sqrt(2.0) / tolerance);
      }
    };
    const Eigen::Vector2d start{draw(-1, 1), draw(-1, 1)};
    num::Dopri5<2> one(Eigen::Vector2d::Constant(tolerance), 0.01);
    one.restart(f, 0, start);
    held(explicit_steps, one, [&] { return one.step(f, 5); });
    num::Radau5<2> other(Eigen::Vector2d::Constant(tolerance), 0.01);
    other.restart(0, start);
    held(implicit_steps, other, [&] { return other.step(f, jacobian, 5); });
  }
}
