/* ### `quality compare`

Two runs over one line, and what has grown between them:

    quality compare spring.csv autumn.csv --column profile --section 200m --out mine

Both runs are brought to the grid of the first and filtered to the band D1; windows of 200 m of the first are looked for within 20 m of their place in the second, by correlation, and the
offsets found are joined by straight lines (recorders count differently). For each section of the first run there are the standard deviations of both runs, the growth from one to the other, and how well the
runs agree. Deviations are those of the samples that both runs have, 25 m and more from an end or a gap; where these are less than half of a section, no window was found (tamped track is not like what it was), or the offset jumps by over 2 m, there is no growth: such sections are named. Several columns are compared one after the other. Where a window
fits as well at another offset, as on a wave, the smallest offset is taken and the answer says so. Runs with `--resync` count their positions from the first on. The filtered runs are held in memory (8 bytes a sample each: 32 MB for 1000 km at 0.25 m).

More runs, each with its date:

    quality compare 2021.csv 2022.csv 2023.csv 2024.csv --dates 2021-05-03,2022-05-09,2023-04-28,2024-05-06 --out mine

give the growth a year of each section, by a straight line through its deviations, with its standard error and the interval that holds it with 95 % (Student's, with two degrees of freedom fewer than runs; two runs have no standard error). Each run is laid over the one before it. Where the deviation of a section falls from one run to the next by more than
15 % (`--tamping-drop`), or by four times the scatter of the runs if that is more, the track was tamped, and a new line begins; this is judged before the likeness of the runs, which tamping ends. A section that is unlike the run before it without being smoother begins a new line as well. A line that was tamped throughout between two runs cannot be aligned.
*/
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <railbook/filters/inner_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>

#include "quality/compare.hpp"
#include "tools.hpp"

