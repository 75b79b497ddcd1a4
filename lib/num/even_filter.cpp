#include <railbook/num/even_filter.hpp>

#include <fftw3.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

#include <railbook/num/detail/fftw_plan.hpp>
#include <railbook/num/parallel.hpp>

namespace railbook::num {
namespace {

// From reals to pairs, wherever they lie; made once for each length, which takes longer than a
// transform.
std::shared_ptr<fftw_plan_s> real_plan(std::size_t length) {
  static std::mutex one_at_a_time;
  static std::map<std::size_t, std::shared_ptr<fftw_plan_s>> made;
  const std::lock_guard lock(one_at_a_time);
  std::shared_ptr<fftw_plan_s>& found = made[length];
  if (!found) {
    std::vector<double> samples(2 * length + 2);
    found = plan([&] {
      return fftw_plan_dft_r2c_1d(static_cast<int>(length), samples.data(),
                                  complex(samples.data() + length), FFTW_ESTIMATE | FFTW_UNALIGNED);
    });
  }
  return found;
}

}  // namespace

struct EvenFilter::Parts {
  FrameFft fft;
  int threads;
  std::size_t height = fft.frame_rows() / 2 + 1;
  // A column of `height` after the other: the columns are filtered.
  std::vector<double> filter = std::vector<double>(fft.wave_numbers() * height);
};

EvenFilter::EvenFilter(std::size_t rows, std::size_t columns, std::size_t frame_rows,
                       std::size_t frame_columns, int threads)
    : parts_(new Parts{{rows, columns, frame_rows, frame_columns, threads}, std::max(threads, 1)}) {
}
EvenFilter::~EvenFilter() = default;
EvenFilter::EvenFilter(EvenFilter&&) noexcept = default;
EvenFilter& EvenFilter::operator=(EvenFilter&&) noexcept = default;

std::size_t EvenFilter::frame_rows() const {
  return parts_->fft.frame_rows();
}
std::size_t EvenFilter::frame_columns() const {
  return parts_->fft.frame_columns();
}
std::size_t EvenFilter::workspace() const {
  return parts_->fft.workspace();
}
double& EvenFilter::at(std::size_t v, std::size_t u) {
  return parts_->filter[u * parts_->height + v];
}

void EvenFilter::transform_kernel() {
  Parts& s = *parts_;
  const std::size_t width = s.fft.wave_numbers();
  const auto transform = [&](std::size_t length, std::size_t lines, std::size_t across,
                             std::size_t along) {
    const std::size_t both = 2 * length + 2;  // samples and their transform
    std::vector<double> buffers(both * static_cast<std::size_t>(s.threads));
    const std::shared_ptr<fftw_plan_s> of_line = real_plan(length);
    in_parallel(s.threads, lines, [&](std::size_t begin, std::size_t end, std::size_t part) {
      double *samples = buffers.data() + part * both, *found = samples + length;
      for (std::size_t k = begin; k < end; ++k) {
        double* values = s.filter.data() + k * across;
        for (std::size_t i = 0; i <= length / 2; ++i)
          samples[i] = samples[(length - i) % length] = values[i * along];
        fftw_execute_dft_r2c(of_line.get(), samples, complex(found));
        for (std::size_t i = 0; i <= length / 2; ++i) values[i * along] = found[2 * i];
      }
    });
  };
  transform(s.fft.frame_rows(), width, s.height, 1);
  transform(s.fft.frame_columns(), s.height, 1, s.height);
}

void EvenFilter::apply(const double* in, double* out, double* workspace) const {
  const Parts& s = *parts_;
  const std::size_t rows = frame_rows();
  const double norm = 1 / static_cast<double>(rows * frame_columns());
  s.fft.apply(in, out, workspace, [&](std::size_t u, double* column, double*) {
    const double* filter = s.filter.data() + u * s.height;
    for (std::size_t v = 0; v < rows; ++v) {
      const double factor = norm * filter[std::min(v, rows - v)];
      column[2 * v] *= factor, column[2 * v + 1] *= factor;
    }
  });
}

}  // namespace railbook::num
