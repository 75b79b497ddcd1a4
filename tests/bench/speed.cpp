// `make bench`: what the solvers cost beside what the machine asks for the same work, beside a plain way in this tree, and
// beside scipy where there is one. speed OUT.json [PEERS.json]: a table on standard output, and the same as JSON.
//
// Each row is a process of its own, so that its peak memory is its own; ours, the limit and the plain way take turns, and
// the best of the rounds counts.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/timing.hpp"
#include "contact/cg_fft.hpp"
#include "contact/geometry.hpp"
#include "dynamics/continuation.hpp"
#include "dynamics/linear_stability.hpp"
#include "files/out_file.hpp"
#include "files/staged.hpp"
#include "filters/geometry_chain.hpp"
#include "filters/hybrid_filter.hpp"
#include "num/fft.hpp"
#include "num/random_source.hpp"
#include "rolling/rolling_contact.hpp"
#include "spectra/record_file.hpp"
#include "spectra/welch.hpp"
#include "wheelrail/paper_pairs.hpp"

using namespace railbook;
using Json = nlohmann::ordered_json;

namespace {

struct Way {
  std::string what;
  std::function<void()> run;
};

struct Row {
  std::string key, what, unit;
  double work = 0;   // in that unit
  Way ours;          // what: the method
  Way limit = {};    // what the machine asks: the same bytes or transforms and nothing else
  Way plain = {};    // what one would write first
  double share = 1;  // of the work that the plain way does, where all of it takes too long
};

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
                     spectra::read_record({.file = file}, [&](std::span<const double> piece,
                                                              const spectra::RecordStream&) {
                       for (const double value : piece) sum += value;
                     });
                     sink = sum;
                   }},
          .limit = {"std::from_chars over mapped memory", [file] { sink = scan(file); }},
          .plain = {"std::getline and std::stod", [file] { sink = scan_by_streams(file); }}};
}

