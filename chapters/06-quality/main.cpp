/*** # Track quality as a vehicle feels it

How rough may a track be? J. C. Corbin and A. E. Fazio answer with a vehicle. Drive it over a sine of the track and see how much of its
suspension stroke, or of the force its wheel may bear, one metre of amplitude uses up; the inverse is the amplitude that may be
left in the track at that wavelength; the least of it over all speeds up to the posted one is what has to be maintained. The curve becomes a filter. Run over a
geometry record, its output is 1 where the track uses up what the vehicle can bear.

The paper prints few numbers and no masses or springs at all. So here each formula is proven against integration in time, each claim
is tested and its range stated, the filter is built and run on long records, and the paper's hypothesis, that the curves hold for any vehicle
however nonlinear, is put to the test with the bump stops it mentions. It fails, and we show where.

{{include: stroke.cpp}}

{{include: force.cpp}}

{{include: combined.cpp}}

{{include: time_domain.cpp}}

{{include: psd.cpp}}

{{include: filter.cpp}}

{{include: nonlinear.cpp}}

{{include: branches.cpp}}

{{include: pairs.cpp}}

{{include: index.cpp}}

{{include: spreading.cpp}}

{{include: limit_tool.cpp}}

{{include: index_tool.cpp}}

## Error against run time

## Stability

## Deviations

## Limits

## Try next

## All verdicts

{{verdicts}}
*/
#include "items.hpp"

#include <cmath>

using namespace railbook;

namespace quality_chapter {

quality::StrokeLimit level_limit() {
  return quality::stroke_limit_of_level(roll, flat_level);
}

quality::ForceLimit car(const report::Item& item, const std::string& key) {
  const report::CsvTable table = item.printed("cars.csv");
  const auto number = [&](const char* column) {
    return report::printed_number(table.at(key, column));
  };
  return {quality::make_car(number("wheel_kg"), number("body_kg"),
                            {number("frequency_Hz"), number("damping")}),
          wheel_force_limit};
}

std::vector<double> speeds(const report::Item& item) {
  const report::CsvTable table = item.printed("speeds.csv");
  std::vector<double> result;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    result.push_back(report::printed_number(table.at(i, "kmh")) * kmh);
  return result;
}

std::vector<double> wavelengths(double low, double high, int per_decade) {
  const int steps = static_cast<int>(std::ceil(per_decade * std::log10(high / low)));
  std::vector<double> result;
  for (int i = 0; i <= steps; ++i)
    result.push_back(low * std::pow(high / low, static_cast<double>(i) / steps));
  return result;
}

}  // namespace quality_chapter

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "quality",
       .title = "Track quality as a vehicle feels it",
       .paper = "J. C. Corbin and A. E. Fazio, Performance-Based Track-Quality Measures and Their "
                "Application to Maintenance-of-Way Planning, Transportation Research Record 802",
       .sources = RAILBOOK_CHAPTER_DIR}};
  quality_chapter::add_stroke(chapter);
  quality_chapter::add_force(chapter);
  quality_chapter::add_combined(chapter);
  quality_chapter::add_time_domain(chapter);
  quality_chapter::add_psd(chapter);
  quality_chapter::add_filter(chapter);
  quality_chapter::add_nonlinear(chapter);
  quality_chapter::add_branches(chapter);
  quality_chapter::add_pairs(chapter);
  quality_chapter::add_index(chapter);
  quality_chapter::add_spreading(chapter);
  quality_chapter::add_limit_tool(chapter);
  quality_chapter::add_index_tool(chapter);
  return chapter.run(argc, argv);
}
