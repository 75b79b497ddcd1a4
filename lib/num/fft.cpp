#include <railbook/num/fft.hpp>

#include <fftw3.h>

#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include <railbook/num/detail/fftw_plan.hpp>
#include <railbook/num/gsl.hpp>
#include <railbook/units/input_error.hpp>

// FFTW ends the program where it finds no memory, by this function of its own: ours takes its
// place, and what comes of it is what comes of any lack of memory.
extern "C" [[noreturn]] void fftw_assertion_failed(const char* what, int line, const char* file);
extern "C" void fftw_assertion_failed(const char* what, int line, const char* file) {
  if (std::string_view{file}.ends_with("alloc.c")) throw std::bad_alloc{};
  throw railbook::num::NumericalError{std::string{"FFTW: "} + file + ", line " +
                                      std::to_string(line) + ": " + what};
}

namespace railbook::num {
namespace {

struct FftwFree {
  void operator()(double* p) const { fftw_free(p); }
};
using Buffer = std::unique_ptr<double[], FftwFree>;

Buffer allocate(std::size_t doubles) {
  Buffer buffer{fftw_alloc_real(doubles)};
  if (!buffer) throw std::bad_alloc{};
  for (std::size_t i = 0; i < doubles; ++i) buffer[i] = 0.0;
  return buffer;
}

std::mutex planner;

int checked_size(std::size_t n) {
  if (n < 1 || n > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError{"transform length is " + std::to_string(n) + "; allowed: 1 to 2^31 - 1"};
  return static_cast<int>(n);
}

}  // namespace

void FftwPlanFree::operator()(fftw_plan_s* p) const {
  const std::lock_guard one_at_a_time(planner);
  fftw_destroy_plan(p);
}

FftwPlan plan(const std::function<fftw_plan_s*()>& make) {
  const std::lock_guard one_at_a_time(planner);
  FftwPlan made{make()};
  if (!made) throw NumericalError{"FFTW made no plan"};
  return made;
}

std::size_t good_fft_size(std::size_t n) {
  for (std::size_t size = n > 0 ? n : 1;; ++size) {
    std::size_t rest = size;
    for (std::size_t prime : {2U, 3U, 5U, 7U})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return size;
  }
}

struct RealFft::Plan {
  std::size_t n;
  Buffer real;
  Buffer spectrum;
  FftwPlan forward;
  FftwPlan inverse;
};

RealFft::RealFft(std::size_t n) : plan_(std::make_unique<Plan>()) {
  const int size = checked_size(n);
  plan_->n = n;
  plan_->real = allocate(n);
  plan_->spectrum = allocate(2 * (n / 2 + 1));
  auto* complex = reinterpret_cast<fftw_complex*>(plan_->spectrum.get());
  plan_->forward = plan([&] {
    return fftw_plan_dft_r2c_1d(size, plan_->real.get(), complex,
                                FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  });
  plan_->inverse =
      plan([&] { return fftw_plan_dft_c2r_1d(size, complex, plan_->real.get(), FFTW_ESTIMATE); });
}
RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

std::size_t RealFft::size() const {
  return plan_->n;
}
std::span<double> RealFft::real() {
  return {plan_->real.get(), plan_->n};
}
std::span<std::complex<double>> RealFft::spectrum() {
  return {reinterpret_cast<std::complex<double>*>(plan_->spectrum.get()), plan_->n / 2 + 1};
}
void RealFft::forward() {
  fftw_execute(plan_->forward.get());
}
void RealFft::inverse() {
  fftw_execute(plan_->inverse.get());
}

struct ComplexFft::Plan {
  std::size_t n;
  Buffer values = allocate(2 * n), next = allocate(2 * n);
  FftwPlan forward = {}, inverse = {};

  // From one buffer into the other, which is faster than in place.
  void execute(const FftwPlan& plan) {
    fftw_execute_dft(plan.get(), complex(values.get()), complex(next.get()));
    std::swap(values, next);
  }
};

ComplexFft::ComplexFft(std::size_t n) : plan_(new Plan{static_cast<std::size_t>(checked_size(n))}) {
  fftw_complex *from = complex(plan_->values.get()), *to = complex(plan_->next.get());
  const auto make = [&](int sign) {
    return plan([&] {
      return fftw_plan_dft_1d(static_cast<int>(n), from, to, sign,
                              FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
    });
  };
  plan_->forward = make(FFTW_FORWARD);
  plan_->inverse = make(FFTW_BACKWARD);
}
ComplexFft::~ComplexFft() = default;
ComplexFft::ComplexFft(ComplexFft&&) noexcept = default;
ComplexFft& ComplexFft::operator=(ComplexFft&&) noexcept = default;
std::span<std::complex<double>> ComplexFft::values() {
  return {reinterpret_cast<std::complex<double>*>(plan_->values.get()), plan_->n};
}
void ComplexFft::forward() {
  plan_->execute(plan_->forward);
}
void ComplexFft::inverse() {
  plan_->execute(plan_->inverse);
}

struct RealFft2d::Plan {
  std::size_t rows;
  std::size_t columns;
  Buffer buffer;
  FftwPlan forward;
  FftwPlan inverse;
};

RealFft2d::RealFft2d(std::size_t rows, std::size_t columns) : plan_(std::make_unique<Plan>()) {
  const int n0 = checked_size(rows);
  const int n1 = checked_size(columns);
  plan_->rows = rows;
  plan_->columns = columns;
  plan_->buffer = allocate(rows * stride());
  auto* complex = reinterpret_cast<fftw_complex*>(plan_->buffer.get());
  plan_->forward = plan(
      [&] { return fftw_plan_dft_r2c_2d(n0, n1, plan_->buffer.get(), complex, FFTW_ESTIMATE); });
  plan_->inverse = plan(
      [&] { return fftw_plan_dft_c2r_2d(n0, n1, complex, plan_->buffer.get(), FFTW_ESTIMATE); });
}
RealFft2d::~RealFft2d() = default;
RealFft2d::RealFft2d(RealFft2d&&) noexcept = default;
RealFft2d& RealFft2d::operator=(RealFft2d&&) noexcept = default;

std::size_t RealFft2d::rows() const {
  return plan_->rows;
}
std::size_t RealFft2d::columns() const {
  return plan_->columns;
}
std::size_t RealFft2d::stride() const {
  return 2 * (plan_->columns / 2 + 1);
}
double* RealFft2d::row(std::size_t i) {
  return plan_->buffer.get() + i * stride();
}
std::span<double> RealFft2d::real() {
  return {plan_->buffer.get(), plan_->rows * stride()};
}
std::span<std::complex<double>> RealFft2d::spectrum() {
  return {reinterpret_cast<std::complex<double>*>(plan_->buffer.get()),
          plan_->rows * (plan_->columns / 2 + 1)};
}
void RealFft2d::forward() {
  fftw_execute(plan_->forward.get());
}
void RealFft2d::inverse() {
  fftw_execute(plan_->inverse.get());
}

}  // namespace railbook::num
