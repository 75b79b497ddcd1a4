// The rows of `make bench`.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/cycles/continuation.hpp>
#include <railbook/filters/fir_filter.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/dense_lu.hpp>
#include <railbook/num/fft.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/quality/descriptor_filter.hpp>
#include <railbook/records/record_file.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/force_table.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/linear_stability.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "rows.hpp"

using namespace railbook;

namespace bench_rows {
namespace {

volatile double sink = 0;  // what is computed is used

std::vector<double> noise(std::size_t n) {
  const num::RandomSource random(20261122, 1);
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 1e-3 * random.normal(i);
  return x;
}

// The numbers of a text, one after the other, and nothing else done with them.
double scan(const std::filesystem::path& file) {
  const int fd = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about {};
  if (fd < 0 || fstat(fd, &about) != 0) throw std::runtime_error("cannot read " + file.string());
  const auto size = static_cast<std::size_t>(about.st_size);
  void* map = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0);
  close(fd);
  if (map == MAP_FAILED) throw std::runtime_error("cannot map " + file.string());
  const char *at = static_cast<const char*>(map), *const end = at + size;
  double sum = 0;
  at = std::find(at, end, '\n') + 1;
  while (at < end) {
    double value = 0;
    at = std::from_chars(at, end, value).ptr + 1;
    sum += value;
  }
  munmap(map, size);
  return sum;
}

double scan_by_streams(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  double sum = 0;
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    sum += std::stod(line.substr(0, comma)) + std::stod(line.substr(comma + 1));
  }
  return sum;
}

Row reading(const std::filesystem::path& folder) {
  const auto file = folder / "record.csv";
  std::string text = "distance_m,profile_mm\n";
  const std::vector<double> x = noise(2'000'000);
  double z = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    z = 0.99 * z + x[i];
    text += fmt::format("{:.2f},{:.4f}\n", 0.25 * static_cast<double>(i), 1e3 * z);
  }
  std::ofstream(file, std::ios::binary) << text;
  return {.key = "csv",
          .what = "A record read from CSV, placed and judged",
          .unit = "bytes",
          .work = static_cast<double>(text.size()),
          .ours = {"read_record",
                   [file] {
                     double sum = 0;
                     records::read_record({.file = file}, [&](std::span<const double> piece,
                                                              const records::RecordStream&) {
                       for (const double value : piece) sum += value;
                     });
                     sink = sum;
                   }},
          .limit = {"std::from_chars over mapped memory", [file] { sink = scan(file); }},
          .plain = {"std::getline and std::stod", [file] { sink = scan_by_streams(file); }}};
}

Row power_spectrum() {
  const auto x = std::make_shared<std::vector<double>>(noise(1U << 23U));
  const std::size_t segment = 4096, pairs = x->size() / segment;
  const auto fft = std::make_shared<num::ComplexFft>(segment);
  return {.key = "psd",
          .what = "Welch's spectrum, segments of 4,096 that overlap by half",
          .unit = "samples",
          .work = static_cast<double>(x->size()),
          .ours = {"welch", [x] { sink = spectra::welch(*x, 1).density[7]; }},
          .limit = {"reading as many segments, two as one, and transforming them", [=] {
                      for (std::size_t i = 0; i + 1 < pairs; ++i) {
                        const double* one = x->data() + i * segment;
                        for (auto& z : fft->values()) z = {one[0], one[segment / 2]}, ++one;
                        fft->forward();
                        sink = fft->values()[0].real();
                      }
                    }}};
}

