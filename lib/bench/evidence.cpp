#include <railbook/bench/evidence.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include <railbook/plot/plot.hpp>

namespace railbook::bench {

double covered(const std::vector<Estimate>& runs) {
  const auto good = std::ranges::count_if(runs, [](auto& r) { return r.truth <= r.stated; });
  return static_cast<double>(good) / static_cast<double>(runs.size());
}

void estimates_against_truth(report::Item& item, const std::vector<Estimate>& runs, double least) {
  constexpr double floor = 1e-17;  // an exact answer has no place on a logarithmic axis
  report::Data& data = item.data({"case", "stated", "truth", "covered"});
  std::vector<double> margins;
  for (const Estimate& r : runs) {
    data.add(r.label, std::max(r.stated, floor), std::max(r.truth, floor),
             r.truth <= r.stated ? 1.0 : 0.0);
    margins.push_back(std::max(r.stated, floor) / std::max(r.truth, floor));
  }
  data.holds_to("*", 0.9, 1e-12, "differences of nearly equal numbers");
  std::ranges::sort(margins);
  item.script(plot::shared("lib/bench") / "estimates.gp");
  item.at_least("covered", "fraction of runs whose true error is within the stated one", "",
                covered(runs), least,
                "at least 95 % of true errors must lie within the stated one");
  item.value("covered", fmt::format("{:.0f} % of {}", 100 * covered(runs), runs.size()));
  item.value("median-margin", margins.empty() ? units::nan : margins[margins.size() / 2], "",
             "{:.1g}");
}

void digits_table(report::Item& item, const std::vector<Digits>& rows) {
  item.columns({"function", "range", "largest relative error", "digits lost", "against"});
  constexpr double rounding = std::numeric_limits<double>::epsilon() / 2;
  for (const Digits& r : rows) {
    const double lost = std::log10(std::max(r.worst, rounding) / rounding);
    item.add_row({r.function, r.range, report::below(r.worst),
                  fmt::format("{:.0f}", std::ceil(lost)), r.against});
    item.at_most(r.id, "largest relative error of " + r.function, "", r.worst, r.allowed,
                 r.against);
  }
}

Worst worst_of(int cases, std::uint64_t seed,
               const std::function<report::Found(RandomStream&)>& run) {
  Worst worst;
  worst.cases = cases;
  for (int k = 0; k < cases; ++k) {
    RandomStream draw{seed, static_cast<std::uint64_t>(k)};
    try {
      report::Found found = run(draw);
      if (std::isnan(found.error)) found.error = std::numeric_limits<double>::infinity();
      if (!(found.error <= worst.found.error)) worst.found = std::move(found);
    } catch (const report::NoAnswer&) {
      ++worst.unanswered;
    }
  }
  return worst;
}

void worst_row(report::Item& item, const report::StabilityCase& c, int cases, std::uint64_t seed,
               const std::function<report::Found(RandomStream&)>& run, int may_refuse) {
  item.stability(c, [&] {
    Worst worst = worst_of(cases, seed, run);
    if (worst.unanswered > may_refuse)
      throw report::NoAnswer{fmt::format("{} of {} cases without an answer; allowed: {}",
                                         worst.unanswered, cases, may_refuse)};
    worst.found.text = fmt::format("worst of {}: {}", cases, worst.found.text);
    if (worst.unanswered > 0)
      worst.found.text += fmt::format("; {} said that they have no answer", worst.unanswered);
    return worst.found;
  });
}

}  // namespace railbook::bench
