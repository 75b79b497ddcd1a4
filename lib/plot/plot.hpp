// Figures by gnuplot: one script, its data files, one PNG.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/files/outside.hpp>

namespace railbook::plot {

// A figure that could not be made; the text names the script and quotes gnuplot.
class PlotError : public files::OutsideError {
 public:
  using files::OutsideError::OutsideError;
};

// What becomes of a curve without a point, or of a range without extent: an error, or a figure that
// does without.
enum class EmptyCurve { error, skip };

// Runs `gnuplot -d -c script data[0] PNG data[1] ...` and leaves the result in `png`.
//
//   plot::render("fig-09.gp", {"fig-09.csv", "fig-09-printed.csv"}, "figures/fig-09.png");
//
// and the script begins
//
//   load "style.gp"
//   set output ARG2
//   set xlabel "distance along rolling direction, in"
//   plot ARG1 using "x_in":"p_psi" title "computed" with lines, ARG3 using 1:2 title "printed" with
//   points ls printed
//
// Data files are CSV with a header line (units in the names), or PNG pictures; gnuplot takes at
// most eight. It works in a private temporary folder, where the files have neutral names
// (script.gp, d1.csv, d2.csv, out.png; the data are links): gnuplot runs a file name such as
// "<program". style.gp and scene.gp are there, too; no start-up file is read. RAILBOOK_GNUPLOT
// names another gnuplot. After 60 s (RAILBOOK_GNUPLOT_SECONDS) it is ended with all it started.
// `png` is either the old file or a complete new one.
// Throws PlotError when the script or a data file is missing, when gnuplot is, exits non-zero or
// says anything on stderr (its warnings mean a curve that is not there), and when the result is not
// a complete PNG.
void render(const std::filesystem::path& script, const std::vector<std::filesystem::path>& data,
            const std::filesystem::path& png);

// The same, as the bytes of the PNG.
std::string draw(const std::filesystem::path& script,
                 const std::vector<std::filesystem::path>& data,
                 EmptyCurve missing = EmptyCurve::error);

// The same figure as the text of an SVG, for a page: its lines and letters stay sharp at any size.
// Every line "set terminal pngcairo ..." of the script and of style.gp is read as one for SVG.
std::string draw_svg(const std::filesystem::path& script,
                     const std::vector<std::filesystem::path>& data,
                     EmptyCurve missing = EmptyCurve::error);

// How long gnuplot may take over a figure: 1 to 86400 s of RAILBOOK_GNUPLOT_SECONDS, else 60. The
// longest takes some 3 s.
std::chrono::seconds time_limit();

// A file or folder of the project, "lib/plot": that in share/railbook beside the program's folder,
// or beside one above it. An installed program finds what was installed with it, a program of the
// build its tree (build/share/railbook leads there). Throws PlotError where there is no such
// folder.
std::filesystem::path shared(std::string_view name);

}  // namespace railbook::plot
