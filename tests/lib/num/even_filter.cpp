// The blocks of columns and the shares of the threads, which small arrays do not reach.
#include <railbook/num/even_filter.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace railbook;

namespace {
double kernel(std::size_t v, std::size_t u) {
  return 1 / (1.0 + static_cast<double>(v * v + 2 * u));
}
std::vector<double> filtered(std::size_t rows, std::size_t columns, std::size_t tall,
                             std::size_t wide, int threads, const std::vector<double>& in) {
  num::EvenFilter filter(rows, columns, tall, wide, threads);
  CHECK(filter.frame_rows() == tall);
  CHECK(filter.frame_columns() == wide);
  for (std::size_t v = 0; v < rows; ++v)
    for (std::size_t u = 0; u < columns; ++u) filter.at(v, u) = kernel(v, u);
  filter.transform_kernel();
  CHECK(filter.workspace() == rows * (wide / 2 + 1));
  num::Workspace space(filter.workspace());
  std::vector<double> out(in.size());
  filter.apply(in.data(), out.data(), space.data());
  filter.apply(in.data(), out.data(), space.data());  // nothing is left from the first
  return out;
}
std::size_t apart(std::size_t a, std::size_t b) {
  return a > b ? a - b : b - a;
}
}  // namespace

TEST_CASE("property: an even filter of many columns is the sum, to the digit by any threads") {
  for (const std::size_t columns : {8U, 9U, 24U, 41U})
    for (const std::size_t rows : {1U, 2U, 7U}) {
      std::vector<double> in(rows * columns);
      for (std::size_t n = 0; n < in.size(); ++n) in[n] = std::sin(1.0 + double(n * n));
      const std::size_t tall = 2 * rows, wide = 2 * columns;
      const std::vector<double> one = filtered(rows, columns, tall, wide, 1, in);
      for (std::size_t n = 0; n < in.size(); ++n) {
        double sum = 0;
        for (std::size_t m = 0; m < in.size(); ++m)
          sum += in[m] * kernel(apart(n / columns, m / columns), apart(n % columns, m % columns));
        CHECK(one[n] == Approx(sum).margin(1e-13));
      }
      for (const int threads : {-1, 2, 5})
        CHECK(filtered(rows, columns, tall, wide, threads, in) == one);
    }
}
