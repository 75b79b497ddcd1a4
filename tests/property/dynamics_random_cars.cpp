#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "dynamics/linear_stability.hpp"
#include "dynamics/oscillator.hpp"
#include "num/eigenvalues.hpp"
#include "wheelrail/paper_pairs.hpp"

using namespace railbook;
using namespace railbook::dynamics;

// Data between half and twice the paper's: each critical speed is an eigenvalue of the full system there, and as many modes
// grow at the ends of the range as the critical speeds say.
TEST_CASE("linear car: the critical speeds of random cars, and no other") {
  std::mt19937 engine(1976);
  std::uniform_real_distribution<double> exponent(-1, 1);
  const auto& table = wheelrail::new_wheel_table();
  const double low = 20 * units::foot, high = 300 * units::foot;
  int points = 0;
  for (int k = 0; k < 12; ++k) {
    CarParameters data;
    for (const CarDatum& datum : car_data()) data.*datum.member *= std::exp2(exponent(engine));
    data.half_gauge = CarParameters{}.half_gauge;  // the tables', too
    const FreightCar car = assemble(data, Suspension::dampers);
    const auto eigenvalues = [&](double speed) -> Eigen::VectorXcd {
      StateMatrix jacobian;
      compile(car_on_track(car, table, speed)).jacobian(State::Zero(), jacobian);
      return num::eigenvalues(jacobian);
    };
    auto crossed = (eigenvalues(high).real().array() > 0).count() -
                   (eigenvalues(low).real().array() > 0).count();
    for (const HopfPoint& at : hopf_points({car, table}, low, high)) {
      const Complex lambda = at.motion.lambda;
      const Eigen::VectorXcd all = eigenvalues(at.motion.speed);
      CHECK((all.array() - lambda).abs().minCoeff() < 1e-9 * std::abs(lambda));
      crossed -= at.rate_by_speed.real() > 0 ? 2 : -2;
      ++points;
    }
    CHECK(crossed == 0);
  }
  CHECK(points > 12);
}
