#include <railbook/rolling/detail/stepped_rows.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <type_traits>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/rolling/detail/cell_displacements.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::rolling {

using Eigen::Index;
using Eigen::MatrixXd;

// The rows of the lower half, j < half, each with its mirror image rows - 1 - j. What is even
// across of the tractions along and odd of those across makes strain of the same kind, and so does
// what is odd of the first and even of the second: kind 0 and 1, with the unknowns [along; across],
// 2 half long.
struct SteppedRows::Parts {
  // Complex matrices or vectors as two real ones: products of those are several times as fast.
  template <class Matrix>
  struct Split {
    Matrix re, im;
    void resize(Index height, Index width) {
      re.setZero(height, width);
      im.setZero(height, width);
    }
  };
  // The sum of both is the matrix; `main`, its first 24 bits, is near it.
  struct Influence {
    Split<Eigen::MatrixXf> main, rest;
    void put(Index i, Index j, const std::complex<double>& value) {
      const auto split = [&](double part, Eigen::MatrixXf& first, Eigen::MatrixXf& second) {
        first(i, j) = static_cast<float>(part);
        second(i, j) = static_cast<float>(part - static_cast<double>(first(i, j)));
      };
      split(value.real(), main.re, rest.re);
      split(value.imag(), main.im, rest.im);
    }
  };

  Index n = 0, rows = 0, half = 0, frequencies = 0;
  std::unique_ptr<num::RealFft> fft;
  std::array<std::vector<Influence>, 2> influence;  // by kind and frequency
  std::array<Split<MatrixXd>, 2> in, out;           // 2 half x frequencies

  using Displacements = std::vector<Influence2>;
  void fill(const RollingMesh& mesh, double poisson);
  void put_pair(Index at, Index from, const Displacements& u, const Displacements& mirrored,
                double scale);
  template <bool exactly>
  void multiply(const Influence& k, const Split<MatrixXd>& x, Split<MatrixXd>& y, Index f) const;
  template <bool exactly>
  void apply(const Eigen::VectorXd& p, Eigen::VectorXd& strain);
};

// What row `from` does to row `at`, and with its mirror image: displacements at n - k cells, for
// k = 0 .. 2n, turned into the strain u(x) - u(x + dx) at -(n - 1) to n - 1 cells.
void SteppedRows::Parts::put_pair(Index at, Index from, const Displacements& u,
                                  const Displacements& mirrored, double scale) {
  const auto size = static_cast<Index>(fft->size());
  double* const samples = fft->real().data();
  const std::complex<double>* const spectrum = fft->spectrum().data();
  for (const auto part : {&Influence2::xx, &Influence2::yy, &Influence2::xy})
    for (const int odd : {0, 1}) {
      std::ranges::fill(fft->real(), 0.0);
      const auto both = [&](Index k) {
        const auto at_k = static_cast<std::size_t>(k);
        return u[at_k].*part + (odd ? -1 : 1) * (mirrored[at_k].*part);
      };
      for (Index i = 1 - n; i < n; ++i)
        samples[(i + size) % size] = scale * (both(n - i) - both(n - i - 1));
      fft->forward();
      const auto put = [&](int kind, Index row, Index column) {
        for (Index f = 0; f < frequencies; ++f)
          influence[static_cast<std::size_t>(kind)][static_cast<std::size_t>(f)].put(row, column,
                                                                                     spectrum[f]);
      };
      if (part == &Influence2::xx) put(odd, at, from);
      if (part == &Influence2::yy) put(1 - odd, at + half, from + half);
      if (part == &Influence2::xy) put(odd, at + half, from), put(1 - odd, at, from + half);
    }
}

void SteppedRows::Parts::fill(const RollingMesh& mesh, double poisson) {
  n = mesh.along, rows = mesh.rows(), half = (rows + 1) / 2;
  fft = std::make_unique<num::RealFft>(num::good_fft_size(static_cast<std::size_t>(2 * n)));
  frequencies = static_cast<Index>(fft->size() / 2 + 1);
  for (auto& kind : influence) {
    kind.resize(static_cast<std::size_t>(frequencies));
    for (Influence& matrix : kind)
      for (auto* part : {&matrix.main, &matrix.rest}) part->resize(2 * half, 2 * half);
  }
  for (auto* columns : {&in, &out})
    for (auto& kind : *columns) kind.resize(2 * half, frequencies);
  const double dx = mesh.dx[0], scale = 1 / (units::pi * dx * static_cast<double>(fft->size()));
  const auto size = static_cast<std::size_t>(2 * n + 1);
  Displacements u(size), mirrored(size);
  const Displacements none(size);
  for (Index at = 0; at < half; ++at)
    for (Index from = at; from < half; ++from) {
      const Index image = rows - 1 - from;
      const auto displacements = [&](Index row, Displacements& to) {
        row_displacements(mesh.x0[at] - mesh.x0[row] + static_cast<double>(n) * dx,
                          mesh.y[at] - mesh.y[row], dx, mesh.dy[0], poisson, to);
      };
      displacements(from, u);
      displacements(image, mirrored);
      put_pair(at, from, u, image == from ? none : mirrored, scale);
      if (at == from) continue;
      // The other way round: x changes its sign, and y but for the mirror image.
      std::ranges::reverse(u);
      std::ranges::reverse(mirrored);
      for (Influence2& value : mirrored) value.xy = -value.xy;
      put_pair(from, at, u, mirrored, scale);
    }
}

