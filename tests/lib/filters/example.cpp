#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/filters/hybrid_filter.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: a hybrid filter on uneven samples") {
  // example
  // the digital filter takes the analog low-pass out again, whatever the time between samples
  const double corner = 10;  // rad/s
  filters::FirstOrderHybrid digital(corner);
  double analog = 0, mean = 0;
  for (const double interval : {0.05, 0.2, 0.01, 0.1}) {          // s
    analog += (1 - analog) * (1 - std::exp(-corner * interval));  // a step from 0 to 1
    mean = digital.push(analog, interval);                        // of the input
  }
  // end
  CHECK(std::abs(mean - 1) < 1e-12 * std::abs(1));
}
