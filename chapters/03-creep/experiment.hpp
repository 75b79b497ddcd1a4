// A synthetic experiment on the paper's rig: what its lost points may have looked like.
#pragma once

#include <vector>

namespace railbook::creep_chapter {

// Why an item with them is rebuilt.
inline constexpr const char* synthetic =
    "the paper's measured points are lost; these are synthetic, made from the theory and the "
    "stated errors";

// mu_c(N) that the synthetic wheels have; q of its power law.
inline constexpr double friction_exponent = 0.17;
double synthetic_friction(double load);

// G a b/N by Hertz's area at `load`: X = this times creep/mu_c.
double hertz_group(double load);

// The average curve of a test: mu_c and the factor on Hertz's area that fit its points best (least squares).
struct Average {
  double friction = 0;
  double area_factor = 0;
  double mu(double load, double creep) const;
};

struct Point {
  double creep = 0;
  double mu = 0;
};

// One test, at one load with one pair of wheels.
struct Test {
  double load = 0;           // [N]
  double friction = 0;       // mu_c it was made with
  double area_factor = 0;    // true area over Hertz's, by wear
  double area_measured = 0;  // the same with the error of its measurement
  std::vector<Point> points = {};
  Average average = {};
};

// Four tests, deterministic.
const std::vector<Test>& tests();

}  // namespace railbook::creep_chapter
