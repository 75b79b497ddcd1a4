#include <railbook/plot/plot.hpp>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

#include <railbook/files/out_file.hpp>
#include <railbook/files/staged.hpp>
#include <railbook/plot/packed_picture.hpp>

namespace railbook::plot {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int status = 0;
  std::string message;  // stderr
  bool in_time = true;
};

using Clock = std::chrono::steady_clock;

std::string program() {
  if (const char* wanted = std::getenv("RAILBOOK_GNUPLOT"); wanted != nullptr && *wanted != 0)
    return wanted;
  return fs::exists(RAILBOOK_GNUPLOT) ? RAILBOOK_GNUPLOT : "gnuplot";
}

// A script must give the same figure whatever the user's locale and settings of gnuplot.
std::vector<std::string> environment_for_gnuplot() {
  std::vector<std::string> variables;
  for (char** v = environ; *v != nullptr; ++v) {
    const std::string_view text = *v;
    if (!text.starts_with("GNUPLOT") && !text.starts_with("LC_") && !text.starts_with("LANG")) {
      variables.emplace_back(text);
    }
  }
  variables.emplace_back("LC_ALL=C.UTF-8");
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

// Starts the program directly (no shell), in `folder` and in a process group of its own, with
// nothing to read, its output thrown away and its messages going to `messages`. No signal waits in
// it, whatever waits here.
pid_t start(std::vector<std::string> arguments, const fs::path& folder, int messages) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::vector<std::string> variables = environment_for_gnuplot();
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments[0].c_str(), &actions, &attributes,
                                 pointers(arguments).data(), pointers(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return child;
  throw PlotError("cannot run " + arguments[0] + ": " + std::generic_category().message(error) +
                  " (is gnuplot installed? RAILBOOK_GNUPLOT names another)");
}

// What came by now, waiting a little; false at the end.
bool read_some(int descriptor, std::string& text) {
  pollfd ready{descriptor, POLLIN, 0};
  if (poll(&ready, 1, 20) <= 0) return true;
  std::array<char, 4096> buffer{};
  const ssize_t n = TEMP_FAILURE_RETRY(read(descriptor, buffer.data(), buffer.size()));
  if (n > 0) text.append(buffer.data(), static_cast<std::size_t>(n));
  return n > 0;
}

Outcome run(std::vector<std::string> arguments, const fs::path& folder) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw PlotError("cannot make a pipe: " + std::generic_category().message(errno));
  struct Closed {
    ~Closed() { close(descriptor); }
    int descriptor;
  };
  const Closed reading{ends[0]};
  pid_t child = 0;
  std::optional<files::ChildGuard> doomed;
  {
    const files::BlockSignals until_guarded;  // or one that ends us would leave gnuplot
    const Closed writing{ends[1]};
    child = start(std::move(arguments), folder, ends[1]);
    doomed.emplace(child);
  }
  const Clock::time_point end = Clock::now() + time_limit();
  Outcome outcome;
  bool more = true;
  while (waitpid(child, &outcome.status, WNOHANG) == 0) {
    if (more) more = read_some(reading.descriptor, outcome.message);
    if (!more) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (outcome.in_time && Clock::now() > end) {
      outcome.in_time = false;
      kill(child, SIGKILL);
    }
  }
  kill(-child, SIGKILL);  // and what it may have started
  for (std::size_t before = std::string::npos; more && before != outcome.message.size();) {
    before = outcome.message.size();
    more = read_some(reading.descriptor, outcome.message);
  }
  return outcome;
}

// gnuplot's own words, without empty lines and without the font library's remarks on its cache.
std::string complaints(const std::string& message, EmptyCurve missing) {
  const auto is_about_missing = [](std::string_view line) {
    return line.find("Skipping data file with no valid points") != line.npos ||
           line.starts_with("Warning: empty ");
  };
  std::istringstream lines(message);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    const bool blank = line.find_first_not_of(" \t\r") == std::string::npos;
    if (blank || line.starts_with("Fontconfig ")) continue;
    if (missing == EmptyCurve::skip && is_about_missing(line)) continue;
    kept += "\n  " + line;
  }
  return kept;
}

