// All that a paper contains, one row each: chapters/NN-name/data/inventory.csv.
//
//   place,kind,number,what,treated,symbol,test,reason
//   p. 168,equation,(12),ellipse of contact,,contact/hertz.hpp
//   hertz_from_approach,tests/lib/contact/claims.cpp, p. 171,number,Table 2,peak
//   pressure,table-2/p0-hertz table-2/p0-countact,,, p. 171,claim,,the contact lies inside the
//   interpenetration curve,table-2/inside,,, p. 172,figure,Fig. 9,pressure along the axis,fig-09,,,
//   p. 176,claim,,the run cost $2.83,,,,not testable: the machine is gone
//
// kind: equation, table, figure, number or claim. treated: ids of checks or items, with spaces
// between; a * at the end stands for anything. symbol and test: where an equation is in the library
// and what tests it. A row that nothing treats gives the reason.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <railbook/report/record.hpp>

namespace railbook::report {

// Throws InputError when the file is not of this form.
std::vector<InventoryRow> read_inventory(const std::filesystem::path& file);

// Gives each check of print or claim its place in the paper, that of the row which is most closely
// about it (its own kind, its id written out, few other checks), and returns what is wrong: ids
// that do not exist, rows without id, symbol and reason, checks of print or claim that no row
// names.
std::vector<std::string> audit(const std::vector<InventoryRow>& inventory, ChapterRecord& record);

}  // namespace railbook::report
