// What the command says of itself, for man and for the shells.
#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include "tool/manual.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

struct Command {
  CLI::App app{"wheel, rail and track", "railbook"};
  double speed = 0;
  std::string window = "hann", file;
  Command() {
    app.footer(".a line that begins with a point");
    CLI::App* tool =
        app.add_subcommand("psd", "roughness")->add_subcommand("classify", "a class of track");
    tool->add_option("--speed", speed, "of the car")->type_name("QUANTITY")->required();
    tool->add_option("--window", window, "of a segment")
        ->type_name("{hann,hamming}")
        ->capture_default_str();
    tool->add_option("record", file, "a back\\slash");
  }
};

}  // namespace

TEST_CASE("unit: the manual has each option with its kind, its default and what must be given") {
  Command command;
  const std::string text = tool::manual(command.app, "1.2");
  CHECK_THAT(text, Contains("\"railbook 1.2\"") && Contains(".SH railbook psd classify\n"));
  CHECK_THAT(text, Contains(".TP\n.B \\-\\-speed QUANTITY\nof the car (required)\n"));
  CHECK_THAT(text, Contains(".B \\-\\-window {hann,hamming}") &&
                       Contains("of a segment [hann]\n") && Contains("\n.B record"));
  CHECK_THAT(text, Contains("a back\\eslash") && Contains("\n\\&.a line"));
}

TEST_CASE("unit: shells complete subjects, tools, options and choices") {
  Command command;
  for (const char* shell : {"bash", "zsh"}) {
    const std::string text = tool::completion(command.app, shell);
    CHECK_THAT(text, Contains("'') offer='psd --help --version' ;;") &&
                         Contains("'psd') offer='classify --help' ;;") &&
                         Contains("'psd classify') offer='--help --speed --window '"));
    CHECK_THAT(text,
               Contains("'--window') offer='hann hamming' ;;") && !Contains("'--speed') offer"));
  }
  CHECK_THROWS_WITH(tool::completion(command.app, "fish"), Contains("allowed: bash, zsh"));
}
