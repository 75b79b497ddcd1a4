#include <railbook/spectra/reference_spectra.hpp>

#include <array>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/nearest.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::spectra {
namespace {

using units::pi;

// S(Omega) in m^2/(rad/m) as a density over cycles.
std::function<double(double)> over_cycles(std::function<double(double)> s) {
  return [s = std::move(s)](double phi) { return 2 * pi * s(2 * pi * phi); };
}

void add_german(std::vector<Reference>& all) {
  struct Level {
    const char* name;
    double vertical, lateral;  // A, m^2 rad/m
  };
  for (const Level& level :
       {Level{"german-low", 4.032e-7, 2.119e-7}, {"german-high", 1.080e-6, 6.125e-7}})
    for (const bool vertical : {true, false}) {
      const double A = vertical ? level.vertical : level.lateral;
      all.push_back({level.name, vertical ? "vertical" : "lateral",
                     "ERRI B176, as in ORVD and VTCM_simulation", 1.0 / 150, 1.0,
                     over_cycles([A](double w) {
                       constexpr double c = 0.8246, r = 0.0206;
                       return A * c * c / ((w * w + r * r) * (w * w + c * c));
                     })});
    }
}

void add_fra(std::vector<Reference>& all) {
  constexpr std::array Av{1.2107, 1.0181, 0.6816, 0.5376, 0.2095, 0.0339};  // cm^2 rad/m
  constexpr std::array Aa{0.0762, 0.0339};                                  // classes 5 and 6
  const auto form = [](double A) {
    return over_cycles([A](double w) {
      constexpr double c = 0.8245, k = 0.25;
      return 1e-4 * k * A * c * c / (w * w * (w * w + c * c));
    });
  };
  for (std::size_t i = 0; i < Av.size(); ++i)
    all.push_back({"fra-" + std::to_string(i + 1), "vertical",
                   "FRA, form with A_v, as in TTB-2D and ORVD", 1.0 / 300, 1.0 / 1.5, form(Av[i])});
  for (std::size_t i = 0; i < Aa.size(); ++i)
    all.push_back({"fra-" + std::to_string(i + 5), "lateral", "FRA, form with A_a, as in ORVD",
                   1.0 / 300, 1.0 / 1.5, form(Aa[i])});
  constexpr std::array profile{16.7217, 9.5250, 5.2917,
                               2.9633,  1.6722, 0.9525};  // 1e-7 m^2 cycle/m
  constexpr std::array alignment{10.5833, 5.9267, 3.3867, 1.8838, 1.0583, 0.5927};
  const auto hamid = [](double A, double one, double two) {
    return [=](double p) {
      return 1e-7 * A * two * two * (p * p + one * one) / (std::pow(p, 4) * (p * p + two * two));
    };
  };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const std::string name = "hamid-yang-" + std::to_string(i + 1);
    const char* const source = "FRA, Hamid and Yang, as in VTCM_simulation; read as one-sided";
    all.push_back(
        {name, "vertical", source, 1.0 / 300, 1.0 / 1.5, hamid(profile[i], 0.0233, 0.1312)});
    all.push_back(
        {name, "lateral", source, 1.0 / 300, 1.0 / 1.5, hamid(alignment[i], 0.0328, 0.1837)});
  }
}

void add_china(std::vector<Reference>& all) {
  struct Piece {
    double to, A, n;
  };
  const auto pieces = [](std::vector<Piece> p) {
    return [p = std::move(p)](double phi) {
      for (const Piece& piece : p)
        if (phi <= piece.to || &piece == &p.back()) return 1e-6 * piece.A * std::pow(phi, -piece.n);
      return 0.0;
    };
  };
  const char* const source = "TB/T 3352-2014, as in JBG_SDITT and VTCM_simulation";
  all.push_back({"china-hsr", "vertical", source, 0.005, 0.5,
                 pieces({{0.0187, 1.0544e-5, 3.3891},
                         {0.0474, 3.5588e-3, 1.9271},
                         {0.1533, 1.9784e-2, 1.3643},
                         {0.5, 3.9488e-4, 3.4516}})});
  all.push_back(
      {"china-hsr", "lateral", source, 0.005, 0.5,
       pieces(
           {{0.0450, 3.9513e-3, 1.8670}, {0.1234, 1.1047e-2, 1.5354}, {0.5, 7.5633e-4, 2.8171}})});
}

}  // namespace

const std::vector<Reference>& references() {
  static const std::vector<Reference> all = [] {
    std::vector<Reference> list;
    add_german(list);
    add_fra(list);
    add_china(list);
    return list;
  }();
  return all;
}

const Reference& reference(std::string_view name, std::string_view channel) {
  std::string there;
  std::vector<std::string> names;
  for (const Reference& r : references()) {
    if (r.channel != channel) continue;
    if (r.name == name) return r;
    there += (there.empty() ? "" : ", ") + r.name;
    names.push_back(r.name);
  }
  throw InputError{"reference is \"" + units::printable(name) + "\"; allowed: " + there +
                   units::did_you_mean(name, names)};
}

}  // namespace railbook::spectra