// A PNG opens with its signature and closes with an IEND chunk; an interrupted one lacks the
// latter.
bool is_complete_png(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\x89PNG\r\n\x1a\n"sv) && bytes.ends_with("IEND\xae\x42\x60\x82"sv);
}

void require_file(const fs::path& script, std::string_view what, const fs::path& file) {
  if (!fs::is_regular_file(file)) {
    throw PlotError(script.string() + ": " + std::string(what) + " " + file.string() +
                    " does not exist");
  }
}

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code error;
  std::string whole(in ? fs::file_size(file, error) : 0, '\0');
  if (error || !in.read(whole.data(), static_cast<std::streamsize>(whole.size())))
    throw PlotError("file " + files::quoted_name(file) + ": cannot be read");
  return whole;
}

enum class Format { png, svg };

// A script whose terminal is pngcairo, for SVG: size and font as they are, or those of style.gp.
std::string for_svg(const std::string& script) {
  constexpr std::string_view png = "set terminal pngcairo";
  std::istringstream lines(script);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(png)) {
      line.replace(0, png.size(), "set terminal svg");
      if (line.find("font") == line.npos) line += " font \"DejaVu Sans,14\"";
      if (line.find("background") == line.npos) line += " background rgb \"white\"";
    }
    text += line + "\n";
  }
  return text;
}

// A script for PNG at twice its size in pixels, with everything in it twice as large: sharp on
// dense screens and on paper. The width and the height may be expressions, without a blank outside
// their brackets.
std::string for_png(const std::string& script) {
  constexpr std::string_view size = "set terminal pngcairo size ";
  std::istringstream lines(script);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(size)) {
      std::size_t comma = line.npos, end = size.size();
      for (int depth = 0; end < line.size() && (depth > 0 || line[end] != ' '); ++end) {
        depth += line[end] == '(' ? 1 : line[end] == ')' ? -1 : 0;
        if (depth == 0 && line[end] == ',') comma = end;
      }
      if (comma == line.npos) throw PlotError("\"" + line + "\": no width and height");
      const std::string width = line.substr(size.size(), comma - size.size());
      const std::string height = line.substr(comma + 1, end - comma - 1);
      const std::string rest = line.substr(end) + " fontscale 2 linewidth 2 pointscale 2";
      line.assign(size).append("2*(").append(width).append("),2*(").append(height).append(")");
      line.append(rest);
    }
    text.append(line).append("\n");
  }
  return text;
}

// gnuplot opens a group for each change of the pen; most of them stay empty, and are a third of the
// file.
std::string without_empty_groups(const std::string& svg) {
  std::istringstream lines{svg};
  std::string out, group;
  for (std::string line; std::getline(lines, line);) {
    if (!group.empty() && line == "</g>") {
      group.clear();
      continue;
    }
    out += group;
    group.clear();
    (line.starts_with("<g ") && line.ends_with(">") ? group : out) += line + "\n";
  }
  return out + group;
}

// The font stated once, for the whole picture, and with a second one of the same widths for readers
// who have no DejaVu Sans.
std::string with_fonts(std::string svg) {
  constexpr std::string_view font = " font-family=\"DejaVu Sans\"", root = "<svg ";
  for (std::size_t at = 0; (at = svg.find(font, at)) != svg.npos;) svg.erase(at, font.size());
  return svg.insert(svg.find(root) + root.size(),
                    "font-family=\"DejaVu Sans, Verdana, sans-serif\" ");
}