// Filter C over four million samples; varied: each with an interval of its own.
Row hybrid(bool varied) {
  const auto x = std::make_shared<std::vector<double>>(noise(4'000'000)),
             out = std::make_shared<std::vector<double>>(x->size());
  Row row{
      .key = varied ? "hybrid-varied" : "hybrid",
      .what = fmt::format("Hybrid filter C, {} interval", varied ? "each sample its own" : "one"),
      .unit = "samples",
      .work = static_cast<double>(x->size()),
      .ours = {"FirstOrderHybrid", [=] {
                 filters::FirstOrderHybrid filter(1.0);
                 for (std::size_t i = 1; i < x->size(); ++i)
                   (*out)[i] = filter.push((*x)[i], varied ? 0.02 + (*x)[i - 1] : 0.01);
                 sink = out->back();
               }}};
  row.limit = {varied ? "an exponential and a division a sample" : "reading and writing a double",
               [=] {
                 for (std::size_t i = 0; i < x->size(); ++i)
                   (*out)[i] = varied ? 1 / std::expm1(0.02 + (*x)[i]) : -(*x)[i];
                 sink = out->back();
               }};
  return row;
}

// `fresh`: into arrays that each run allocates, as scipy does; else into one that is there.
Row chain(bool fresh) {
  const auto x = std::make_shared<std::vector<double>>(noise(2'000'000));
  const auto taps = std::make_shared<Eigen::VectorXd>(Eigen::VectorXd::Random(661));
  const auto there = std::make_shared<std::vector<double>>(fresh ? 0 : 2 * x->size());
  const auto out = [=] {
    return fresh ? std::make_shared<std::vector<double>>(2 * x->size()) : there;
  };
  return {.key = fresh ? "chain-new" : "chain",
          .what = fmt::format("Space curve and 62-ft chord from short chords, into {}",
                              fresh ? "arrays allocated for it" : "an array that is there"),
          .unit = "samples",
          .work = static_cast<double>(x->size()),
          .ours = {"GeometryChain, block by block",
                   [=] {
                     const auto result = out();
                     double* to = result->data();
                     filters::GeometryChain stream({}, [&](auto curve, auto chord) {
                       to = std::copy_n(chord.begin(), chord.size(),
                                        std::copy_n(curve.begin(), curve.size(), to));
                     });
                     stream.push(*x);
                     stream.finish();
                     sink = result->back();
                   }},
          .limit = {"reading one and writing two doubles a sample",
                    [=] {
                      const auto result = out();
                      for (std::size_t i = 0; i < x->size(); ++i)
                        (*result)[2 * i] = (*x)[i], (*result)[2 * i + 1] = -(*x)[i];
                      sink = result->back();
                    }},
          .plain = {"one scalar product of 661 weights a sample",
                    [=] {
                      double sum = 0;
                      for (std::size_t i = 0; i + 661 < x->size() / 20; ++i)
                        sum += taps->dot(Eigen::Map<const Eigen::VectorXd>(x->data() + i, 661));
                      sink = sum;
                    }},
          .share = 0.05};
}

// Not 8 times as quick as scipy, whose way takes 8 times the bare transforms of two blocks in one,
// but 5 times: reading, the overlap, gains and handing out take as long as the transforms. Shorter
// weights, or a coarser step for the long waves, would gain little: the length of a transform
// counts by its logarithm.
Row descriptor(bool fresh) {
  const auto x = std::make_shared<std::vector<double>>(noise(1U << 22U));
  const quality::Envelope envelope(
      {.stroke = quality::StrokeLimit{{0.5, 0.2}, 25.4e-3}, .force = {}, .speed = 100 / 3.6});
  const auto taps =
      std::make_shared<filters::FilterTaps>(quality::design_filter(envelope, {.spacing = 0.25}));
  const std::size_t reach = taps->half.size() - 1, size = std::bit_ceil(6 * reach);
  const std::size_t outputs = 2 * (size - 2 * reach), blocks = x->size() / outputs + 1;
  const auto fft = std::make_shared<num::ComplexFft>(size);
  const auto out = std::make_shared<std::vector<double>>(fresh ? 0 : x->size());
  return {.key = fresh ? "descriptor-new" : "descriptor",
          .what = fmt::format("Descriptor of a record, {} weights, into {}", 2 * reach + 1,
                              fresh ? "an array allocated for it" : "an array that is there"),
          .unit = "samples",
          .work = static_cast<double>(x->size()),
          .ours = {"FilterStream",
                   [=] {
                     if (fresh) {
                       sink = filters::filter(*taps, *x).back();
                       return;
                     }
                     double* to = out->data();
                     filters::FilterStream stream(*taps, [&](auto piece) {
                       to = std::copy(piece.begin(), piece.end(), to);
                     });
                     stream.push(*x);
                     stream.finish();
                     sink = out->back();
                   }},
          .limit = {fmt::format("a pair of complex transforms of {} for each {} samples", size,
                                outputs),
                    [=] {
                      std::ranges::fill(fft->values(), 0.0);
                      for (std::size_t i = 0; i < blocks; ++i) {
                        fft->forward();
                        fft->inverse();
                        sink = fft->values()[0].real();
                      }
                    }},
          .plain = {"a multiplication for each two weights",
                    [=] {
                      const std::span part{x->data(), x->size() / 50};
                      sink = filters::filter_direct(*taps, part).back();
                    }},
          .share = 0.02};
}

