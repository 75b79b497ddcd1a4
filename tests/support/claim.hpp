// What the library says of its accuracy, held: the largest error of a function over many inputs
// against its row of tests/claims.csv, which the book prints on its Verification page.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include <railbook/num/random_stream.hpp>

namespace railbook::tests {

using num::RandomStream;
using Long = long double;
inline const Long long_pi = std::acos(Long{-1});

class Claim {
 public:
  // `least` inputs: fewer than a thousand only where each is a solver's run.
  explicit Claim(std::string function, long least = 1000)
      : function_(std::move(function)), least_(least) {
    std::ifstream rows(std::filesystem::path(__FILE__).parent_path().parent_path() / "claims.csv");
    for (std::string row; std::getline(rows, row);) {
      std::istringstream cells(row);
      std::string name, kind, bound, worst;
      std::getline(cells, name, ',') && std::getline(cells, kind, ',') &&
          std::getline(cells, bound, ',') && std::getline(cells, worst, ',');
      if (name == function_) bound_ = std::stod(bound), stated_ = std::stod(worst);
    }
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

  void error(double off) {
    ++count_;
    if (std::isnan(off)) off = std::numeric_limits<double>::infinity();
    worst_ = std::max(worst_, off);
  }
  // |found/exact - 1|, or |found| where the exact value is 0.
  void relative(Long found, Long exact) {
    const Long off = exact == 0 ? std::abs(found) : std::abs((found - exact) / exact);
    error(static_cast<double>(off));
  }

  ~Claim() {
    INFO(function_ << ": worst " << worst_ << " of " << count_ << ", stated " << stated_
                   << ", claimed " << bound_);
    CHECK(count_ >= least_);
    CHECK(worst_ <= bound_);
    // What the book prints was found here: the last digits depend on the compiler and the C
    // library.
    CHECK(worst_ <= 3 * stated_);  // no lower bound: a function may get better
  }

 private:
  std::string function_;
  double bound_ = std::numeric_limits<double>::quiet_NaN(), stated_ = bound_, worst_ = 0;
  long count_ = 0, least_;
};

}  // namespace railbook::tests
