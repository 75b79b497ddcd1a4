#include <railbook/contact/detail/extrapolation.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace railbook::contact {
namespace {

// Intercept at x = 0 of the weighted least-squares line through (x, v).
double intercept(const std::vector<double>& x, const std::vector<double>& v,
                 const std::vector<double>& weight) {
  double s = 0, sx = 0, sxx = 0, sv = 0, sxv = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    s += weight[k], sx += weight[k] * x[k], sxx += weight[k] * x[k] * x[k];
    sv += weight[k] * v[k], sxv += weight[k] * x[k] * v[k];
  }
  return (sxx * sv - sx * sxv) / (s * sxx - sx * sx);
}

}  // namespace

Extrapolated extrapolate(const std::vector<double>& h, const std::vector<double>& v, double order) {
  Extrapolated result;
  const std::size_t n = v.size();
  result.value = v.back();
  if (n < 2) {
    result.error = std::abs(result.value);
    return result;
  }
  std::vector<double> x, y, weight;
  for (std::size_t k = n - std::min<std::size_t>(n, 3); k < n; ++k) {
    const double t = h[k] / h.back();
    x.push_back(std::pow(t, order));
    y.push_back(v[k]);
    weight.push_back(std::pow(t, -5.0));
  }
  result.value = intercept(x, y, weight);
  const std::size_t m = x.size();
  const double of_two = (x[m - 2] * y[m - 1] - x[m - 1] * y[m - 2]) / (x[m - 2] - x[m - 1]);
  const double removed = std::abs(result.value - v.back());
  result.error = m == 2 ? removed : 2 * std::abs(result.value - of_two) + 0.3 * removed;
  return result;
}

}  // namespace railbook::contact
