// peer_bank FOLDER SHOWN [RESULTS]: answers the cases of FOLDER's tables with the library and
// compares. It ends with 1 when a promise is broken, when the statistics are not those of
// railbook/wheel_contact/model_error.hpp, which the book and the command show, or when a comparison
// is not that of the table SHOWN, which the book draws. It prints the statistics as that header has
// them and writes the comparisons to RESULTS, to renew both.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <railbook/num/parallel.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/wheel_contact/model_error.hpp>

#include "half_space.hpp"
#include "stresses.hpp"
#include "wheels.hpp"

using namespace railbook::peer_bank;

namespace {

// What was promised, and what the committed table says: counts to one in a hundred, bias and
// scatter to 5e-4 (another compiler may move a value over a limit).
bool holds(const std::map<std::string, Statistics>& found) {
  bool good = true;
  const auto require = [&](bool true_, const std::string& quantity, const char* what) {
    if (!true_) fmt::print(stderr, "{}: {}\n", quantity, what), good = false;
  };
  for (const char* quantity :
       {"normal force", "longitudinal force", "lateral force", "largest pressure"})
    require(found.at(quantity).explained() >= 0.95, quantity, "less than 95 % within 1 %");
  for (const auto& known : railbook::wheel_contact::model_errors) {
    const auto now = found.find(known.quantity);
    require(now != found.end(), known.quantity, "not compared any more");
    if (now == found.end()) continue;
    const Statistics& s = now->second;
    const auto near = [&](const char* what, double before, double after, double allowed) {
      require(std::abs(before - after) <= allowed, known.quantity, what);
    };
    const double few = 1 + 0.01 * s.count;
    near("count", known.count, s.count, 0), near("agree", known.agree, s.agree, few);
    near("cells", known.cells, s.cells, few), near("differ", known.differ, s.differ, few);
    near("bias", known.bias, s.bias, 5e-4), near("scatter", known.scatter, s.scatter, 5e-4);
    near("limit", known.limit, s.limit, 5e-4);
  }
  require(std::size(railbook::wheel_contact::model_errors) == found.size(), "the committed table",
          "has not all quantities");
  return good;
}

constexpr const char* names[] = {"agrees", "cells", "differs", "small"};

// What the book keeps: the quantities that it draws, and what differs.
bool kept(const Comparison& c) {
  static constexpr const char* drawn[] = {"normal force", "largest pressure",   "approach",
                                          "contact area", "longitudinal force", "lateral force"};
  const Outcome o = outcome(c);
  return o == Outcome::differs ||
         (o != Outcome::small && std::ranges::find(drawn, c.quantity) != std::end(drawn));
}

void write(const std::vector<Comparison>& all, const char* name) {
  std::ofstream file(name);
  file << "file,case,quantity,theirs,same_cells,finer_cells,outcome\n";
  for (const Comparison& c : all)
    if (kept(c))
      file << fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{}\n", c.file, c.number, c.quantity,
                          c.theirs, c.same, c.fine, names[int(outcome(c))]);
  if (!file.flush()) throw std::runtime_error(fmt::format("cannot write {}", name));
}

// Each comparison that the book keeps as it shows it, to a thousandth.
bool stands(const std::vector<Comparison>& all, const char* name) {
  railbook::table::CsvReader csv(name);
  for (const Comparison& c : all) {
    if (!kept(c)) continue;
    const auto near = [&](const char* column, double now) {
      const double shown = csv.number(csv.column(column));
      return std::isnan(now) ? std::isnan(shown) : std::abs(shown - now) <= 1e-3 * std::abs(now);
    };
    if (csv.next() && csv.cell(csv.column("file")) == c.file &&
        csv.cell(csv.column("quantity")) == c.quantity && near("theirs", c.theirs) &&
        near("same_cells", c.same) && near("finer_cells", c.fine))
      continue;
    fmt::print(stderr, "{}, line {}: not {}, case {}, {}\n", name, csv.line(), c.file, c.number,
               c.quantity);
    return false;
  }
  return !csv.next();
}

int run(const std::string& folder, const char* shown, const char* results) {
  std::map<std::string, std::vector<HalfSpaceCase>> files;
  const std::vector<HalfSpaceCase> cases = read_half_space(folder + "/half_space.csv");
  for (const HalfSpaceCase& c : cases) files[c.file].push_back(c);
  files["table"] = read_creep_table(folder + "/creep_table.csv");
  std::vector<const std::vector<HalfSpaceCase>*> work;
  for (const auto& [name, one] : files) work.push_back(&one);
  std::vector<HalfSpaceAnswers> answers(work.size());
  WheelAnswers wheels;
  std::vector<std::string> errors(work.size());
  std::string wheel_error;
  const auto histories = [&](std::size_t k) {
    return std::ranges::count(*work[k], "transient", &HalfSpaceCase::kind);
  };
  std::vector<std::size_t> order(work.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(), histories);
  std::atomic<std::size_t> next = 0;  // the longest first, each thread takes the next
  railbook::num::in_parallel(2, 2, [&](std::size_t, std::size_t, std::size_t part) {
    if (part == 1) try {
        wheels = answer_wheels(folder + "/wheels.csv");
      } catch (const std::exception& e) {
        wheel_error = e.what();
      }
    for (std::size_t turn = next++; turn < work.size(); turn = next++) {
      const std::size_t k = order[turn];
      try {
        answers[k] = answer(*work[k]);
      } catch (const std::exception& e) {
        errors[k] = fmt::format("{}: {}", work[k]->front().file, e.what());
      }
    }
  });
  errors.push_back(wheel_error);
  std::string failed;
  for (const std::string& e : errors) failed += e.empty() ? "" : e + "\n";
  if (!failed.empty()) throw std::runtime_error(failed);
  std::vector<Comparison> all = wheels.comparisons;
  int answered = wheels.answered, normal_only = 0, refused = 0;
  for (const HalfSpaceAnswers& a : answers) {
    all.insert(all.end(), a.comparisons.begin(), a.comparisons.end());
    answered += a.answered, normal_only += a.normal_only, refused += a.refused;
  }
  const std::vector<Comparison> stresses = answer_stresses(cases, folder + "/stresses.csv");
  all.insert(all.end(), stresses.begin(), stresses.end());
  if (results) write(all, results);
  fmt::print("# {} cases answered, {} of which the normal contact only, {} not\n",
             answered + normal_only, normal_only, refused);
  const auto found = statistics(all);
  for (const auto& [quantity, s] : found) {  // the lines of the table in model_error.hpp
    std::string key = quantity;
    std::replace(key.begin(), key.end(), ' ', '_');
    fmt::print("    {{\"{}\", \"{}\", {}, {}, {}, {}, {}, {:.4f}, {:.4f}, {:.4f}}},\n", key,
               quantity, s.count, s.agree, s.cells, s.differ, s.small, s.bias, s.scatter, s.limit);
  }
  return answered + normal_only >= 800 && holds(found) && stands(all, shown) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) throw std::runtime_error("usage: peer_bank FOLDER SHOWN [RESULTS]");
  return run(argv[1], argv[2], argc > 3 ? argv[3] : nullptr);
} catch (const std::exception& e) {
  fmt::print(stderr, "peer_bank: {}\n", e.what());
  return 1;
}
