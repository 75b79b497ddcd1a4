// rolling_limits CSV CELLS...: what the forces of chapters/03-creep/data/limits.csv tend to on ever
// finer grids, once more. Each of its sets (a/b and reduced creepages) is solved on grids of so
// many cells a side, rows of one length by transforms, and extrapolated as bench::limit_of does.
// Writes the file anew on standard output; ends with 1 when the old one's values are more than two
// standard errors away, root mean square.
//
//   reference_rolling_limits chapters/03-creep/data/limits.csv 32 40 48 56 (some ten seconds)
//   reference_rolling_limits chapters/03-creep/data/limits.csv 96 112 128 144 160 176 192 208 224
//   (a quarter of an hour; as the file is)
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <railbook/bench/limit.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/rolling/parts.hpp>
#include <railbook/table/csv.hpp>

namespace {

using namespace railbook;
using namespace railbook::rolling;

constexpr double poisson = 0.3;  // of the chapter's bodies

struct Case {
  double ratio = 1;
  Creepage creepage;  // reduced
  std::array<double, 3> force{}, known{};
};

std::map<std::string, std::vector<Case>> read(const char* file) {
  table::CsvReader csv(file);
  std::map<std::string, std::vector<Case>> sets;
  const auto at = [&](const char* column) { return csv.number(csv.column(column)); };
  while (csv.next())
    sets[std::string(csv.cell(csv.column("set")))].push_back(
        {at("ratio"),
         {at("longitudinal"), at("lateral"), at("spin")},
         {at("fx"), at("fy"), at("mz")},
         {at("fx_known"), at("fy_known"), at("mz_known")}});
  return sets;
}

std::array<double, 3> solve(const Case& c, int cells) {
  const RollingGrid grid = ellipse_grid(c.ratio, cells, cells, true, true);
  const TangentialInfluence influence(grid.mesh, poisson, false);
  const RollingCase contact = with_reduced_creepage(normalised_case(c.ratio, poisson), c.creepage);
  const CreepForces f =
      in_units(grid, solve_on(influence, grid, reduced_creepage(contact), {}), 1, 1);
  if (!f.converged) throw std::runtime_error(f.reason);
  return {f.fx, f.fy, f.mz};
}

bench::Limit limit(const std::vector<Case>& cases, const std::vector<int>& sizes) {
  const auto answers = num::map_in_parallel(cases.size() * sizes.size(), [&](std::size_t k) {
    return solve(cases[k % cases.size()], sizes[sizes.size() - 1 - k / cases.size()]);
  });
  std::vector<bench::Grid> ladder;
  for (std::size_t s = 0; s < sizes.size(); ++s) {
    ladder.push_back({1.0 * sizes[s], {}});
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const auto& of = answers[(sizes.size() - 1 - s) * cases.size() + c];
      ladder.back().answers.insert(ladder.back().answers.end(), of.begin(), of.end());
    }
  }
  return bench::limit_of(ladder);
}

}  // namespace

int main(int count, char** words) try {
  std::vector<int> sizes;
  for (int i = 2; i < count; ++i) sizes.push_back(std::stoi(words[i]));
  bool agree = true;
  fmt::print("set,ratio,longitudinal,lateral,spin,fx,fy,mz,fx_known,fy_known,mz_known,order\n");
  for (const auto& [set, cases] : read(words[1])) {
    const bench::Limit found = limit(cases, sizes);
    double squares = 0, forces = 0;
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const Case& of = cases[c];
      const double *f = &found.answers[3 * c], *known = &found.uncertainty[3 * c];
      const auto digits = [](double share) { return std::round(1e9 * share) / 1e9 + 0.0; };
      fmt::print("{},{},{},{},{},{:.9f},{:.9f},{:.9f},{:.1e},{:.1e},{:.1e},{:.2f}\n", set, of.ratio,
                 of.creepage.longitudinal, of.creepage.lateral, of.creepage.spin, digits(f[0]),
                 digits(f[1]), digits(f[2]), known[0], known[1], known[2], found.order);
      for (std::size_t q = 0; q < 3; ++q) {
        if (of.force[q] == 0) continue;  // across, along rolling alone
        squares += std::pow((f[q] - of.force[q]) / std::hypot(known[q], of.known[q]), 2);
        ++forces;
      }
    }
    const double apart = std::sqrt(squares / forces);
    agree = agree && apart <= 2;
    fmt::print(stderr, "{}: order {:.2f}, from the file {:.2f} standard errors\n", set, found.order,
               apart);
  }
  return agree ? 0 : 1;
} catch (const std::exception& e) {
  fmt::print(stderr, "{}\n", e.what());
  return 2;
}