// y = K x of a frequency. Two columns at once: what takes the time is reading the matrix, so it is
// read once.
template <bool exactly>
void SteppedRows::Parts::multiply(const Influence& k, const Split<MatrixXd>& x, Split<MatrixXd>& y,
                                  Index f) const {
  using Real = std::conditional_t<exactly, double, float>;
  const Index size = 2 * half;  // even
  Eigen::Matrix<Real, Eigen::Dynamic, 1> sum_re, sum_im;
  sum_re.setZero(size), sum_im.setZero(size);
  Real *const y_re = sum_re.data(), *const y_im = sum_im.data();
  for (Index j = 0; j < size; j += 2) {
    const auto a0 = static_cast<Real>(x.re(j, f)), b0 = static_cast<Real>(x.im(j, f));
    const auto a1 = static_cast<Real>(x.re(j + 1, f)), b1 = static_cast<Real>(x.im(j + 1, f));
    const float *re = k.main.re.col(j).data(), *im = k.main.im.col(j).data();
    const float *more_re = k.rest.re.col(j).data(), *more_im = k.rest.im.col(j).data();
    for (Index i = 0; i < size; ++i) {
      const Index next = i + size;
      Real re0 = re[i], im0 = im[i], re1 = re[next], im1 = im[next];
      if constexpr (exactly)
        re0 += more_re[i], im0 += more_im[i], re1 += more_re[next], im1 += more_im[next];
      y_re[i] += (re0 * a0 - im0 * b0) + (re1 * a1 - im1 * b1);
      y_im[i] += (re0 * b0 + im0 * a0) + (re1 * b1 + im1 * a1);
    }
  }
  y.re.col(f) = sum_re.template cast<double>();
  y.im.col(f) = sum_im.template cast<double>();
}

SteppedRows::SteppedRows(const RollingMesh& mesh, double poisson)
    : parts_(std::make_unique<Parts>()) {
  parts_->fill(mesh, poisson);
}
SteppedRows::~SteppedRows() = default;

void SteppedRows::apply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const {
  parts_->apply<true>(p, strain);
}
void SteppedRows::approximate(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const {
  parts_->apply<false>(p, strain);
}

template <bool exactly>
void SteppedRows::Parts::apply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) {
  const Index cells = n * rows;
  double* const samples = fft->real().data();
  std::complex<double>* const spectrum = fft->spectrum().data();
  const auto row = [&](auto& v, Index part, Index j) { return v.data() + part * cells + j * n; };
  const auto each = [&](auto&& visit) {
    for (Index part = 0; part < 2; ++part)
      for (Index j = 0; j < half; ++j) visit(part, j, rows - 1 - j);
  };
  each([&](Index part, Index j, Index mirror) {
    const double *one = row(p, part, j), *other = row(p, part, mirror);
    for (int odd = 0; odd < 2; ++odd) {
      std::ranges::fill(fft->real(), 0.0);
      for (Index i = 0; i < n; ++i) samples[i] = (odd ? one[i] - other[i] : one[i] + other[i]) / 2;
      fft->forward();
      Split<MatrixXd>& to = in[static_cast<std::size_t>(odd ^ part)];
      for (Index f = 0; f < frequencies; ++f) {
        const std::complex<double> value = spectrum[f];
        to.re(part * half + j, f) = value.real(), to.im(part * half + j, f) = value.imag();
      }
    }
  });
  for (std::size_t kind = 0; kind < 2; ++kind)
    for (Index f = 0; f < frequencies; ++f)
      multiply<exactly>(influence[kind][static_cast<std::size_t>(f)], in[kind], out[kind], f);
  strain.resize(2 * cells);
  each([&](Index part, Index j, Index mirror) {
    double *one = row(strain, part, j), *other = row(strain, part, mirror);
    for (int odd = 0; odd < 2; ++odd) {
      const Split<MatrixXd>& from = out[static_cast<std::size_t>(odd ^ part)];
      for (Index f = 0; f < frequencies; ++f)
        spectrum[f] = {from.re(part * half + j, f), from.im(part * half + j, f)};
      fft->inverse();
      for (Index i = 0; i < n; ++i) {
        const double value = samples[i];
        if (odd)
          one[i] += value, other[i] -= mirror == j ? 0 : value;
        else
          one[i] = other[i] = value;
      }
    }
  });
}

}  // namespace railbook::rolling
