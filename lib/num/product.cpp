#include <railbook/num/product.hpp>

namespace railbook::num {

Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                        const Eigen::Ref<const Eigen::MatrixXd>& b) {
  return a * b;
}

Eigen::MatrixXcd product(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                         const Eigen::Ref<const Eigen::MatrixXcd>& b) {
  return a * b;
}

}  // namespace railbook::num
