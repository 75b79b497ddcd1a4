#include <railbook/rolling/theory.hpp>

#include <array>
#include <memory>
#include <stdexcept>

#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>

namespace railbook::rolling {
namespace {

constexpr std::array theories{
    Theory::fastsim, Theory::fastrip,           Theory::shen_hedrick_elkins,
    Theory::polach,  Theory::vermeulen_johnson, Theory::linear};

}  // namespace

const std::vector<std::string>& theory_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"full"};
    for (const Theory theory : theories) all.emplace_back(name(theory));
    return all;
  }();
  return names;
}

Solver solver(const std::string& theory, double axis_ratio, double poisson, long cells,
              bool computed) {
  if (theory == "full") {
    const auto contact = std::make_shared<EllipseRolling>(
        axis_ratio, poisson, RollingOptions{.along = cells, .rows = (cells + 1) / 2});
    return [contact](const RollingCase& c) { return contact->solve(c); };
  }
  for (const Theory one : theories) {
    if (name(one) != theory) continue;
    if (one == Theory::vermeulen_johnson)
      return [s = vermeulen_johnson_slopes(axis_ratio, poisson)](const RollingCase& c) {
        return vermeulen_johnson(c, s);
      };
    const KalkerCoefficients k = computed
                                     ? KalkerCoefficients(kalker_coefficients(axis_ratio, poisson))
                                     : kalker_table(axis_ratio, poisson);
    return [one, k](const RollingCase& c) { return creep_forces(one, c, k); };
  }
  throw std::logic_error("solver: no theory named " + theory);
}

}  // namespace railbook::rolling
