// Fourier transforms of small arrays in larger periodic frames, there and back.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace railbook::num {

// Arrays of `rows` x `columns` (row major) in a periodic frame of at least that size, zero around
// the array: a real one, or two that are the real and the imaginary part of a complex one. The
// frame is never held whole: its empty rows are neither stored nor transformed, and its columns
// pass through the cache a few at a time.
//
// Each row and each column is transformed for itself, so that the digits do not depend on the
// number of threads.
class FrameFft {
 public:
  enum class Values { real, complex };
  FrameFft(std::size_t rows, std::size_t columns, std::size_t frame_rows, std::size_t frame_columns,
           int threads = 1, Values values = Values::real);
  ~FrameFft();
  FrameFft(FrameFft&&) noexcept;
  FrameFft& operator=(FrameFft&&) noexcept;

  std::size_t frame_rows() const;
  std::size_t frame_columns() const;
  // Wave numbers 0 .. frame_columns/2 along the rows; those of complex values come with -u.
  std::size_t wave_numbers() const { return frame_columns() / 2 + 1; }
  // Complex numbers that apply() works on.
  std::size_t workspace() const;

  // The wave number u along the rows, and frame_rows() pairs of real and imaginary part: the column
  // of u, and for complex values that of -u, which may be the same; otherwise it is null.
  using OfColumn = std::function<void(std::size_t u, double* column, double* opposite)>;
  // Transforms `in`, for complex values the real parts and then the imaginary ones; calls `change`
  // for every u, for different ones on several threads; and transforms back to `out`, which may be
  // `in`, as FFTW does: frame_rows() frame_columns() as large. Without `out` the transforms are
  // only shown.
  void apply(const double* in, double* out, double* workspace, const OfColumn& change) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// Aligned memory for `complexes` complex numbers, for FrameFft::apply.
class Workspace {
 public:
  explicit Workspace(std::size_t complexes);
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  double* data() { return data_; }

 private:
  double* data_;
};

}  // namespace railbook::num
