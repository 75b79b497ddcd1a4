/*
### `verify`

Compares what the installed program computes with reference numbers: closed forms, published tables, results of other programs and
numbers that the papers print. They stand with their sources and allowed deviations in CSV files that are installed with the
program. A line a group says how many numbers it has, and how near the worst comes to what is allowed.

    railbook verify

Exit status 0 if every number is met, 1 if not; then the first ten that deviate are listed.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include <railbook/files/out_file.hpp>
#include <railbook/files/outside.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/progress.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "tools.hpp"
#include "verify/references.hpp"

namespace railbook::verify_tool {
namespace {

struct Reference {
  std::string of;
  At at;
  double expected = 0, within = 0;
};

// A file: "# title", "# source", and a row a number.
struct Group {
  std::string name, title, source;
  std::vector<Reference> numbers;
};

std::string comment(table::LineSource& lines, const std::filesystem::path& file) {
  std::string line;
  if (!lines.next(line) || !line.starts_with("# "))
    throw InputError(
        fmt::format("file \"{}\" does not begin with two lines \"# title\" and \"# "
                    "source\"",
                    file.string()));
  return line.substr(2);
}

Group read(const std::filesystem::path& file) {
  Group group;
  group.name = file.stem().string();
  table::LineSource lines(file);
  group.title = comment(lines, file);
  group.source = comment(lines, file);
  table::CsvReader reader(file);
  const auto of = reader.column("of"), at = reader.column("at"),
             expected = reader.column("expected"), within = reader.column("within");
  while (reader.next()) {
    Reference number{
        std::string(reader.cell(of)), {}, reader.number(expected), reader.number(within)};
    std::string words(reader.cell(at));
    for (std::size_t begin = 0; begin < words.size();) {
      const auto end = std::min(words.find(' ', begin), words.size());
      number.at.words.push_back(words.substr(begin, end - begin));
      begin = end + 1;
    }
    if (!(number.within > 0))
      throw InputError(fmt::format("file \"{}\", line {}: within is {}; allowed: greater than 0",
                                   file.string(), reader.line(), number.within));
    group.numbers.push_back(std::move(number));
  }
  if (group.numbers.empty())
    throw InputError(fmt::format("file \"{}\" holds no numbers", file.string()));
  return group;
}

std::vector<Group> read_all(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> tables;
  if (!std::filesystem::is_directory(folder))
    throw InputError(fmt::format("data is \"{}\"; allowed: a folder with the reference numbers",
                                 folder.string()));
  for (const std::string& name : files::names_in(folder))
    if (name.ends_with(".csv") && !name.starts_with("profile-")) tables.push_back(folder / name);
  if (tables.empty())
    throw InputError(fmt::format("data is \"{}\", without a file of numbers", folder.string()));
  std::vector<Group> groups;
  for (const auto& file : tables) groups.push_back(read(file));
  return groups;
}

// How far a number is off, over what is allowed; and what to say of it.
struct Verdict {
  double share = 0;
  std::string text;
};
Verdict judge(const Reference& number, const Quantities& quantities) {
  const auto compute = quantities.find(number.of);
  if (compute == quantities.end())
    throw InputError(fmt::format("a reference number is of \"{}\", which is not known", number.of));
  const std::string name = fmt::format("{} at {}", number.of, fmt::join(number.at.words, " "));
  try {
    const double value = compute->second(number.at);
    const double share = std::abs(value - number.expected) / number.within;
    return {std::isnan(share) ? units::infinity : share,
            fmt::format("{} is {:.10g}; expected: {:.10g}, within {:.2g}", name, value,
                        number.expected, number.within)};
  } catch (const InputError&) {
    throw;
  } catch (const files::OutsideError&) {
    throw;
  } catch (const std::runtime_error& error) {
    return {units::infinity, fmt::format("{}: {}", name, error.what())};
  }
}

void run(const std::filesystem::path& data) {
  Quantities quantities = closed_forms();
  quantities.merge(solvers(data));
  const std::vector<Group> groups = read_all(data);
  std::size_t all = 0, failed = 0;
  for (const Group& group : groups) all += group.numbers.size();
  tool::Progress progress("numbers", static_cast<double>(all));
  tool::Summary answer("Reference numbers");
  for (const Group& group : groups) {
    double worst = 0;
    for (const Reference& number : group.numbers) {
      const Verdict verdict = judge(number, quantities);
      progress.step();
      worst = std::max(worst, verdict.share);
      if (verdict.share <= 1) continue;
      if (++failed <= 10) answer.warn(fmt::format("number_{}", failed), verdict.text);
    }
    answer.add(group.name, group.title,
               fmt::format("{} numbers, worst at {} of its tolerance   ({})", group.numbers.size(),
                           std::isinf(worst) ? "no multiple" : tool::to_significant(worst, 2),
                           group.source));
    answer.add_to_json(group.name + "_numbers", static_cast<double>(group.numbers.size()), "");
    if (std::isfinite(worst)) answer.add_to_json(group.name + "_worst", worst, "");
  }
  progress.end();
  answer.add("numbers", "all", static_cast<double>(all), "");
  answer.add("failed", "  beyond their tolerance", static_cast<double>(failed), "");
  answer.print();
  if (failed > 0)
    throw std::runtime_error(fmt::format("{} of {} reference numbers are not met", failed, all));
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto data = std::make_shared<std::filesystem::path>();
  parser.file("--data", *data, "folder of reference numbers instead of the installed one");
  parser.help(
      "Each file has two lines, \"# title\" and \"# source\", and columns of, at, expected and "
      "within: the quantity, its inputs, the reference number and the deviation that is allowed.");
  return [data] { run(data->empty() ? tools::scripts("verify") / "data" : *data); };
}

}  // namespace

tool::Tool verify_tool() {
  return {"", "compare this installation with reference numbers", declare};
}

}  // namespace railbook::verify_tool
