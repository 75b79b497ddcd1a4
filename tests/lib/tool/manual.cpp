// What the command says of itself, for man and for the shells.
#include <railbook/tool/detail/manual.hpp>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <railbook/units/input_error.hpp>

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

TEST_CASE("unit: user text in the manual cannot inject roff requests") {
  CLI::App app{"it's\n'quoted\n.dotted\n-o", "railbook"};
  app.footer("a\\b");
  CLI::App* tool = app.add_subcommand("psd", "of roughness")->add_subcommand("fit", "fits");
  tool->set_help_flag();
  std::string one = "x-y", two;
  tool->add_option("--one", one, "first")->type_name("TEXT")->capture_default_str();
  tool->add_option("two", two, "second")->type_name("")->required();
  tool->footer("The end.");
  CHECK(tool::manual(app, "9") ==
        ".TH RAILBOOK 1 \"\" \"railbook 9\" \"User Commands\"\n.SH NAME\n"
        "it's\n\\&'quoted\n\\&.dotted\n\\-o\n.SH SYNOPSIS\n.B railbook\nSUBJECT TOOL [OPTIONS]\n"
        ".SH DESCRIPTION\n.nf\na\\eb\n.fi\n.SH railbook psd fit\nfits\n"
        ".TP\n.B \\-\\-one TEXT\nfirst [x\\-y]\n.TP\n.B two\nsecond (required)\n"
        ".PP\n.nf\nThe end.\n.fi\n");
}

TEST_CASE("unit: a shell is offered what stands at its place, and no arguments of a tool") {
  CLI::App app{"a", "railbook"};
  CLI::App* subject = app.add_subcommand("psd", "b");
  CLI::App* fit = subject->add_subcommand("fit", "c");
  CLI::App* plain = subject->add_subcommand("plain", "d");
  CLI::App* verify = app.add_subcommand("verify", "e");  // a subject that is a tool itself
  std::string kind, file, data;
  fit->set_help_flag();
  plain->set_help_flag();
  verify->add_option("--data", data, "")->type_name("FOLDER");
  fit->add_option("--kind", kind, "")->type_name("{a,b,c}");
  fit->add_option("file", file, "")->type_name("{d,e}");
  plain->add_option("--file", file, "")->type_name("FILE");
  const std::string cases =
      "    '') offer='psd verify --help --version' ;;\n    'psd') offer='fit plain --help' ;;\n"
      "    'psd fit') offer='--kind '\n      case $before in\n"
      "      '--kind') offer='a b c' ;;\n      esac\n      ;;\n"
      "    'psd plain') offer='--file '\n      ;;\n    'verify') offer='--help --data '\n      "
      ";;\n  esac\n";
  for (const char* shell : {"bash", "zsh"})
    CHECK_THAT(tool::completion(app, shell), Contains("  case $place in\n" + cases));
  CHECK_THAT(tool::completion(app, "bash"),
             Contains("complete -o default -F _railbook railbook\n"));
  CHECK_THAT(tool::completion(app, "zsh"), Contains("#compdef railbook\n"));
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
