/***
The paper computes in feet, slugs and pounds, and prints two of its numbers in metres as well. So "fps" are feet a
second, and all results below are in the paper's units:

{{conversions}}
*/

#include <string>

#include "items.hpp"
#include "units/constants.hpp"

using namespace railbook;

namespace {

void conversions(report::Item& item) {
  const table::CsvTable printed = item.printed("conversions.csv");
  item.expect_checks(2);
  item.columns({"", "printed", "SI, printed", "SI, computed"});
  const auto show = [&](const char* key, double unit) {
    const auto row = item.row(printed, key);
    const double si = std::stod(row.printed("printed_us")) * unit;
    row.check("printed", si);
    item.add_row({row.printed("what"), row.printed("printed_us") + " " + row.printed("unit_us"),
                  row.printed("printed") + " " + row.printed("unit"),
                  table::csv_number(si) + " " + row.printed("unit")});
  };
  show("speed", units::foot);
  show("gauge", units::inch);
}

}  // namespace

void hunting_chapter::add_conversions(report::Chapter& chapter) {
  chapter.table("conversions", "The two quantities the paper prints twice", conversions);
}
