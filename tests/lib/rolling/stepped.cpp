#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/rolling/parts.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

constexpr Creepage creepages[] = {{0.2, 0, 0}, {0.01, 0.02, 0}, {0.2, 0.05, 0.5}, {0, 0, -2}};

}  // namespace

TEST_CASE("Products between rows of one length of cell are those of the matrix", "[rolling]") {
  for (const auto& [along, rows] : {std::pair{15, 8}, {16, 7}, {3, 5}, {31, 1}})
    for (const double ratio : {0.05, 1.568, 30.0}) {
      INFO(along << " x " << rows << ", a/b " << ratio);
      const RollingGrid grid = ellipse_grid(ratio, along, rows, true, true);
      CHECK(grid.mesh.stepped());
      const Eigen::VectorXd p = Eigen::VectorXd::LinSpaced(2 * along * rows, -1, 20).array().sin();
      Eigen::VectorXd dense, fast;
      TangentialInfluence(grid.mesh, 0.3, true).apply(p, dense);
      TangentialInfluence(grid.mesh, 0.3, false).apply(p, fast);
      CHECK((dense - fast).norm() < 1e-13 * dense.norm());
    }
}

TEST_CASE("Rows of one length of cell bear the load", "[rolling]") {
  for (const double ratio : {0.05, 1.568, 30.0})
    for (const bool remedy : {true, false}) {
      const RollingGrid grid = ellipse_grid(ratio, 24, 17, remedy, true);
      CHECK((grid.bound.array() >= 0).all());
      CHECK(grid.bound.sum() * grid.mesh.dx[0] * grid.mesh.dy[0] == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("The solver by transforms gives what the matrix gives, to its tolerance", "[rolling]") {
  const RollingGrid grid = ellipse_grid(1.568, 24, 15, true, true);
  const TangentialInfluence dense(grid.mesh, 0.3, true), fast(grid.mesh, 0.3, false);
  for (const Creepage& c : creepages) {
    const StickSlip a = solve_on(dense, grid, c, {}), b = solve_on(fast, grid, c, {});
    REQUIRE(a.converged);
    REQUIRE(b.converged);
    CHECK(a.slides == b.slides);
    CHECK((a.p - b.p).norm() < 1e-9 * a.p.norm());
  }
}

TEST_CASE("Many cells and few agree within the errors they state", "[rolling]") {
  for (const double ratio : {0.4, 1.568}) {
    const EllipseRolling fitted(ratio, 0.3, {.along = 32, .rows = 16}),
        stepped(ratio, 0.3, {.along = 64, .rows = 32});
    for (const Creepage& c : creepages) {
      const RollingCase at = with_reduced_creepage(normalised_case(ratio, 0.3), c);
      const CreepForces few = fitted.solve(at), many = stepped.solve(at);
      REQUIRE(few.converged);
      REQUIRE(many.converged);
      CHECK(std::hypot(few.fx - many.fx, few.fy - many.fy) < few.error + many.error);
      CHECK(std::abs(few.mz - many.mz) < few.mz_error + many.mz_error);
    }
  }
}

TEST_CASE("128 x 128 cells take few products", "[rolling][thorough]") {
  const EllipseRolling contact(1.568, 0.3, {.along = 128, .rows = 128});
  const CreepForces f =
      contact.solve(with_reduced_creepage(normalised_case(1.568, 0.3), {0, 0, 2}));
  CHECK(f.converged);
  CHECK(f.iterations < 20);
  CHECK(f.error < 5e-4);
}
