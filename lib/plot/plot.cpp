#include "plot/plot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace railbook::plot {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int status;
  std::string message;  // stderr
};

// A script needs nothing of ours but style.gp, and must give the same figure whatever the user's locale.
std::vector<std::string> environment_for_gnuplot() {
  std::vector<std::string> variables;
  for (char** v = environ; *v != nullptr; ++v) {
    const std::string_view text = *v;
    if (!text.starts_with("GNUPLOT") && !text.starts_with("LC_") && !text.starts_with("LANG")) {
      variables.emplace_back(text);
    }
  }
  variables.emplace_back("GNUPLOT_LIB=" RAILBOOK_STYLE_DIR);
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

std::string read_to_end(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t n = read(descriptor, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

// Starts the program directly (no shell: file names may hold anything), with nothing to read, its output
// thrown away and its messages collected.
Outcome run(std::vector<std::string> arguments) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw PlotError("cannot make a pipe: " + std::generic_category().message(errno));
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<std::string> variables = environment_for_gnuplot();
  pid_t child = 0;
  const int error = posix_spawn(&child, RAILBOOK_GNUPLOT, &actions, nullptr,
                                pointers(arguments).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Outcome outcome{0, read_to_end(ends[0])};
  close(ends[0]);
  if (error != 0) {
    throw PlotError("cannot run " RAILBOOK_GNUPLOT ": " + std::generic_category().message(error));
  }
  while (waitpid(child, &outcome.status, 0) < 0 && errno == EINTR) {
  }
  return outcome;
}

// gnuplot's own words, without empty lines and without the font library's remarks on its cache.
std::string complaints(const std::string& message) {
  std::istringstream lines(message);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    const bool blank = line.find_first_not_of(" \t\r") == std::string::npos;
    if (!blank && !line.starts_with("Fontconfig ")) kept += "\n  " + line;
  }
  return kept;
}

// A PNG opens with its signature and closes with an IEND chunk; an interrupted one lacks the latter.
bool is_complete_png(const fs::path& file) {
  using namespace std::string_view_literals;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream whole;
  whole << in.rdbuf();
  const std::string bytes = whole.str();
  return bytes.starts_with("\x89PNG\r\n\x1a\n"sv) && bytes.ends_with("IEND\xae\x42\x60\x82"sv);
}

void require_file(const fs::path& script, std::string_view what, const fs::path& file) {
  if (!fs::is_regular_file(file)) {
    throw PlotError(script.string() + ": " + std::string(what) + " " + file.string() +
                    " does not exist");
  }
}

// Removes the temporary file unless it was renamed.
struct Temporary {
  explicit Temporary(fs::path file) : path(std::move(file)) {}
  ~Temporary() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  fs::path path;
};

}  // namespace

void render(const fs::path& script, const std::vector<fs::path>& data, const fs::path& png) {
  require_file(script, "the script", script);
  if (data.empty() || data.size() > 8) {
    throw PlotError(script.string() + ": takes 1 to 8 data files, not " +
                    std::to_string(data.size()));
  }
  for (const fs::path& file : data) require_file(script, "the data file", file);
  if (png.has_parent_path()) fs::create_directories(png.parent_path());

  const Temporary unfinished(png.parent_path() / (".unfinished-" + std::to_string(getpid()) + "-" +
                                                  png.filename().string()));
  std::vector<std::string> arguments = {
      RAILBOOK_GNUPLOT, "-d", "-c", script.string(), data[0].string(), unfinished.path.string()};
  for (std::size_t i = 1; i < data.size(); ++i) arguments.push_back(data[i].string());

  const Outcome outcome = run(std::move(arguments));
  const std::string said = complaints(outcome.message);
  if (!WIFEXITED(outcome.status) || WEXITSTATUS(outcome.status) != 0) {
    const std::string how = WIFEXITED(outcome.status)
                                ? "exit status " + std::to_string(WEXITSTATUS(outcome.status))
                                : "signal " + std::to_string(WTERMSIG(outcome.status));
    throw PlotError(script.string() + ": gnuplot failed (" + how + ")" + said);
  }
  if (!said.empty()) throw PlotError(script.string() + ": gnuplot complained" + said);
  if (!is_complete_png(unfinished.path)) {
    throw PlotError(script.string() +
                    ": gnuplot left no complete PNG (is there a `set output ARG2` and a plot?)");
  }
  fs::rename(unfinished.path, png);
}

}  // namespace railbook::plot