Row normal_contact(Eigen::Index cells) {
  const auto frame = 2 * static_cast<std::size_t>(cells + 1);
  const auto fft =
      std::make_shared<std::optional<num::RealFft2d>>();  // after ours: its memory is not ours
  const auto pairs = std::make_shared<double>(0);
  const int threads = static_cast<int>(std::thread::hardware_concurrency());
  return {.key = fmt::format("contact-{}", cells),
          .what = fmt::format("Normal contact of an ellipse to 1e-6, {0} by {0} cells and the "
                              "grids below, {1} threads",
                              cells, threads),
          .unit = "cells",
          .work = static_cast<double>(cells * cells),
          .ours = {"solve_cg_fft",
                   [=] {
                     contact::CgFftOptions options;
                     options.nx = options.ny = cells;
                     options.cg.threads = threads;
                     options.cg.tolerance = 1e-6;
                     const auto answer = contact::solve_cg_fft(
                         contact::quadratic_gap({1.0, 1.7, 0.0}), 50e-6, 115e9, options);
                     if (!answer.contact.converged) throw std::runtime_error(answer.contact.reason);
                     *pairs = answer.transform_pairs();
                     sink = answer.contact.force;
                   }},
          .limit = {"a dozen pairs of transforms of the finest grid, padded; one thread",
                    [=] {
                      if (!*fft) fft->emplace(frame, frame);
                      for (int i = 0; i < 12; ++i) (*fft)->forward(), (*fft)->inverse();
                      sink = (*fft)->row(0)[0];
                    }},
          .count = [=] {
            return fmt::format(
                "points transformed, in pairs of transforms of the finest grid, "
                "padded: {:.1f}",
                *pairs);
          }};
}

Row rolling_contact() {
  constexpr std::size_t side = 128;
  const auto products = std::make_shared<int>(0);
  const auto influence = std::make_shared<Eigen::VectorXd>();  // after ours: its memory is not ours
  return {.key = "rolling",
          .what = "Rolling contact of an ellipse with spin, 128 by 128 cells",
          .unit = "cells",
          .work = side * side,
          .ours = {"EllipseRolling",
                   [=] {
                     rolling::RollingCase c = rolling::normalised_case(1.5, 0.28);
                     c = rolling::with_reduced_creepage(c, {0.6, 0.2, 0.5});
                     const auto forces = rolling::solve_rolling(c, {.along = side, .rows = side});
                     if (!forces.converged) throw std::runtime_error(forces.reason);
                     *products = forces.products;
                     sink = forces.fx;
                   }},
          .limit = {"reading the influence of the rows once for each product", [=] {
                      if (influence->size() == 0) influence->setOnes(4 * (side + 1) * side * side);
                      for (int i = 0; i < *products; ++i) sink = influence->sum();
                    }}};
}

