// Records of the geometry car with one live channel, and which of their rows examine() masks or
// doubts.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <railbook/geometry_car/health.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::geometry_car::one_channel {

inline constexpr double mm = units::millimetre, missing = std::numeric_limits<double>::quiet_NaN();
inline constexpr auto height = Channel::height_left;

// At 20 m/s, every other channel dead.
inline Record record_of(Channel channel, const std::vector<double>& values) {
  Record r;
  r.elapsed.assign(values.size(), Layout{}.sample / 20);
  r.mark.resize(values.size());
  std::iota(r.mark.begin(), r.mark.end(), 0);
  for (auto& all : r.values) all.assign(values.size(), missing);
  r[channel] = values;
  return r;
}

inline std::vector<double> alternating(std::size_t rows, double size) {
  std::vector<double> e(rows);
  for (std::size_t k = 0; k < rows; ++k) e[k] = k % 2 == 0 ? size : -size;
  return e;
}

inline std::set<std::size_t> masked(const Record& before, Channel channel) {
  Record r = before;
  examine(r, {});
  std::set<std::size_t> rows;
  for (std::size_t k = 0; k < r.size(); ++k)
    if (std::isnan(r[channel][k]) && !std::isnan(before[channel][k])) rows.insert(k);
  return rows;
}

inline const Finding* finding(const Health& health, Fault fault, const std::string& what) {
  for (const Finding& f : health.findings)
    if (f.fault == fault && f.what == what) return &f;
  return nullptr;
}

inline std::set<std::size_t> rows_of(const std::vector<char>& marked) {
  std::set<std::size_t> rows;
  for (std::size_t k = 0; k < marked.size(); ++k)
    if (marked[k]) rows.insert(k);
  return rows;
}

inline std::set<std::size_t> range(std::size_t from, std::size_t to) {
  std::set<std::size_t> rows;
  for (std::size_t k = from; k < to; ++k) rows.insert(k);
  return rows;
}

// A quiet height with changes of its own.
inline std::vector<double> quiet(std::size_t rows) {
  return alternating(rows, 2e-3 * mm);
}

}  // namespace railbook::geometry_car::one_channel
