/***
### Are the equations well conditioned?

The paper blames the instability of earlier programs on their formulation, and promises equations that are not ill posed. The condition
number of the matrix (14), with exact integrals, on the last mesh of Example 1 and on one a thousand times more slender:

{{conditioning}}

It grows with the power {{condition-power}} of the number of cells across and hardly minds slenderness: at most {{digits-lost}}
digits of sixteen are lost. The equation is of the first kind, so the number must grow; it grows slowly because $1/r$ is
singular and smooths little.
*/

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "contact/countact.hpp"
#include "items.hpp"
#include "num/eigenvalues.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

// Ratio of the extreme singular values, from the eigenvalues of A^T A: squaring costs no digit that is shown here.
double condition_number(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd squares = num::symmetric_eigenvalues(matrix.transpose() * matrix);
  return std::sqrt(squares[squares.size() - 1] / squares[0]);
}

void conditioning(report::Item& item) {
  item.explained("our own study of a claim that the paper makes in words");
  item.columns({"mesh", "unknowns", "condition, Example 1", "the same, 1000 times as slender"});
  double worst = 0, first = 0, last = 0;
  for (const int n : {5, 9, 13, 25, 35}) {
    CountactOptions options;
    options.columns = uniform_columns(n);
    options.rows = n;
    const auto result =
        countact_2(rail_wheel_gap({contact_chapter::wheel_radius, contact_chapter::tread_radius,
                                   contact_chapter::crown_radius, contact_chapter::crown_radius}),
                   contact_chapter::delta_1, effective_modulus(contact_chapter::steel), options);
    ColumnMesh mesh = result.history.back().mesh;
    const Eigen::MatrixXd matrix = countact_matrix(mesh, n, true);
    mesh.half_width /= 1000;
    const double plain = condition_number(matrix);
    const double slender = condition_number(countact_matrix(mesh, n, true));
    item.add_row({fmt::format("{} x {}", n, n), fmt::format("{}", matrix.rows()),
                  fmt::format("{:.0f}", plain), fmt::format("{:.0f}", slender)});
    if (n == 9) first = plain;
    last = plain;
    worst = std::max({worst, plain, slender});
  }
  item.value("condition-power", std::log(last / first) / std::log(35.0 / 9), "", "{:.1f}");
  item.value("digits-lost", std::ceil(std::log10(worst)), "", "{:.0f}");
}

}  // namespace

void contact_chapter::add_conditioning(report::Chapter& chapter) {
  chapter.table("conditioning", "Condition number of the matrix (14)", conditioning);
}