// gnuplot runs "<program" and "|program" given as file names: it gets to see names of ours only.
std::vector<std::string> prepare(files::PrivateFolder& folder, const fs::path& script,
                                 const std::vector<fs::path>& data, Format format) {
  const fs::path style = shared("lib/plot");
  const auto text = [&](const fs::path& file) {
    return format == Format::svg ? for_svg(contents(file)) : for_png(contents(file));
  };
  for (const char* name : {"style.gp", "scene.gp"}) folder.write(name, text(style / name));
  folder.write("script.gp", text(script));
  std::vector<std::string> arguments = {program(), "-d", "-c", "script.gp"};
  for (std::size_t i = 0; i < data.size(); ++i) {
    const std::string type = data[i].extension() == ".png" ? ".png" : ".csv";
    arguments.push_back("d" + std::to_string(i + 1) + type);
    folder.link(arguments.back(), data[i]);
    if (i == 0) arguments.push_back(format == Format::svg ? "out.svg" : "out.png");
  }
  return arguments;
}

// What gnuplot made of the script, complete or not.
std::string drawn(const fs::path& script, const std::vector<fs::path>& data, EmptyCurve missing,
                  Format format) {
  require_file(script, "the script", script);
  if (data.empty() || data.size() > 8) {
    throw PlotError(script.string() + ": takes 1 to 8 data files, not " +
                    std::to_string(data.size()));
  }
  for (const fs::path& file : data) require_file(script, "the data file", file);
  files::PrivateFolder folder;
  std::vector<std::string> arguments = prepare(folder, script, data, format);
  const fs::path picture = folder.expect(arguments[5]);
  const Outcome outcome = run(std::move(arguments), folder.path());
  const std::string complaint = complaints(outcome.message, missing);
  if (!outcome.in_time) {
    throw PlotError(script.string() + ": gnuplot was ended after " +
                    std::to_string(time_limit().count()) + " s" + complaint);
  }
  if (!WIFEXITED(outcome.status) || WEXITSTATUS(outcome.status) != 0) {
    const std::string how = WIFEXITED(outcome.status)
                                ? "exit status " + std::to_string(WEXITSTATUS(outcome.status))
                                : "signal " + std::to_string(WTERMSIG(outcome.status));
    throw PlotError(script.string() + ": gnuplot failed (" + how + ")" + complaint);
  }
  if (!complaint.empty()) throw PlotError(script.string() + ": gnuplot complained" + complaint);
  return fs::exists(picture) ? contents(picture) : std::string{};
}

}  // namespace

std::chrono::seconds time_limit() {
  const char* wanted = std::getenv("RAILBOOK_GNUPLOT_SECONDS");
  const long seconds = wanted == nullptr ? 0 : std::strtol(wanted, nullptr, 10);
  return std::chrono::seconds(seconds >= 1 && seconds <= 86400 ? seconds : 60);
}

fs::path shared(std::string_view name) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (fs::path at = program.parent_path(); at.has_relative_path(); at = at.parent_path())
    if (fs::exists(at / "share/railbook/lib/plot/style.gp", ignored))
      return at / "share/railbook" / name;
  throw PlotError("no folder share/railbook beside " + files::quoted_name(program) +
                  " or above it: the installation is not complete");
}

std::string draw(const fs::path& script, const std::vector<fs::path>& data, EmptyCurve missing) {
  std::string bytes = drawn(script, data, missing, Format::png);
  if (!is_complete_png(bytes)) {
    throw PlotError(script.string() +
                    ": gnuplot left no complete PNG (is there a `set output ARG2` and a plot?)");
  }
  return bytes;
}

std::string draw_svg(const fs::path& script, const std::vector<fs::path>& data,
                     EmptyCurve missing) {
  const std::string text = drawn(script, data, missing, Format::svg);
  if (text.find("<svg") == text.npos || text.find("</svg>") == text.npos)
    throw PlotError(script.string() + ": gnuplot left no complete SVG");
  return with_fonts(without_empty_groups(text));
}

void render(const fs::path& script, const std::vector<fs::path>& data, const fs::path& png) {
  files::write(png, packed_png(draw(script, data)));
}

}  // namespace railbook::plot