Row power_spectrum() {
  const auto x = std::make_shared<std::vector<double>>(noise(1U << 23U));
  const std::size_t segment = 4096, transforms = 2 * x->size() / segment - 1;
  const auto fft = std::make_shared<num::RealFft>(segment);
  return {.key = "psd",
          .what = "Welch's spectrum, segments of 4,096 that overlap by half",
          .unit = "samples",
          .work = static_cast<double>(x->size()),
          .ours = {"welch", [x] { sink = spectra::welch(*x, 1).density[7]; }},
          .limit = {"reading the samples and transforming as many segments", [=] {
                      for (std::size_t i = 0; i < transforms; ++i) {
                        std::memcpy(fft->real().data(), x->data() + i * segment / 2,
                                    segment * sizeof(double));
                        fft->forward();
                      }
                      sink = fft->spectrum()[7].real();
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

Row chain() {
  const auto x = std::make_shared<std::vector<double>>(noise(2'000'000));
  const auto taps = std::make_shared<Eigen::VectorXd>(Eigen::VectorXd::Random(661));
  const auto out = std::make_shared<std::vector<double>>(2 * x->size());
  return {.key = "chain",
          .what = "Space curve and 62-ft chord from short chords",
          .unit = "samples",
          .work = static_cast<double>(x->size()),
          .ours = {"GeometryChain, block by block",
                   [=] {
                     double* to = out->data();
                     filters::GeometryChain stream({}, [&](auto curve, auto chord) {
                       to = std::copy_n(chord.begin(), chord.size(),
                                        std::copy_n(curve.begin(), curve.size(), to));
                     });
                     stream.push(*x);
                     stream.finish();
                     sink = out->back();
                   }},
          .limit = {"reading one and writing two doubles a sample",
                    [=] {
                      for (std::size_t i = 0; i < x->size(); ++i)
                        (*out)[2 * i] = (*x)[i], (*out)[2 * i + 1] = -(*x)[i];
                      sink = out->back();
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

Row normal_contact() {
  const double grid = 1023;
  const auto fft = std::make_shared<num::RealFft2d>(2048, 2048);
  const auto iterations = std::make_shared<int>(0);
  return {.key = "contact",
          .what = "Normal contact of an ellipse, 1,023 by 1,023 cells and the grids below",
          .unit = "cells",
          .work = grid * grid,
          .ours = {"solve_cg_fft",
                   [iterations] {
                     contact::CgFftOptions options;
                     options.nx = options.ny = 1023;
                     const auto answer = contact::solve_cg_fft(
                         contact::quadratic_gap({1.0, 1.7, 0.0}), 50e-6, 115e9, options);
                     if (!answer.contact.converged) throw std::runtime_error(answer.contact.reason);
                     *iterations = answer.levels.back().iterations;
                     sink = answer.contact.force;
                   }},
          .limit = {"the pair of transforms of each iteration on the finest grid", [=] {
                      for (int i = 0; i < *iterations; ++i) fft->forward(), fft->inverse();
                      sink = fft->real()[0];
                    }}};
}

Row rolling_contact() {
  return {.key = "rolling",
          .what = "Rolling contact of an ellipse with spin, 128 by 128 cells",
          .unit = "cells",
          .work = 128.0 * 128.0,
          .ours = {"EllipseRolling", [] {
                     rolling::RollingCase c = rolling::unit_case(1.5, 0.28);
                     c = rolling::with_reduced_creepage(c, {0.6, 0.2, 0.5});
                     const auto forces = rolling::solve_rolling(c, {.along = 128, .rows = 128});
                     if (!forces.converged) throw std::runtime_error(forces.reason);
                     sink = forces.fx;
                   }}};
}

Row limit_cycles() {
  return {.key = "branch",
          .what = "Branch of 60 limit cycles of the new wheel, with multipliers and located points",
          .unit = "points",
          .work = 60,
          .ours = {"follow_from_hopf", [] {
                     using namespace dynamics;
                     const FreightCar car = assemble({}, Suspension::dampers);
                     const auto& table = wheelrail::new_wheel_table();
                     const Motion m = hopf_points({car, table}, 5, 100).front().motion;
                     const auto branch =
                         follow_from_hopf(by_speed(car, table), m.shape, m.lambda.imag(), m.speed,
                                          {.most_points = 60});
                     if (branch.points.size() != 60) throw std::runtime_error("not 60 points");
                     sink = branch.points.back().largest;
                   }}};
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// Ours, the limit and the plain way in turn, three times or for two seconds of each.
Json measured(const Row& row) {
  const std::vector<const Way*> ways = {&row.ours, &row.limit, &row.plain};
  std::vector<double> best(ways.size(), INFINITY);
  double spent = 0, memory = 0;
  for (int round = 0; round < 5 && (round < 2 || spent < 4); ++round)
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (!ways[i]->run) continue;
      const double seconds = bench::seconds_of(ways[i]->run);
      if (i == 0 && round == 0) memory = peak_bytes();
      best[i] = std::min(best[i], seconds);
      spent += seconds;
    }
  Json json = {{"key", row.key},      {"what", row.what}, {"method", row.ours.what},
               {"work", row.work},    {"unit", row.unit}, {"seconds", best[0]},
               {"peak_bytes", memory}};
  if (row.limit.run)
    json["limit"] = {
        {"what", row.limit.what}, {"seconds", best[1]}, {"share_reached", best[1] / best[0]}};
  if (row.plain.run)
    json["plain"] = {{"what", row.plain.what},
                     {"seconds", best[2] / row.share},
                     {"times_as_long", best[2] / row.share / best[0]}};
  return json;
}

// Set up and measured in a process of its own.
Json in_a_process(const std::function<Row()>& make) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    std::string text;
    try {
      text = measured(make()).dump();
    } catch (const std::exception& error) {
      text = Json{{"failed", error.what()}}.dump();
    }
    close(ends[0]);
    const auto wrote = write(ends[1], text.data(), text.size());
    _exit(wrote == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  char piece[4096];
  for (ssize_t n = 0; (n = read(ends[0], piece, sizeof piece)) > 0;)
    text.append(piece, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0 || text.empty()) throw std::runtime_error("a measurement ended by itself");
  return Json::parse(text);
}

void add_peer(Json& row, const Json& peers) {
  const std::string key = row.value("key", "");
  if (!peers.contains(key)) return;
  // Peers do as much work a sample; they may do fewer samples.
  const double seconds = peers[key].at("seconds").get<double>() * row.at("work").get<double>() /
                         peers[key].at("work").get<double>();
  row["peer"] = {{"what", peers[key].at("what")},
                 {"seconds", seconds},
                 {"times_as_long", seconds / row.at("seconds").get<double>()}};
}

std::string line(const Json& row) {
  if (row.contains("failed")) return fmt::format("FAILED: {}\n", row["failed"].get<std::string>());
  const double seconds = row.at("seconds"), work = row.at("work");
  std::string text = fmt::format("{} ({})\n  {}", row["what"].get<std::string>(),
                                 row["method"].get<std::string>(), bench::duration(seconds));
  text += fmt::format(
      ", {} a {}", bench::duration(seconds / work),
      row["unit"].get<std::string>().substr(0, row["unit"].get<std::string>().size() - 1));
  text += fmt::format("; at most {:.0f} MB\n", row.at("peak_bytes").get<double>() / 1e6);
  if (row.contains("limit"))
    text += fmt::format("  the machine's limit, {}: {}; {:.0f} % reached\n",
                        row["limit"]["what"].get<std::string>(),
                        bench::duration(row["limit"]["seconds"]),
                        100 * row["limit"]["share_reached"].get<double>());
  for (const char* other : {"plain", "peer"})
    if (row.contains(other))
      text += fmt::format("  {}: {}, {:.2g} times as long\n", row[other]["what"].get<std::string>(),
                          bench::duration(row[other]["seconds"]),
                          row[other]["times_as_long"].get<double>());
  return text;
}

int run(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    fmt::print(stderr, "speed OUT.json [PEERS.json]\n");
    return 2;
  }
  Json peers = Json::object();
  if (argc == 3) peers = Json::parse(std::ifstream(argv[2]));
  files::PrivateFolder folder;
  const std::vector<std::function<Row()>> rows = {[&] { return reading(folder.path()); },
                                                  power_spectrum,
                                                  [] { return hybrid(false); },
                                                  [] { return hybrid(true); },
                                                  chain,
                                                  normal_contact,
                                                  rolling_contact,
                                                  limit_cycles};
  Json all = Json::array();
  bool failed = false;
  for (const auto& make : rows) {
    Json row = in_a_process(make);
    add_peer(row, peers);
    fmt::print("{}\n", line(row));
    failed = failed || row.contains("failed");
    all.push_back(std::move(row));
  }
  if (peers.empty()) fmt::print("scipy (Debian's python3-scipy) is not there: no peers.\n");
  files::write(argv[1], all.dump(1) + "\n");
  return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "speed: {}\n", error.what());
    return 1;
  }
}
