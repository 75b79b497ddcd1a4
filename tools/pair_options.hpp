// Wheel and rail from files, in their places, as options: the same for `hunting` and `wheelrail`.
//
//   add_profile_options(parser, options);          // --wheel, --rail, --gauge, --cant, ...
//   add_right_options(parser, options);            // where the right side differs
//   const Curve rail = placed_rail(options, Place::right, curve, fit.depth_below_end);
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/profiles/curve.hpp>
#include <railbook/profiles/profile_points.hpp>
#include <railbook/profiles/read_profile.hpp>
#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>

namespace railbook::tools {

// What a file of a wheel or a rail does not say.
struct ProfileForm {
  bool mirror = false, flip = false;
  std::string unit = "found";
  std::string columns = "found";  // "2,3"
  long section = 0;               // 0: the only one
};

// How a rail lies off its place on the track [m, rad].
struct RailPlace {
  double shift = 0, lift = 0, roll = 0;  // to the right, upwards, right side down
};

enum class Side { left, right };

// SI, with the European places.
struct PairOptions {
  std::filesystem::path wheel, rail;                 // of both sides, or of the left one
  std::vector<std::filesystem::path> wheels, rails;  // of which they are one, see answer_pairs()
  std::filesystem::path right_wheel, right_rail;     // where they are not the left ones
  double gauge = 1.435, gauge_depth = 0.014, cant = 0.025, back_to_back = 1.360, radius = 0.460;
  std::optional<double> datum, right_radius, right_cant, noise;
  double smoothing = 1;  // times the one that noise or scatter asks for
  ProfileForm wheel_form, rail_form;
  RailPlace left_place, right_place;
};

// "--mirror-wheel" and its like for one body; of a nameless one "--mirror".
void add_form_options(tool::OptionParser& parser, const std::string& body, ProfileForm& form);
// --datum and --noise.
void add_datum_options(tool::OptionParser& parser, PairOptions& options);
// `several`: --wheel and --rail take several files, for answer_pairs().
void add_profile_options(tool::OptionParser& parser, PairOptions& options, bool several = false);
// The options for a right side of its own.
void add_right_options(tool::OptionParser& parser, PairOptions& options);

struct PairFiles {
  std::filesystem::path wheel, rail;
};
// Each wheel on each rail, at least one pair.
std::vector<PairFiles> pairs_of(const PairOptions& options);
// A row a pair, as run_batch().
void run_pairs(const std::vector<PairFiles>& pairs, const tool::Destination& out,
               const std::string& name,
               const std::function<tool::Summary(const PairFiles&)>& answer);
// Answers several pairs in rows, `answer` taking the options of one. False for one pair, which then
// stands in `options`.
template <class Options, class Answer>
bool answer_pairs(Options& options, const std::string& name, const Answer& answer) {
  const std::vector<PairFiles> pairs = pairs_of(options);
  const auto of = [&](const PairFiles& files) {
    Options one = options;
    one.wheel = files.wheel, one.rail = files.rail;
    return one;
  };
  if (pairs.size() == 1) {
    options = of(pairs.front());
    return false;
  }
  run_pairs(pairs, options.out, name, [&](const PairFiles& files) { return answer(of(files)); });
  return true;
}

// Whether the right side has another wheel, rail, radius or place than the left one.
bool sides_differ(const PairOptions& options);
// Whether an option that places or reads profiles differs from `usual`.
bool places_differ(const PairOptions& options, const PairOptions& usual);

// A profile from its file. `what` is "wheel", "right wheel", "rail" or "right rail". Throws
// InputError naming the file or the option.
profiles::Curve read_profile(const PairOptions& options, const char* what,
                             const std::filesystem::path& file,
                             std::vector<profiles::ProfileFit>& fits);
// The rail in its place, seen from the middle of the track outwards (a left side).
profiles::Curve placed_rail(const PairOptions& options, Side side, const profiles::Curve& rail,
                            double depth_below_end);
// Of the tape circle from the middle of the axle [m].
double tape_from_middle(const PairOptions& options);

// "wheel_rms_mm" and its like: how well the points were met.
void describe_fits(tool::Summary& answer, const PairOptions& options,
                   const std::vector<profiles::ProfileFit>& fits);
// Lists the points that were left out, and warns of what looks wrong with the others. `stands` says
// where the contact stands on a suspected place, if it does: "at shifts of 1 to 3 mm", or nothing.
using StandsOn = std::function<std::string(const profiles::ProfileFit& fit,
                                           const profiles::PointsWarning& warning)>;
void flag_points(tool::Summary& answer, const std::vector<profiles::ProfileFit>& fits,
                 const StandsOn& stands);

}  // namespace railbook::tools
