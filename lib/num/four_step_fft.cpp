#include <railbook/num/four_step_fft.hpp>

#include <fftw3.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <railbook/num/detail/fftw_plan.hpp>
#include <railbook/num/even_filter.hpp>
#include <railbook/num/wide.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::num {
namespace {

constexpr std::size_t longest_row = 2048;  // 32 kB, the first cache

// Between rows, so that the values of a column do not fall on one place of the cache.
constexpr std::size_t gap = 8;

// The fewest rows, a divisor of n, that are short enough.
std::size_t rows_of(std::size_t n) {
  if (n < 1 || n > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError{"transform length is " + std::to_string(n) + "; allowed: 1 to 2^31 - 1"};
  std::size_t rows = 1;
  while (n % rows != 0 || n / rows > longest_row) ++rows;
  return rows;
}

// z times e or, for sense = -1, its conjugate: pairs of real and imaginary part.
RAILBOOK_AVX2_CLONES void turn(double* z, const double* e, double sense, std::size_t count) {
  for (std::size_t c = 0; c < 2 * count; c += 2) {
    const double x = z[c], y = z[c + 1], cosine = e[c], sine = sense * e[c + 1];
    z[c] = x * cosine - y * sine;
    z[c + 1] = x * sine + y * cosine;
  }
}

}  // namespace

struct FourStepFft::Parts {
  std::size_t rows, columns;
  std::size_t stride = columns + gap;
  Workspace samples{rows * stride}, line{columns};
  std::vector<double> turns = {};  // exp(-2 pi i r c / n) for the rows r = 1 .. rows/2
  FftwPlan down = {}, up = {}, along = {}, back = {};

  double* row(std::size_t r) { return samples.data() + 2 * r * stride; }
  // Row rows - r is row -r.
  void turn_row(std::size_t r, double sense) {
    if (r == 0) return;
    const bool mirrored = r > rows / 2;
    const std::size_t above = (mirrored ? rows - r : r) - 1;
    turn(row(r), turns.data() + 2 * above * columns, mirrored ? -sense : sense, columns);
  }
};

FourStepFft::FourStepFft(std::size_t n) : parts_(new Parts{rows_of(n), n / rows_of(n)}) {
  Parts& s = *parts_;
  const int tall = static_cast<int>(s.rows), wide = static_cast<int>(s.columns),
            stride = static_cast<int>(s.stride);
  const double unit = -2 * units::pi / static_cast<double>(n);
  s.turns.reserve(s.rows / 2 * 2 * s.columns);
  for (std::size_t r = 1; r <= s.rows / 2; ++r)
    for (std::size_t c = 0; c < s.columns; ++c) {
      const double angle = unit * static_cast<double>(r * c);
      s.turns.push_back(std::cos(angle));
      s.turns.push_back(std::sin(angle));
    }
  fftw_complex *z = complex(s.samples.data()), *line = complex(s.line.data());
  const auto columns = [&](int sign) {
    return plan([&] {
      return fftw_plan_many_dft(1, &tall, wide, z, nullptr, stride, 1, z, nullptr, stride, 1, sign,
                                FFTW_ESTIMATE);
    });
  };
  s.down = columns(FFTW_FORWARD);
  s.up = columns(FFTW_BACKWARD);
  s.along = plan([&] { return fftw_plan_dft_1d(wide, z, line, FFTW_FORWARD, FFTW_ESTIMATE); });
  s.back = plan([&] { return fftw_plan_dft_1d(wide, line, z, FFTW_BACKWARD, FFTW_ESTIMATE); });
}
FourStepFft::~FourStepFft() = default;
FourStepFft::FourStepFft(FourStepFft&&) noexcept = default;
FourStepFft& FourStepFft::operator=(FourStepFft&&) noexcept = default;

std::size_t FourStepFft::rows() const {
  return parts_->rows;
}
std::size_t FourStepFft::columns() const {
  return parts_->columns;
}
std::span<std::complex<double>> FourStepFft::row(std::size_t i) {
  return {reinterpret_cast<std::complex<double>*>(parts_->row(i)), parts_->columns};
}
std::size_t FourStepFft::wave_number(std::size_t row, std::size_t column) const {
  const std::size_t n = parts_->rows * parts_->columns;
  const std::size_t first = row > parts_->rows / 2 ? n - (parts_->rows - row) : row;
  return (first + parts_->rows * column) % n;
}

void FourStepFft::transform_row(std::size_t row, const Row& visit) {
  Parts& s = *parts_;
  s.turn_row(row, 1);
  fftw_execute_dft(s.along.get(), complex(s.row(row)), complex(s.line.data()));
  visit(row, {reinterpret_cast<std::complex<double>*>(s.line.data()), s.columns});
}

void FourStepFft::forward(const Row& coefficients) {
  fftw_execute(parts_->down.get());
  for (std::size_t r = 0; r < parts_->rows; ++r) transform_row(r, coefficients);
}

void FourStepFft::filter(const Row& change) {
  Parts& s = *parts_;
  fftw_execute(s.down.get());
  for (std::size_t r = 0; r < s.rows; ++r) {
    transform_row(r, change);
    fftw_execute_dft(s.back.get(), complex(s.line.data()), complex(s.row(r)));
    s.turn_row(r, -1);
  }
  fftw_execute(s.up.get());
}

}  // namespace railbook::num
