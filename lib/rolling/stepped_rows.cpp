#include <railbook/rolling/detail/stepped_rows.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/rolling/detail/cell_displacements.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::rolling {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// y = K x of a complex matrix, by columns, real and imaginary parts apart; n is even. Two columns
// at once: what takes the time is reading the matrix, so it is read once.
void influence_times(const double* re, const double* im, Index n, const double* x_re,
                     const double* x_im, double* __restrict y_re, double* __restrict y_im) {
  std::fill_n(y_re, n, 0.0);
  std::fill_n(y_im, n, 0.0);
  for (Index j = 0; j < n; j += 2) {
    const double *re0 = re + j * n, *im0 = im + j * n, *re1 = re0 + n, *im1 = im0 + n;
    const double a0 = x_re[j], b0 = x_im[j], a1 = x_re[j + 1], b1 = x_im[j + 1];
    for (Index i = 0; i < n; ++i) {
      y_re[i] += (re0[i] * a0 - im0[i] * b0) + (re1[i] * a1 - im1[i] * b1);
      y_im[i] += (re0[i] * b0 + im0[i] * a0) + (re1[i] * b1 + im1[i] * a1);
    }
  }
}

}  // namespace

// The rows of the lower half, j < half, each with its mirror image rows - 1 - j. What is even
// across of the tractions along and odd of those across makes strain of the same kind, and so does
// what is odd of the first and even of the second: kind 0 and 1, with the unknowns [along; across],
// 2 half long.
struct SteppedRows::Parts {
  // A complex matrix as two real ones: products of those are several times as fast.
  struct Split {
    MatrixXd re, im;
    void resize(Index height, Index width) {
      re.setZero(height, width);
      im.setZero(height, width);
    }
    void put(Index i, Index j, const std::complex<double>& value) {
      re(i, j) = value.real(), im(i, j) = value.imag();
    }
    void add(Index i, Index j, const std::complex<double>& value) {
      re(i, j) += value.real(), im(i, j) += value.imag();
    }
  };

  Index n = 0, rows = 0, half = 0, frequencies = 0;
  std::unique_ptr<num::RealFft> fft;
  std::array<std::vector<Split>, 2> influence;  // by kind and frequency
  std::array<Split, 2> in, out;                 // 2 half x frequencies

  void fill(const RollingMesh& mesh, double poisson);
  void add_pair(Index at, Index from, const std::vector<Influence2>& u, double scale);
  std::span<const std::complex<double>> spectrum(const std::vector<Influence2>& u, double scale,
                                                 double Influence2::*part);
};

// Of the strain u(x) - u(x + dx), over dx, at -(n - 1) to n - 1 cells from a cell; u[k] is n - k
// cells from it.
std::span<const std::complex<double>> SteppedRows::Parts::spectrum(const std::vector<Influence2>& u,
                                                                   double scale,
                                                                   double Influence2::*part) {
  std::ranges::fill(fft->real(), 0.0);
  const auto size = static_cast<Index>(fft->size());
  for (Index i = 1 - n; i < n; ++i) {
    const auto k = static_cast<std::size_t>(n - i);
    fft->real()[static_cast<std::size_t>((i + size) % size)] =
        scale * (u[k].*part - u[k - 1].*part);
  }
  fft->forward();
  return fft->spectrum();
}

void SteppedRows::Parts::add_pair(Index at, Index from, const std::vector<Influence2>& u,
                                  double scale) {
  const bool mirrored = from >= half;
  const Index k = mirrored ? rows - 1 - from : from;
  const double odd = mirrored ? -1 : 1;
  const auto add = [&](double Influence2::*part, Index row, Index column, bool even_first) {
    const auto s = spectrum(u, scale, part);
    for (Index f = 0; f < frequencies; ++f) {
      const auto value = s[static_cast<std::size_t>(f)];
      influence[even_first ? 0 : 1][static_cast<std::size_t>(f)].add(row, column, value);
      influence[even_first ? 1 : 0][static_cast<std::size_t>(f)].add(row, column, odd * value);
    }
  };
  add(&Influence2::xx, at, k, true);
  add(&Influence2::yy, at + half, k + half, false);
  add(&Influence2::xy, at + half, k, true);
  add(&Influence2::xy, at, k + half, false);
}

