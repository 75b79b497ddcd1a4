// The bank's wheels: S1002 on 60E1 of the Manchester benchmark, case A2.2 (wheels.csv), and our
// answers.
#pragma once

#include <string>
#include <vector>

#include "comparison.hpp"

namespace railbook::peer_bank {

// The comparisons of every row of the table; each row is one case. `same` is solved on about as
// many cells as the bank's 0.2 mm make, `fine` on 64 by 64. A wheel on which we find two patches
// and the bank one is not compared. Throws std::runtime_error when a wheel is not solved.
struct WheelAnswers {
  std::vector<Comparison> comparisons;
  int answered = 0;
};
WheelAnswers answer_wheels(const std::string& file);

}  // namespace railbook::peer_bank
