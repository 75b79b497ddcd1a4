// Figures by gnuplot: one script, its data files, one PNG.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace railbook::plot {

// A figure that could not be made; the text names the script and quotes gnuplot.
class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Runs `gnuplot -d -c script data[0] PNG data[1] ...` and leaves the result in `png`.
//
//   plot::render("fig-09.gp", {"fig-09.csv", "fig-09-printed.csv"}, "figures/fig-09.png");
//
// and the script begins
//
//   load "style.gp"
//   set output ARG2
//   set xlabel "distance along rolling direction, in"
//   plot ARG1 using "x_in":"p_psi" title "computed" with lines, ARG3 using 1:2 title "printed" with points ls printed
//
// Data files are CSV with a header line (units in the names); gnuplot takes at most eight. Paths may be
// relative to the working directory. style.gp is found through GNUPLOT_LIB; no start-up file is read.
// gnuplot writes a temporary file beside `png` (its folder is made if need be), renamed on success and
// removed otherwise, so `png` is either the old file or a complete new one.
// Throws PlotError when the script or a data file is missing, when gnuplot exits non-zero or says anything
// on stderr (its warnings mean a curve that is not there), and when the result is not a complete PNG.
void render(const std::filesystem::path& script, const std::vector<std::filesystem::path>& data,
            const std::filesystem::path& png);

}  // namespace railbook::plot