Row force_table() {
  const rolling::ForceTableAxes axes{
      .ratio_from = 1, .ratio_to = 1, .ratios = 1, .longitudinal = 5, .lateral = 5, .spin = 9};
  constexpr double poisson = 0.28;
  const auto products = std::make_shared<std::vector<std::pair<Eigen::Index, int>>>();
  return {.key = "table",
          .what = "Table of creep forces by the full theory, 12 cells along rolling",
          .unit = "nodes",
          .work = 5.0 * 5.0 * 9.0,
          .ours = {"ForceTable",
                   [=] {
                     products->clear();
                     const rolling::ForceTable table(axes, [=](double ratio) {
                       const auto full = rolling::solver("full", ratio, poisson, 12, false);
                       const auto counted = [=](const rolling::RollingCase& c) {
                         const rolling::CreepForces forces = full(c);
                         products->emplace_back(2 * forces.tractions.x.size(), forces.products);
                         return forces;
                       };
                       return rolling::shares_of(counted, ratio, poisson);
                     });
                     sink = table.node(0, 1, 1, 1).fx;
                   }},
          .limit = {"the products of each node with a matrix of its cells", [=] {
                      Eigen::MatrixXd matrix;
                      for (const auto& [size, count] : *products) {
                        matrix.setOnes(size, size);
                        Eigen::VectorXd p = Eigen::VectorXd::Ones(size), strain(size);
                        for (int i = 0; i < count; ++i) strain.noalias() = matrix * p;
                        sink = strain.sum();
                      }
                    }}};
}

// What a branch cannot do without: in each Newton step the balance's own matrix, at each point the
// maps of 256 and 128 steps, whose two stages move 18 columns.
void eliminate(const cycles::LimitCycleBranch& branch) {
  const double steps =
      static_cast<double>(branch.newton_steps) / static_cast<double>(branch.points.size());
  double eliminations = 0;
  num::DenseLu lu;
  const Eigen::MatrixXd small = Eigen::MatrixXd::Identity(9, 9) + 0.1 * Eigen::MatrixXd::Ones(9, 9);
  const Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(9, 36);
  for (const auto& point : branch.points) {
    const Eigen::Index n = 2 * point.cycle.motion.size() + 2;
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) + Eigen::MatrixXd::Ones(n, n);
    for (eliminations += steps; eliminations >= 1; --eliminations) lu.factor(matrix);
    for (int i = 0; i < 256 + 128; ++i) sink = num::solved(small, columns)(0, 0);
  }
}

Row limit_cycles() {
  const auto branch = std::make_shared<cycles::LimitCycleBranch>();
  return {
      .key = "branch",
      .what = "Branch of 60 limit cycles of the new wheel, with multipliers and located points",
      .unit = "points",
      .work = 60,
      .ours = {"follow_from_hopf",
               [=] {
                 using namespace cycles;
                 using namespace vehicle;
                 const FreightCar car = assemble({}, Suspension::dampers);
                 const auto& table = wheelset::new_wheel_table();
                 const Motion m = hopf_points({car, table}, 5, 100).front().motion;
                 *branch = follow_from_hopf(by_speed(car, table), m.shape, m.lambda.imag(), m.speed,
                                            {.most_points = 60});
                 if (branch->points.size() != 60) throw std::runtime_error("not 60 points");
                 sink = branch->points.back().largest;
               }},
      .limit = {
          "an elimination for each Newton step, and of 9 equations for each of the multipliers' "
          "384 steps",
          [=] { eliminate(*branch); }}};
}

}  // namespace

std::vector<std::pair<std::string, std::function<Row()>>> all(const std::filesystem::path& folder) {
  return {{"csv", [=] { return reading(folder); }},
          {"psd", power_spectrum},
          {"hybrid", [] { return hybrid(false); }},
          {"hybrid-varied", [] { return hybrid(true); }},
          {"chain", [] { return chain(false); }},
          {"chain-new", [] { return chain(true); }},
          {"descriptor", [] { return descriptor(false); }},
          {"descriptor-new", [] { return descriptor(true); }},
          {"contact-1023", [] { return normal_contact(1023); }},
          {"contact-2047", [] { return normal_contact(2047); }},
          {"rolling", rolling_contact},
          {"table", force_table},
          {"branch", limit_cycles}};
}

}  // namespace bench_rows
