// The options of a tool: the same on the command line and in a TOML file (--config).
//
//   tool::Tool stiffness{"stiffness", "track stiffness of your own track", [](tool::OptionParser&
//   o) {
//     auto in = std::make_shared<Input>();
//     o.quantity("--tie-spacing", in->tie_spacing, units::length, "distance between ties");
//     o.choice("--rail", in->rail, {"115RE", "132RE"}, "rail section");
//     o.out(in->out);
//     return [in] { run(*in); };       // called after the options are read and checked
//   }};
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/units/input_error.hpp>
#include <railbook/units/quantity.hpp>

namespace CLI {
class App;
}

namespace railbook::tool {

// Allowed range of an option, SI. `open_low`: from 0 on, without it.
struct Range {
  double low = -units::infinity;
  double high = units::infinity;
  bool open_low = false;
};
inline constexpr Range positive{0, units::infinity, true};
inline constexpr const char* toml_type = "TOML";  // type name of the options of Options::toml
inline constexpr Range non_negative{0, units::infinity, false};

// Where a tool's files go, if anywhere (see OutFolder).
struct Destination {
  std::optional<std::filesystem::path> folder;
  bool no_figures = false;
  std::optional<std::filesystem::path> figure = {};  // the first figure alone goes here
};

// Records to answer, one or many (see batch.hpp).
struct RecordFiles {
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> manifest;
  bool many() const;
  // The one record. Throws InputError when there is none.
  const std::filesystem::path& only() const;
};

class OptionParser {
 public:
  explicit OptionParser(CLI::App& app) : app_(&app) {}

  // Names: "--tie-spacing", or "record" for a positional argument. The value the variable holds
  // beforehand is the default; an optional<double> without one is an option that may be absent.
  void quantity(const std::string& name, double& value, const units::Dimension& dimension,
                const std::string& help, Range range = {});
  void quantity(const std::string& name, std::optional<double>& value,
                const units::Dimension& dimension, const std::string& help, Range range = {});
  void quantities(const std::string& name, std::vector<double>& values,
                  const units::Dimension& dimension, const std::string& help, Range range = {});
  void count(const std::string& name, long& value, const std::string& help, long low, long high);
  void text(const std::string& name, std::string& value, const std::string& help);
  void choice(const std::string& name, std::string& value, const std::vector<std::string>& allowed,
              const std::string& help);
  // "--column a,b" and "--column a --column b"; by blanks: "--column a b" too.
  void texts(const std::string& name, std::vector<std::string>& values, const std::string& help,
             bool by_blanks = false);
  // "record ..." and --manifest.
  void records(RecordFiles& records);
  void file(const std::string& name, std::filesystem::path& value, const std::string& help);
  // "--wheel a.whl b.whl".
  void files(const std::string& name, std::vector<std::filesystem::path>& values,
             const std::string& help);
  // A further file of options, after --config: "--car freight.toml".
  void toml(const std::string& name, const std::string& help);
  void flag(const std::string& name, bool& value, const std::string& help);
  // The last option or argument added must be given.
  void required();
  // What --help says at its end: columns, files, and an example to start from.
  void help(const std::string& text);
  // "--out DIR": where files go; without it a tool only prints. "--no-figures": without gnuplot;
  // "--figure FILE": the first figure and nothing else.
  void out(Destination& destination);

 private:
  CLI::App* app_;
  void* last_ = nullptr;
};

// Declares options, then returns what runs the tool.
using ToolSetup = std::function<std::function<void()>(OptionParser&)>;

struct Tool {
  std::string name, help;
  ToolSetup setup;
};

}  // namespace railbook::tool
