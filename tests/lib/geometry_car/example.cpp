#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/geometry_car/motion.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: a car measures its track") {
  // example
  // 600 m of rough track, measured at 27 m/s by sensors that err, and what the rails really are
  namespace car = geometry_car;
  const car::Track track = car::build({.length = 600});
  const car::Car t10;
  car::Motion motion{.start = 30, .speed = 27};
  motion.cruise(560);
  const car::Record clean = car::drive(track, t10, motion);
  const car::Record record = car::measured(clean, t10.layout, car::typical_sensors(), 1);
  const car::Processing processing{.layout = t10.layout};
  const car::Measurement found = car::reconstruct(record, processing);
  const car::Measurement real = car::truth(track, processing);
  // end
  const auto& profile = found[car::Parameter::profile_left];
  const auto& rail = real[car::Parameter::profile_left];
  int compared = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (!std::isfinite(profile[k])) continue;
    CHECK(std::abs(profile[k] - rail[static_cast<std::size_t>(found.mark[k] - real.mark[0])]) <
          1e-3);
    ++compared;
  }
  CHECK(compared > 500);
}
