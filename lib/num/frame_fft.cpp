#include <railbook/num/frame_fft.hpp>

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <string>
#include <tuple>
#include <utility>
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

namespace {

struct Plans {
  FftwPlan row_forward, row_inverse, columns_forward, columns_inverse;
};

// Made once for each size of the frame: for a small one that takes as long as several transforms.
// Out of place, which FFTW does twice as fast, and columns several at once, which lie side by side
// before and one after the other when transformed.
std::shared_ptr<const Plans> plans(int tall, int wide, bool real, double* buffer, double* other) {
  static std::mutex one_at_a_time;
  static std::map<std::tuple<int, int, bool>, std::shared_ptr<const Plans>> made;
  const std::lock_guard lock(one_at_a_time);
  std::shared_ptr<const Plans>& found = made[{tall, wide, real}];
  if (found) return found;
  fftw_complex *from = complex(buffer), *to = complex(other);
  const auto row = [&](int sign) {
    return plan([&] {
      if (!real) return fftw_plan_dft_1d(wide, from, to, sign, FFTW_ESTIMATE);
      return sign == FFTW_FORWARD ? fftw_plan_dft_r2c_1d(wide, buffer, to, FFTW_ESTIMATE)
                                  : fftw_plan_dft_c2r_1d(wide, from, other, FFTW_ESTIMATE);
    });
  };
  const auto columns = [&](int sign, int stride, int distance) {
    return plan([&] {
      return fftw_plan_many_dft(1, &tall, at_once, from, nullptr, stride, distance, to, nullptr,
                                static_cast<int>(at_once) / stride, tall / distance, sign,
                                FFTW_ESTIMATE);
    });
  };
  found = std::make_shared<const Plans>(Plans{row(FFTW_FORWARD), row(FFTW_BACKWARD),
                                              columns(FFTW_FORWARD, at_once, 1),
                                              columns(FFTW_BACKWARD, 1, tall)});
  return found;
}

}  // namespace

struct FrameFft::Parts {
  std::size_t rows, columns, frame_rows, frame_columns;
  int threads;
  bool real;
  std::size_t wave_numbers = frame_columns / 2 + 1, width = real ? wave_numbers : frame_columns;
  // For each thread a row or some columns, before and after a transform.
  std::vector<std::array<std::unique_ptr<Workspace>, 2>> buffers = {};
  std::shared_ptr<const Plans> plans = {};

  void transform_row(const double* in, double* samples, double* to) const;
  void transform_row_back(double* from, double* samples, double* out) const;
};

FrameFft::FrameFft(std::size_t rows, std::size_t columns, std::size_t frame_rows,
                   std::size_t frame_columns, int threads, Values values)
    : parts_(new Parts{rows, columns, frame_rows, frame_columns, std::max(threads, 1),
                       values == Values::real}) {
  const int tall = checked_size(frame_rows, rows), wide = checked_size(frame_columns, columns);
  Parts& s = *parts_;
  const std::size_t size = std::max(s.frame_columns, at_once * frame_rows);
  s.buffers.resize(static_cast<std::size_t>(s.threads));
  for (auto& pair : s.buffers)
    for (auto& buffer : pair) {
      buffer = std::make_unique<Workspace>(size);
      std::fill_n(buffer->data(), 2 * size, 0.0);
    }
  s.plans = plans(tall, wide, s.real, s.buffers[0][0]->data(), s.buffers[0][1]->data());
}
FrameFft::~FrameFft() = default;
FrameFft::FrameFft(FrameFft&&) noexcept = default;
FrameFft& FrameFft::operator=(FrameFft&&) noexcept = default;

std::size_t FrameFft::frame_rows() const {
  return parts_->frame_rows;
}
std::size_t FrameFft::frame_columns() const {
  return parts_->frame_columns;
}
std::size_t FrameFft::workspace() const {
  return parts_->rows * parts_->width;
}

