/* ### `quality measures`

The measures that networks keep of a record of track geometry, for each section of 200 m:

    railbook quality measures track.csv --column left,right --alignment aleft,aright --gauge gauge --crosslevel cant --out mine

standard deviation and largest value of longitudinal level and alignment in the bands of EN 13848 (D1 and D2; `--bands` names others) with the place of the largest, the standard deviations of gauge, cross level
and twist, the combined standard deviation (weights 1), China's index where all seven parameters are there, and the highest FRA class (1 to 5) that the columns given allow on tangent track: profile and alinement by the 62-ft chord, gauge, cross level, and warp, the difference of cross level within 62 ft; `--chords 31ft 124ft` adds what other chords read. `--fra-class 4` lists every place where
one of them leaves the limit of that class (exceptions.csv), `--limits` those of a file of one's own; of classes 6 to 9 alinement only, by its deviation from uniformity on chords of 31, 62
and 124 ft. A class or an index is not stated for a section of which something was missing, bridged or taken out within the reach of the chord; how much of it is in `not_evaluated_m`. Nothing is said where a chord reaches over an end of the record or a gap, nor of a band nearer to one than its longest wave. The band-pass has four poles an edge and no phase; it counts as run forward and backward (half the gain at the edges), `--passes 1` takes the root of that. Limits and class
tables that could not be checked in two sources are left out: the classes A to E of EN 13848-6, the limits for action of EN 13848-5, gauge and surface of FRA
classes 6 to 9.
*/
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/quality/measure.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/input_error.hpp>

#include "quality/limits_file.hpp"
#include "quality/measured_record.hpp"
#include "quality/measures_answer.hpp"
#include "record_options.hpp"
#include "tools.hpp"

