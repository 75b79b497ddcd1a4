#include <catch2/catch.hpp>

#include <railbook/vehicle/linear_stability.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: the critical speed of a freight car") {
  // example
  // the hopper car of Hull and Cooperrider on new wheels: above this speed it hunts
  const vehicle::FreightCar car = vehicle::assemble({}, vehicle::Suspension::dampers);
  const auto critical = vehicle::hopf_points({car, wheelset::new_wheel_table()}, 20, 60);  // m/s
  const double speed = critical.front().motion.speed;                                      // m/s
  const double frequency = critical.front().motion.lambda.imag();                          // rad/s
  // end
  CHECK((speed > 43 && speed < 46));
  CHECK((frequency > 11 && frequency < 13));
}