void SteppedRows::Parts::fill(const RollingMesh& mesh, double poisson) {
  n = mesh.along, rows = mesh.rows(), half = (rows + 1) / 2;
  fft = std::make_unique<num::RealFft>(num::good_fft_size(static_cast<std::size_t>(2 * n)));
  frequencies = static_cast<Index>(fft->size() / 2 + 1);
  for (auto& kind : influence) {
    kind.resize(static_cast<std::size_t>(frequencies));
    for (Split& matrix : kind) matrix.resize(2 * half, 2 * half);
  }
  for (int kind = 0; kind < 2; ++kind) {
    in[static_cast<std::size_t>(kind)].resize(2 * half, frequencies);
    out[static_cast<std::size_t>(kind)].resize(2 * half, frequencies);
  }
  const double dx = mesh.dx[0], scale = 1 / (units::pi * dx * static_cast<double>(fft->size()));
  std::vector<Influence2> u(static_cast<std::size_t>(2 * n + 1));
  for (Index at = 0; at < half; ++at)
    for (Index from = 0; from < rows; ++from) {
      row_displacements(mesh.x0[at] - mesh.x0[from] + static_cast<double>(n) * dx,
                        mesh.y[at] - mesh.y[from], dx, mesh.dy[0], poisson, u);
      add_pair(at, from, u, scale);
    }
}

SteppedRows::SteppedRows(const RollingMesh& mesh, double poisson)
    : parts_(std::make_unique<Parts>()) {
  parts_->fill(mesh, poisson);
}
SteppedRows::~SteppedRows() = default;

void SteppedRows::apply(const Eigen::VectorXd& p, Eigen::VectorXd& strain) const {
  Parts& s = *parts_;
  const Index cells = s.n * s.rows;
  const auto row = [&](auto& v, Index part, Index j) { return v.data() + part * cells + j * s.n; };
  const auto each = [&](auto&& visit) {
    for (Index part = 0; part < 2; ++part)
      for (Index j = 0; j < s.half; ++j) visit(part, j, s.rows - 1 - j);
  };
  each([&](Index part, Index j, Index mirror) {
    const double *one = row(p, part, j), *other = row(p, part, mirror);
    for (int odd = 0; odd < 2; ++odd) {
      std::ranges::fill(s.fft->real(), 0.0);
      for (Index i = 0; i < s.n; ++i)
        s.fft->real()[static_cast<std::size_t>(i)] =
            (odd ? one[i] - other[i] : one[i] + other[i]) / 2;
      s.fft->forward();
      Parts::Split& to = s.in[static_cast<std::size_t>(odd ^ part)];
      for (Index f = 0; f < s.frequencies; ++f)
        to.put(part * s.half + j, f, s.fft->spectrum()[static_cast<std::size_t>(f)]);
    }
  });
  for (std::size_t kind = 0; kind < 2; ++kind)
    for (Index f = 0; f < s.frequencies; ++f) {
      const Parts::Split &k = s.influence[kind][static_cast<std::size_t>(f)], &in = s.in[kind];
      Parts::Split& out = s.out[kind];
      influence_times(k.re.data(), k.im.data(), 2 * s.half, in.re.col(f).data(),
                      in.im.col(f).data(), out.re.col(f).data(), out.im.col(f).data());
    }
  strain.resize(2 * cells);
  each([&](Index part, Index j, Index mirror) {
    double *one = row(strain, part, j), *other = row(strain, part, mirror);
    for (int odd = 0; odd < 2; ++odd) {
      const Parts::Split& from = s.out[static_cast<std::size_t>(odd ^ part)];
      for (Index f = 0; f < s.frequencies; ++f)
        s.fft->spectrum()[static_cast<std::size_t>(f)] = {from.re(part * s.half + j, f),
                                                          from.im(part * s.half + j, f)};
      s.fft->inverse();
      for (Index i = 0; i < s.n; ++i) {
        const double value = s.fft->real()[static_cast<std::size_t>(i)];
        if (odd)
          one[i] += value, other[i] -= mirror == j ? 0 : value;
        else
          one[i] = other[i] = value;
      }
    }
  });
}

}  // namespace railbook::rolling
