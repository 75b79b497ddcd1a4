/*
### `wheelrail measure`

The gauges of measured wheels (thickness, height and gradient of the flange) or rails (radius of the crown, wear against a
new rail) with their errors; of several files a row each.

    wheelrail measure left.whl right.whl --body wheel
    wheelrail measure left.ban --body rail --new-rail 60E1

An error is twice the change that profiles half as smooth make, and three times the scatter of the points: with these it holds
for all of 540 gauges of a wheel of arcs and lines with a scatter of 2 to 30 um.
*/

#include <railbook/profiles/gauges.hpp>

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/profiles/depth_profile.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

#include "pair_options.hpp"
#include "tools.hpp"

namespace railbook::wheelrail_tool {

using namespace profiles;
using units::millimetre;

namespace {

struct Options : tools::PairOptions {
  tool::RecordFiles files;
  std::string body = "wheel", new_rail;
  tools::ProfileForm form;
  double depth = 14 * millimetre;
  tool::Destination out;
};

struct Number {
  const char *key, *what;
  double value, error = 0;  // [m]
};
struct Measured {
  std::vector<Number> numbers;
  std::vector<ProfileFit> fits;
};

Curve new_rail(const Options& options, std::vector<ProfileFit>& fits) {
  if (options.new_rail == "60E1") return rail_60e1(Rail60::drawing, true);
  return tools::read_profile(options, "rail", options.new_rail, fits);
}

std::vector<Number> numbers_of(const Options& options, const std::filesystem::path& file,
                               std::vector<ProfileFit>& fits) {
  if (options.body == "wheel") {
    const WheelGauges g = wheel_gauges(tools::read_profile(options, "wheel", file, fits));
    return {{"flange_thickness_mm", "thickness of the flange, Sd", g.thickness},
            {"flange_height_mm", "height of the flange, Sh", g.height},
            {"flange_gradient_mm", "gradient of the flange, qR", g.gradient}};
  }
  const Curve rail = tools::read_profile(options, "rail", file, fits);
  std::vector<Number> numbers{{"crown_radius_mm", "radius of the crown", crown_radius(rail)}};
  if (options.new_rail.empty()) return numbers;
  std::vector<ProfileFit> unworn;
  const RailWear w = rail_wear(rail, new_rail(options, unworn), options.depth);
  numbers.push_back({"wear_vertical_mm", "wear on the axis, W1", w.vertical});
  numbers.push_back({"wear_side_mm", "wear of the side, W2", w.side});
  numbers.push_back({"wear_corner_mm", "wear at 45 degrees, W3", w.corner});
  return numbers;
}

Measured measure(Options options, const std::filesystem::path& file) {
  options.wheel_form = options.rail_form = options.form;
  Measured m;
  m.numbers = numbers_of(options, file, m.fits);
  options.smoothing = 0.5;
  std::vector<ProfileFit> half;
  const std::vector<Number> other = numbers_of(options, file, half);
  for (std::size_t k = 0; k < other.size(); ++k)
    m.numbers[k].error =
        2 * std::abs(m.numbers[k].value - other[k].value) + 3 * m.fits.front().scatter;
  return m;
}

// Wear that is negative beyond its error: the files are not in the same coordinates, or the new
// rail is another.
bool swapped(const Number& n) {
  return std::string_view{n.key}.starts_with("wear") && n.value < -n.error - 0.05 * millimetre;
}

std::vector<tool::Row> rows_of(const Options& options, const std::filesystem::path& file) {
  const Measured m = measure(options, file);
  tool::Row row;
  for (const Number& n : m.numbers) {
    row.add(n.key, n.value / millimetre);
    row.add(std::string(n.key).insert(std::string_view{n.key}.size() - 3, "_error"),
            n.error / millimetre);
    if (swapped(n)) row.warn("negative-wear");
  }
  std::string left_out;
  for (const auto& part : m.fits.front().left_out)
    left_out += (left_out.empty() ? "" : "; ") + part.text;
  row.add("left_out", left_out);
  for (const auto& warning : m.fits.front().warnings) row.warn(warning.key);
  return {row};
}

void run(const Options& options) {
  if (options.files.many())
    return tool::run_batch(options.files, options.out, "measure",
                           [&](const auto& file) { return rows_of(options, file); });
  const Measured m = measure(options, options.files.only());
  tool::OutFolder out(options.out, {"measure.json"});
  tool::Summary answer("Gauges of a " + options.body);
  answer.add("file", "file", options.files.only().string());
  tools::describe_fits(answer, options, m.fits);
  tools::flag_points(answer, m.fits, [](const auto&, const auto&) { return ""; });
  for (const Number& n : m.numbers) {
    answer.add(n.key, n.what, tool::Estimate{n.value / millimetre, n.error / millimetre}, "mm");
    if (swapped(n))
      answer.warn(
          "negative-wear",
          fmt::format("{} is negative: have both files the same coordinates, and is the new "
                      "rail the right one?",
                      n.what));
  }
  answer.print();
  if (out) out.add("measure.json", answer.json());
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  parser.records(options->files);
  parser.choice("--body", options->body, {"wheel", "rail"}, "what the files are of");
  parser.text("--new-rail", options->new_rail,
              "file of the rail as it was new, or 60E1, for the wear, in the same coordinates: "
              "axis of the rail at 0, heights from one zero");
  parser.quantity("--depth", options->depth, units::length,
                  "below the new rail's top, at which W2 is measured", tool::Range{1e-3, 0.05});
  tools::add_form_options(parser, "", options->form);
  tools::add_datum_options(parser, *options);
  parser.out(options->out);
  parser.help(
      "Definitions are those of MiniProf's standard calculations: Sd 10 mm below the tape circle, "
      "which is 70 mm from the back of the flange; Sh from the tape circle to the tip; qR from 2 "
      "mm "
      "above the tip to Sd's height; the crown within 10 mm of the axis; W1 on the axis, W2 "
      "across, "
      "W3 at 45 degrees. With --out DIR: DIR/measure.json, or of several files "
      "DIR/measure-table.csv and .jsonl.\n\nExample: railbook wheelrail measure left.whl right.whl "
      "--body wheel");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool measure_tool() {
  return {"measure", "gauges of wheels and rails: flange, crown and wear", declare};
}

}  // namespace railbook::wheelrail_tool
