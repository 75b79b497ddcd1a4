// A theory's creep force as a smooth function of the creepages, for codes that need its derivative:
// linear at small creepage and never beyond friction.
//
//   const SmoothForce force(shares_of(solver("full", 1, 0.3, 12), 1, 0.3), kalker_coefficients(1,
//   0.3)); const auto [x, y] = force.at(0.2, 0.5, 0.1);                 // shares of mu N
//
// What is tabulated is not the force but the vector w that the cubic of Shen, Hedrick and Elkins
// (1983) has to be asked for so that it gives the theory's force: w follows the linear force, is of
// length 3 where all slides, and its cubic never exceeds friction. Nodes are even in p =
// t/sqrt(1.5^2 + |t|^2) of the three linear forces t, so that every creepage is within the table,
// and between them cubic convolution (Keys 1981) has a continuous derivative.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <railbook/rolling/force_table.hpp>
#include <railbook/rolling/kalker_table.hpp>

namespace railbook::rolling {

class SmoothForce {
 public:
  // `theory` gives shares at reduced creepages; `linear` are the coefficients that make these of
  // the linear forces. `nodes` on each half axis, 4 to 100: the theory is called nodes^2 (2 nodes -
  // 1) times. 13 of them are within 0.06 mu N of the theory while each linear force is up to 2 mu
  // N; where spin turns against lateral creepage in full sliding, off by up to 0.7, by 0.07 rms.
  SmoothForce(const ShareFunction& theory, const KalkerCoefficients& linear, int nodes = 13);

  // `share`: longitudinal and lateral force over mu N, from the linear forces over mu N of
  // longitudinal and lateral creepage and of spin; `slope`: its derivative, row by row (6 numbers),
  // or null.
  void operator()(const double* linear, double* share, double* slope) const;
  std::array<double, 2> at(double longitudinal, double lateral, double spin) const;

 private:
  int nodes_;
  std::shared_ptr<const std::vector<std::array<double, 2>>> correction_;  // -n-1 ... n+1 each way
};

}  // namespace railbook::rolling
