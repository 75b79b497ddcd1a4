#include <railbook/num/even_filter.hpp>

#include <fftw3.h>

#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include <railbook/num/detail/fftw_plan.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::num {
namespace {

constexpr std::size_t at_once = 8;  // columns: two lines of the cache of every row

int checked_size(std::size_t n, std::size_t least) {
  if (n < std::max<std::size_t>(least, 1) ||
      n > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError{"a frame of the filter is " + std::to_string(n) +
                     " long; allowed: " + std::to_string(least) + " to 2^31 - 1"};
  return static_cast<int>(n);
}

}  // namespace

Workspace::Workspace(std::size_t complexes) : data_(fftw_alloc_real(2 * complexes)) {
  if (!data_) throw std::bad_alloc{};
}
Workspace::~Workspace() {
  fftw_free(data_);
}

struct EvenFilter::Parts {
  std::size_t rows, columns, frame_rows, frame_columns;
  int threads;
  std::size_t width = frame_columns / 2 + 1, height = frame_rows / 2 + 1;
  std::vector<double> filter =
      {};  // a column of `height` after the other: the columns are filtered
  // Two rows of samples or a few columns, one for each thread.
  std::vector<std::unique_ptr<Workspace>> buffers = {};
  FftwPlan row_forward = {}, row_inverse = {}, column_forward = {}, column_inverse = {};
};

EvenFilter::EvenFilter(std::size_t rows, std::size_t columns, std::size_t frame_rows,
                       std::size_t frame_columns, int threads)
    : parts_(new Parts{rows, columns, frame_rows, frame_columns, std::max(threads, 1)}) {
  const int tall = checked_size(frame_rows, rows), wide = checked_size(frame_columns, columns);
  Parts& s = *parts_;
  s.filter.assign(s.width * s.height, 0.0);
  for (int k = 0; k < s.threads; ++k)
    s.buffers.push_back(std::make_unique<Workspace>(std::max(2 * s.width, at_once * frame_rows)));
  Workspace line(s.width);
  double* buffer = s.buffers[0]->data();
  fftw_complex* column = complex(buffer);
  s.row_forward =
      plan([&] { return fftw_plan_dft_r2c_1d(wide, buffer, complex(line.data()), FFTW_ESTIMATE); });
  s.row_inverse =
      plan([&] { return fftw_plan_dft_c2r_1d(wide, complex(line.data()), buffer, FFTW_ESTIMATE); });
  s.column_forward =
      plan([&] { return fftw_plan_dft_1d(tall, column, column, FFTW_FORWARD, FFTW_ESTIMATE); });
  s.column_inverse =
      plan([&] { return fftw_plan_dft_1d(tall, column, column, FFTW_BACKWARD, FFTW_ESTIMATE); });
}
EvenFilter::~EvenFilter() = default;
EvenFilter::EvenFilter(EvenFilter&&) noexcept = default;
EvenFilter& EvenFilter::operator=(EvenFilter&&) noexcept = default;

std::size_t EvenFilter::frame_rows() const {
  return parts_->frame_rows;
}
std::size_t EvenFilter::frame_columns() const {
  return parts_->frame_columns;
}
std::size_t EvenFilter::workspace() const {
  return parts_->rows * parts_->width;
}
double& EvenFilter::at(std::size_t v, std::size_t u) {
  return parts_->filter[u * parts_->height + v];
}

void EvenFilter::transform_kernel() {
  Parts& s = *parts_;
  const auto transform = [&](std::size_t length, std::size_t lines, std::size_t across,
                             std::size_t along) {
    Workspace line(length / 2 + 1);
    const FftwPlan of_line = plan([&] {
      return fftw_plan_dft_r2c_1d(static_cast<int>(length), s.buffers[0]->data(),
                                  complex(line.data()), FFTW_ESTIMATE | FFTW_UNALIGNED);
    });
    in_parallel(s.threads, lines, [&](std::size_t begin, std::size_t end, std::size_t part) {
      double *samples = s.buffers[part]->data(), *found = samples + length;
      for (std::size_t k = begin; k < end; ++k) {
        double* values = s.filter.data() + k * across;
        for (std::size_t i = 0; i <= length / 2; ++i)
          samples[i] = samples[(length - i) % length] = values[i * along];
        fftw_execute_dft_r2c(of_line.get(), samples, complex(found));
        for (std::size_t i = 0; i <= length / 2; ++i) values[i * along] = found[2 * i];
      }
    });
  };
  transform(s.frame_rows, s.width, s.height, 1);
  transform(s.frame_columns, s.height, 1, s.height);
}

void EvenFilter::apply(const double* in, double* out, double* workspace) const {
  const Parts& s = *parts_;
  const std::size_t stride = 2 * s.width;
  in_parallel(s.threads, s.rows, [&](std::size_t begin, std::size_t end, std::size_t part) {
    double* samples = s.buffers[part]->data();
    std::fill(samples + s.columns, samples + s.frame_columns, 0.0);
    for (std::size_t j = begin; j < end; ++j) {
      std::copy_n(in + j * s.columns, s.columns, samples);
      fftw_execute_dft_r2c(s.row_forward.get(), samples, complex(workspace + j * stride));
    }
  });
  const std::size_t blocks = (s.width + at_once - 1) / at_once;
  in_parallel(s.threads, blocks, [&](std::size_t begin, std::size_t end, std::size_t part) {
    double* const columns = s.buffers[part]->data();
    const std::size_t length = 2 * s.frame_rows;
    const double norm = 1 / static_cast<double>(s.frame_rows * s.frame_columns);
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t first = block * at_once, count = std::min(at_once, s.width - first);
      for (std::size_t j = 0; j < s.rows; ++j)
        for (std::size_t c = 0; c < count; ++c)
          std::copy_n(workspace + j * stride + 2 * (first + c), 2, columns + c * length + 2 * j);
      for (std::size_t c = 0; c < count; ++c) {
        double* column = columns + c * length;
        const double* filter = s.filter.data() + (first + c) * s.height;
        std::fill(column + 2 * s.rows, column + length, 0.0);
        fftw_execute_dft(s.column_forward.get(), complex(column), complex(column));
        for (std::size_t v = 0; v < s.frame_rows; ++v) {
          const double factor = norm * filter[std::min(v, s.frame_rows - v)];
          column[2 * v] *= factor, column[2 * v + 1] *= factor;
        }
        fftw_execute_dft(s.column_inverse.get(), complex(column), complex(column));
      }
      for (std::size_t j = 0; j < s.rows; ++j)
        for (std::size_t c = 0; c < count; ++c)
          std::copy_n(columns + c * length + 2 * j, 2, workspace + j * stride + 2 * (first + c));
    }
  });
  in_parallel(s.threads, s.rows, [&](std::size_t begin, std::size_t end, std::size_t part) {
    double* samples = s.buffers[part]->data();
    for (std::size_t j = begin; j < end; ++j) {
      fftw_execute_dft_c2r(s.row_inverse.get(), complex(workspace + j * stride), samples);
      std::copy_n(samples, s.columns, out + j * s.columns);
    }
  });
}

}  // namespace railbook::num
