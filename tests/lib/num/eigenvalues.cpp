#include <railbook/num/eigenvalues.hpp>

#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <stdexcept>

using namespace railbook;

TEST_CASE("eigenvalues of a rotation, of a symmetric matrix, and of none", "[num][unit]") {
  Eigen::MatrixXd turn(2, 2);
  turn << 3, -4, 4, 3;  // 3 +- 4i
  const Eigen::VectorXcd pair = num::eigenvalues(turn);
  CHECK(pair[0].real() == Approx(3).epsilon(1e-14));
  CHECK(pair[0].imag() == Approx(4).epsilon(1e-14));
  CHECK(pair[1] == std::conj(pair[0]));

  Eigen::MatrixXd spring(3, 3);
  spring << 2, -1, 0, -1, 2, -1, 0, -1, 2;  // 2 - sqrt 2, 2, 2 + sqrt 2
  const Eigen::VectorXd ascending = num::symmetric_eigenvalues(spring);
  CHECK(ascending[0] == Approx(2 - std::sqrt(2.0)).epsilon(1e-14));
  CHECK(ascending[1] == Approx(2).epsilon(1e-14));
  CHECK(ascending[2] == Approx(2 + std::sqrt(2.0)).epsilon(1e-14));

  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int n = 2; n <= 40; ++n) {
    const Eigen::VectorXcd all =
        num::eigenvalues(Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(random); }));
    for (Eigen::Index k = 0; k < n; ++k) {
      if (all[k].imag() == 0) continue;
      CHECK(all[k].imag() > 0);
      REQUIRE(k + 1 < n);
      CHECK(all[k + 1] == std::conj(all[k]));
      CHECK(std::abs(all[k + 1]) == std::abs(all[k]));
      ++k;
    }
  }

  turn(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(num::eigenvalues(turn), std::runtime_error);
}

TEST_CASE("eigenpairs satisfy what defines them", "[num][property]") {
  Eigen::MatrixXd a(3, 3);
  a << 1, 2, 0, -3, 0.5, 1, 0, 4, -2;
  const auto [values, vectors] = num::eigenpairs(a);
  for (Eigen::Index k = 0; k < 3; ++k) {
    CHECK(vectors.col(k).norm() == Approx(1));
    CHECK((a * vectors.col(k) - values[k] * vectors.col(k)).norm() < 1e-14 * a.norm());
  }
}
