// The standard deviations of one section, and what indices are made of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <railbook/quality/sections.hpp>

namespace railbook::quality_tool {

enum class Kind { level, alignment, gauge, crosslevel };

// The deviations of a section that indices are made of.
class Deviations {
 public:
  void add(Kind kind, double deviation) {
    of_[static_cast<std::size_t>(kind)].push_back(deviation);
  }
  void add_twist(double deviation) { twist_ = deviation; }
  const std::vector<double>& of(Kind kind) const { return of_[static_cast<std::size_t>(kind)]; }

  // Of alignment, gauge, cross level and longitudinal level, the means of both rails; nothing where
  // one lacks.
  std::optional<double> combined() const {
    std::vector<double> all;
    for (const std::vector<double>& one : of_) {
      if (one.empty()) return std::nullopt;
      double sum = 0;
      for (const double deviation : one) sum += deviation;
      all.push_back(sum / static_cast<double>(one.size()));
    }
    return quality::combined_deviation(all);
  }

  std::optional<double> tqi() const {
    std::vector<double> all;
    for (const std::vector<double>& one : of_) all.insert(all.end(), one.begin(), one.end());
    if (twist_) all.push_back(*twist_);
    if (all.size() != 7 || of(Kind::level).size() != 2 || of(Kind::alignment).size() != 2)
      return std::nullopt;
    return quality::track_quality_index(std::span<const double, 7>{all.data(), 7});
  }

 private:
  std::array<std::vector<double>, 4> of_;
  std::optional<double> twist_;
};

}  // namespace railbook::quality_tool