void FrameFft::Parts::transform_row(const double* in, double* samples, double* to) const {
  if (real) {
    std::copy_n(in, columns, samples);
    std::fill(samples + columns, samples + frame_columns, 0.0);
    return fftw_execute_dft_r2c(plans->row_forward.get(), samples, complex(to));
  }
  const double* imaginary = in + rows * columns;
  for (std::size_t i = 0; i < columns; ++i)
    samples[2 * i] = in[i], samples[2 * i + 1] = imaginary[i];
  std::fill(samples + 2 * columns, samples + 2 * frame_columns, 0.0);
  fftw_execute_dft(plans->row_forward.get(), complex(samples), complex(to));
}

void FrameFft::Parts::transform_row_back(double* from, double* samples, double* out) const {
  if (real) {
    fftw_execute_dft_c2r(plans->row_inverse.get(), complex(from), samples);
    std::copy_n(samples, columns, out);
    return;
  }
  fftw_execute_dft(plans->row_inverse.get(), complex(from), complex(samples));
  double* imaginary = out + rows * columns;
  for (std::size_t i = 0; i < columns; ++i)
    out[i] = samples[2 * i], imaginary[i] = samples[2 * i + 1];
}

void FrameFft::apply(const double* in, double* out, double* workspace,
                     const OfColumn& change) const {
  const Parts& s = *parts_;
  const std::size_t stride = 2 * s.width, length = 2 * s.frame_rows;
  in_parallel(s.threads, s.rows, [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t j = begin; j < end; ++j)
      s.transform_row(in + j * s.columns, s.buffers[part][0]->data(), workspace + j * stride);
  });
  const std::size_t numbers = s.real ? at_once : at_once / 2;  // of a block
  const std::size_t blocks = (s.wave_numbers + numbers - 1) / numbers;
  in_parallel(s.threads, blocks, [&](std::size_t begin, std::size_t end, std::size_t part) {
    double *const beside = s.buffers[part][0]->data(), *const columns = s.buffers[part][1]->data();
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t first = block * numbers, last = std::min(first + numbers, s.wave_numbers);
      std::array<std::size_t, at_once> at{};  // in a row of the workspace
      std::size_t count = 0;
      const auto opposite = [&](std::size_t u) { return (s.frame_columns - u) % s.frame_columns; };
      for (std::size_t u = first; u < last; ++u) {
        at[count++] = 2 * u;
        if (!s.real && opposite(u) != u) at[count++] = 2 * opposite(u);
      }
      for (std::size_t j = 0; j < s.rows; ++j) {
        const double* from = workspace + j * stride;
        double* to = beside + 2 * at_once * j;
        for (std::size_t c = 0; c < count; ++c)
          to[2 * c] = from[at[c]], to[2 * c + 1] = from[at[c] + 1];
      }
      std::fill(beside + 2 * at_once * s.rows, beside + at_once * length, 0.0);
      fftw_execute_dft(s.plans->columns_forward.get(), complex(beside), complex(columns));
      double* column = columns;
      for (std::size_t u = first; u < last; ++u) {
        const bool alone = s.real || opposite(u) == u;
        change(u, column, s.real ? nullptr : column + (alone ? 0 : length));
        column += (alone ? 1 : 2) * length;
      }
      if (!out) continue;
      fftw_execute_dft(s.plans->columns_inverse.get(), complex(columns), complex(beside));
      for (std::size_t j = 0; j < s.rows; ++j) {
        double* to = workspace + j * stride;
        const double* from = beside + 2 * at_once * j;
        for (std::size_t c = 0; c < count; ++c)
          to[at[c]] = from[2 * c], to[at[c] + 1] = from[2 * c + 1];
      }
    }
  });
  if (!out) return;
  in_parallel(s.threads, s.rows, [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t j = begin; j < end; ++j)
      s.transform_row_back(workspace + j * stride, s.buffers[part][0]->data(), out + j * s.columns);
  });
}

}  // namespace railbook::num