namespace railbook::quality_tool {

namespace {

// A column of a file in the band D1, by ascending positions; its record is kept for its places.
quality::LineRun read_run(const CompareOptions& options, const std::filesystem::path& file,
                          ComparedColumn& column) {
  std::optional<filters::InnerFilter> filter;
  std::vector<double> heights;
  const auto keep = [&](std::span<const double> p) {
    heights.insert(heights.end(), p.begin(), p.end());
  };
  records::RecordFile read = tools::record_file(options.record, file);
  read.column = column.name;
  const records::RecordStream& record = *column.records.emplace_back(records::read_record(
      read, [&](std::span<const double> piece, const records::RecordStream& stream) {
        if (!filter)
          filter.emplace(filters::band_taps(filters::bands[1], 2, stream.spacing()),
                         filters::band_margin(filters::bands[1], stream.spacing()), keep);
        filter->push(piece);
      }));
  filter->finish();
  const auto place = [&record](std::size_t k) {
    const records::PlaceMap& places = record.places();
    if (!record.resynced()) return places.at(k);
    // Positions that jump are counted on instead.
    const double way = places.at(1) < places.at(0) ? -1 : 1;
    return places.at(0) + way * record.spacing() * static_cast<double>(k);
  };
  const std::size_t last = heights.size() - 1;
  if (heights.size() < 2 || place(last) >= place(0)) return {std::move(heights), place};
  std::reverse(heights.begin(), heights.end());
  return {std::move(heights), [place, last](std::size_t i) { return place(last - i); }};
}

// Years since 1970 of a date such as 2024-03-01.
double years_of(const std::string& date) {
  int year = 0;
  unsigned month = 0, day = 0;
  const auto number = [&](std::size_t from, std::size_t length, auto& value) {
    const char* const end = date.data() + from + length;
    const auto [stop, error] = std::from_chars(date.data() + from, end, value);
    return error == std::errc{} && stop == end;
  };
  const bool digits = date.size() == 10 && date[4] == '-' && date[7] == '-' && number(0, 4, year) &&
                      number(5, 2, month) && number(8, 2, day);
  const std::chrono::year_month_day given{std::chrono::year{year}, std::chrono::month{month},
                                          std::chrono::day{day}};
  if (!digits || year < 0 || !given.ok())
    throw InputError{fmt::format(
        "dates: \"{}\"; allowed: days written as year, month and day, 2024-03-01", date)};
  return static_cast<double>(std::chrono::sys_days{given}.time_since_epoch().count()) / 365.25;
}

std::vector<double> years_of_runs(const CompareOptions& options) {
  std::vector<double> years;
  for (const std::string& date : options.dates) {
    years.push_back(years_of(date));
    if (years.size() > 1 && years.back() <= years[years.size() - 2])
      throw InputError{
          fmt::format("dates: {} comes after {}; allowed: the earliest run first, each on a day of "
                      "its own",
                      date, options.dates[years.size() - 2])};
  }
  const std::size_t runs = options.record.batch.files.size();
  if (!years.empty() && years.size() != runs)
    throw InputError{fmt::format(
        "{} dates are given for {} records; allowed: one for each (--dates)", years.size(), runs)};
  return years;
}

void compare_runs(const CompareOptions& options) {
  const auto& files = options.record.batch.files;
  if (files.size() < 2)
    throw InputError{fmt::format(
        "{} records are given; allowed: 2 and more, the earliest run first", files.size())};
  const std::vector<double> years = years_of_runs(options);
  if (files.size() > 2 && years.empty())
    throw InputError{fmt::format(
        "{} records are given without dates; allowed: 2, or with the date of each, as --dates "
        "2023-04-28,2023-10-09,2024-05-06",
        files.size())};
  tool::OutFolder out(
      options.out,
      years.empty()
          ? std::vector<std::string>{"compare.csv", "warnings.csv", "compare.json", "compare.png"}
          : std::vector<std::string>{"growth.csv", "deviations.csv", "warnings.csv", "compare.json",
                                     "compare.png"});
  ComparedColumns columns;
  for (const std::string& name : options.record.columns) {
    ComparedColumn& column = columns.emplace_back(ComparedColumn{name, {}, {}});
    quality::RunSeries series{read_run(options, files[0], column), options.section,
                              options.alignment};
    for (std::size_t k = 1; k < files.size(); ++k) series.add(read_run(options, files[k], column));
    column.runs = series.sections();
  }
  if (years.empty())
    answer_pair(options, columns, out);
  else
    answer_growth(options, columns, years, out);
  out.commit();
}

std::string ordinal(std::size_t run) {
  return run == 1 ? "second" : run == 2 ? "third" : fmt::format("{}th", run + 1);
}

}  // namespace

void add_runs(tool::Summary& s, const ComparedColumns& columns) {
  const bool several = columns.size() > 1;
  tools::add_record(s, *columns.front().records.front());
  for (const ComparedColumn& column : columns) {
    if (&column != &columns.front())
      tools::add_warnings(s, *column.records.front(), column.name, several);
    for (std::size_t k = 1; k < column.records.size(); ++k)
      for (const units::Warning& warning : column.records[k]->warnings())
        s.warn(tools::key_of(column.name, ordinal(k) + "-" + warning.key, several),
               fmt::format("the {} run: {}{}", ordinal(k), several ? column.name + ": " : "",
                           warning.text));
  }
}

void add_files(tool::OutFolder& out, const CompareOptions& options, const ComparedColumns& columns,
               const tool::Summary& answer, const std::vector<std::string>& names) {
  std::string warnings = std::string{"run,"} + tools::warnings_header, picture;
  for (const ComparedColumn& column : columns)
    for (std::size_t k = 0; k < column.runs.size(); ++k) {
      warnings += tools::warning_rows(column.name, *column.records[k], fmt::format("{},", k + 1));
      if (!picture.empty()) picture += "\n\n";
      picture += fmt::format("distance_km,deviation_mm,{}\n",
                             table::csv_cell(column.name + ": " + names[k]));
      for (const quality::RunSection& section : column.runs[k].sections)
        for (const double at : {section.heights.from, section.heights.from + options.section})
          picture +=
              fmt::format("{:.8g},{},\n", at / units::kilometre,
                          table::csv_number(section.heights.deviation().value_or(units::nan) /
                                            units::millimetre));
    }
  out.add("warnings.csv", warnings);
  out.add("compare.json", answer.json());
  out.scratch("picture.csv", picture + "\n");
  out.figure(tools::scripts("quality") / "measures.gp", {"picture.csv"}, "compare.png");
}

tool::Tool compare_tool() {
  return {
      "compare", "two runs over one line or more: offsets, and growth of each section",
      [](tool::OptionParser& o) {
        auto options = std::make_shared<CompareOptions>();
        tools::add_record_options(o, options->record);
        o.quantity("--section", options->section, units::length, "length of a section", {1, 1e6});
        o.quantity("--window", options->alignment.window, units::length,
                   "of the first run that is looked for in the second", {10, 1e4});
        o.quantity("--reach", options->alignment.reach, units::length,
                   "to either side of its place", {1, 1e3});
        o.texts(
            "--dates", options->dates,
            "days of the runs, as 2023-04-28,2024-05-06: growth a year with its standard error; "
            "needed for more than two runs");
        o.quantity(
            "--tamping-drop", options->growth.tamping_drop, units::number,
            "fall of a section's deviation from one run to the next that means tamping (with "
            "--dates)",
            {0.01, 0.99});
        o.out(options->out);
        o.help(
            std::string{tools::record_help} +
            "\n\ncompare.csv has a row a section of the first run: before_mm and after_mm are "
            "its standard deviations in D1 (3 to 25 m)\n"
            "in the first and the second run, growth_mm the second less the first. offset_m "
            "is positive where the second run\n"
            "gives the same track a larger position. correlation is that of the worst window "
            "(1: alike); missing counts samples\n"
            "that one of the runs lacks; not_judged says why there is no growth."
            "\n\nWith --dates: growth.csv has a row for each period of a section in which nothing "
            "was done to the track. begins says how it\n"
            "begins (first: with the first run; tamped; unlike: another shape, not smoother), "
            "drop the fall of the deviation there as a\n"
            "fraction, since and until its first and last run. growth_mm_per_year is the slope "
            "of the deviation, standard_error its\n"
            "error, low and high hold it with 95 % (Student; all three nan for two runs). "
            "deviations.csv has a row a section and run;\n"
            "its offset_m and correlation compare the run with the one before."
            "\n\nExample: railbook quality compare spring.csv autumn.csv --column profile "
            "--out mine\n"
            "         railbook quality compare 2022.csv 2023.csv 2024.csv --dates "
            "2022-05-09,2023-04-28,2024-05-06");
        return [options] { compare_runs(*options); };
      }};
}

}  // namespace railbook::quality_tool