namespace railbook::quality_tool {
namespace {

std::vector<Limit> fra_limits(const std::vector<std::string>& classes) {
  return read_limits(tools::scripts("quality") / "fra-49-cfr-213.csv", classes, std::nullopt);
}

// Of the FRA's class or of a file; none where neither is asked for.
std::vector<Limit> limits_of(const MeasuresOptions& options) {
  const bool fra = options.fra_class > 0, file = !options.limits_file.empty();
  if (fra && (file || !options.classes.empty()))
    throw InputError{"fra class and limits are given; allowed: one of --fra-class and --limits"};
  if (!file && (!options.classes.empty() || options.speed))
    throw InputError{"class and speed are of limits; allowed: with --limits FILE"};
  if (fra) return fra_limits({std::to_string(options.fra_class)});
  return file ? read_limits(options.limits_file, options.classes, options.speed)
              : std::vector<Limit>{};
}

// Throws InputError where no limit is of a column that is given.
void require_columns(const MeasuresOptions& options) {
  std::vector<std::string> of;
  for (const Limit& limit : options.limits) {
    const bool given = limit.channel == Kind::level
                           ? options.record.columns != std::vector<std::string>{"none"}
                       : limit.channel == Kind::alignment ? !options.alignment.empty()
                       : limit.channel == Kind::gauge     ? !options.gauge.empty()
                                                          : !options.crosslevel.empty();
    if (given) return;
    const std::string channel = limit.what.substr(0, limit.what.find(' '));
    if (std::ranges::find(of, channel) == of.end()) of.push_back(channel);
  }
  if (!of.empty())
    throw InputError{
        fmt::format("the limits are of {} only; allowed: a column of that "
                    "(--column, --alignment, --gauge, --crosslevel)",
                    fmt::join(of, ", "))};
}

void measure_track(MeasuresOptions options) {
  for (const std::string& band : options.bands) (void)filters::parse_band("bands", band);
  for (const std::string& chord : options.chords) (void)quality::parse_chord("chords", chord);
  if (!options.chord.empty()) (void)quality::parse_chord("chord", options.chord);
  if (!options.filtered.empty() && options.filtered != "by-name")
    (void)filters::parse_band("filtered (by-name, or a band)", options.filtered);
  if (!options.chord.empty() && !options.filtered.empty())
    throw InputError{"chord and filtered are given; allowed: one of them"};
  options.limits = limits_of(options);
  options.fra_limits = fra_limits({"1", "2", "3", "4", "5"});
  require_columns(options);
  if (options.record.batch.many())
    return tool::run_batch(options.record.batch, options.out, "measures", [&](const auto& file) {
      return rows_of(options, measure_record(options, file));
    });
  tool::OutFolder out(options.out, {"measures.csv", "measures.json", "exceptions.csv",
                                    "warnings.csv", "measures.png"});
  const Measured m = measure_record(options, options.record.batch.only());
  const tool::Summary summary = summary_of(options, m);
  summary.print();
  if (out) {
    const auto rows = rows_of(options, m);
    out.add("measures.csv", table_of({rows.begin() + 1, rows.end()}));
    out.add("measures.json", summary.json());
    if (!options.limits.empty()) out.add("exceptions.csv", exceptions_of(m));
    out.add("warnings.csv", tools::warnings_of(m.names(), m.records));
    out.scratch("picture.csv", picture_of(options, m));
    out.figure(tools::scripts("quality") / "measures.gp", {"picture.csv"}, "measures.png");
  }
  out.commit();
}

}  // namespace

tool::Tool measures_tool() {
  return {
      "measures", "standard deviations, chords, twist and indices of sections",
      [](tool::OptionParser& o) {
        auto options = std::make_shared<MeasuresOptions>();
        tools::add_record_options(o, options->record);
        o.texts("--alignment", options->alignment, "columns of alignment");
        o.text("--gauge", options->gauge, "column of gauge, or of its deviation from the nominal");
        o.text("--crosslevel", options->crosslevel, "column of cross level, a height");
        o.texts("--bands", options->bands,
                "bands for level and alignment: D0, D1, D2, D3 of EN 13848, or two wavelengths as "
                "in 3m-35m");
        o.count("--passes", options->passes,
                "of the band-pass: 2, half the gain at its edges, or 1", 1, 2);
        o.texts("--chords", options->chords,
                "more chords, besides 62 ft; of one that is not divided in its middle the parts "
                "before and behind the offset, 3m+7m",
                true);
        o.quantity("--chord-mean", options->chord_mean, units::length,
                   "length of the running mean that is taken off the offsets of --chords",
                   {1, 1e4});
        o.text("--chord", options->chord,
               "the columns of level and alignment are the offsets of this chord, 62ft or 3m+7m");
        o.text("--filtered", options->filtered,
               "the columns of level and alignment are filtered to this band already, and --bands "
               "is for others; by-name: each to the band that its header names");
        o.count("--fra-class", options->fra_class,
                "list where this class's limits are left: profile, alinement, gauge, cross level "
                "and warp on tangent track; of classes 6 to 9, alinement",
                1, 9);
        o.file("--limits", options->limits_file,
               "list where the limits of this file are left; see Limits below");
        o.texts("--class", options->classes, "classes of those limits; left out: all");
        o.quantity("--speed", options->speed, units::speed, "that limits by speed are for",
                   {0, 200});
        o.quantity("--nominal-gauge", options->nominal_gauge, units::length,
                   "where gauge or its limits are deviations from it", {0.3, 3});
        o.quantity("--twist-base", options->twist_base, units::length, "base of twist", {0.5, 30});
        o.quantity("--section", options->section, units::length, "length of a section", {1, 1e6});
        o.out(options->out);
        o.help(
            std::string{tools::record_help} +
            "\n\nmeasures.csv has a row a section. NAME_sd is a standard deviation about the "
            "mean; NAME_largest the value\n"
            "farthest from zero, with its sign, and NAME_largest_at_m its place. NAME_D1_sd, "
            "NAME_D1_largest and NAME_D1_largest_at_m are those of the column in that band and\n"
            "have the column's sign. NAME_chord_largest is of the column at the middle of a 62-ft "
            "chord less "
            "the mean of its ends: a\n"
            "hollow is negative where up is positive; of columns that are offsets of such a chord "
            "already (--chord 62ft)\n"
            "it is the column. twist (mm/m) is the cross level less that "
            "a twist base before, over\n"
            "the base; warp the cross level less the one within 62 ft before that differs most. "
            "Both are positive where\n"
            "cross level grows in the order of the rows. Gauge is whole or as given. missing "
            "counts samples of all\n"
            "columns that are not there; unread those missing, bridged or taken out. "
            "combined_sd, tqi and fra_class are\n"
            "empty where any is: for fra_class also within the reach of its chord "
            "(not_evaluated_m). fra_class is the\n"
            "highest of classes 1 to 5 that all columns given keep on tangent track, 0 where "
            "they keep none. In\n"
            "exceptions.csv, largest is the value farthest beyond the limit, bound the limit, both "
            "in unit; of a standard deviation a row is\n"
            "a section. warnings.csv: column, warning, place and size.\n"
            "\nLimits: a CSV file with the columns channel, measure, value, class, speed_from, "
            "speed_to, low, high; others are ignored.\n"
            "channel is level, alignment, gauge or crosslevel; measure is empty (the column as it "
            "is), a band (D1, 3m-35m), chord 10m,\n"
            "chord 3m+7m, uniformity 62ft (its offset less the mean of nine), twist 3m or change "
            "62ft (the largest difference within it);\n"
            "value is peak, sd (by section), mean 100m or mean-to-peak 100m (less the running "
            "mean). low and high carry units, -7mm/m\n"
            "of a twist; an empty one is no limit. speed_from is not included, speed_to is. "
            "Gauge beyond 0.5 m is whole, else a deviation.\n"
            "--fra-class takes share/railbook/tools/quality/fra-49-cfr-213.csv.\n"
            "\nExample: railbook quality measures track.csv --column left,right --gauge gauge "
            "--crosslevel cant --out mine\n"
            "         railbook quality measures track.csv --chords 31ft 124ft --fra-class 4 "
            "--out mine");
        return [options] { measure_track(*options); };
      }};
}

}  // namespace railbook::quality_tool
