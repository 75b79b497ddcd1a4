// Products of dense matrices whose sizes are known when the program runs. Eigen compiles its kernel
// anew for every kind of factor, which takes longer than all that is computed with it; here it is
// compiled once.
#pragma once

#include <Eigen/Core>

namespace railbook::num {

// A B. Sizes must agree; backward stable, column by column.
Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                        const Eigen::Ref<const Eigen::MatrixXd>& b);
Eigen::MatrixXcd product(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                         const Eigen::Ref<const Eigen::MatrixXcd>& b);

}  // namespace railbook::num
