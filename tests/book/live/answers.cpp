// The functions of the live figures, called natively: what the module must answer, too.
//
// live_answers STATES prints their description and, for each line "FUNCTION TOLERANCE input=value
// ..." of the file, a line of JSON with the layout and the numbers of the answer, or its error.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

extern "C" {
const char* live_describe();
double* live_buffer(int size);
int live_call(int number, int count);
const char* live_text();
}

namespace {

// Of a line of the description: the function's name, the list it takes, and defaults by input.
struct Described {
  std::string name, list;
  std::vector<std::pair<std::string, double>> inputs;
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

std::vector<Described> described() {
  std::vector<Described> all;
  for (const std::string& line : split(live_describe(), '\n')) {
    const auto parts = split(line, '\t');
    Described d{parts[0], parts[1], {}};
    for (std::size_t i = 2; i < parts.size(); ++i) {
      const auto fields = split(parts[i], '|');
      d.inputs.emplace_back(fields[0], std::strtod(fields[2].c_str(), nullptr));
    }
    all.push_back(d);
  }
  return all;
}

nlohmann::json answer(const std::vector<Described>& functions, const std::string& line) {
  std::istringstream words(line);
  std::string name, tolerance, word;
  words >> name >> tolerance;
  std::map<std::string, std::string> given;
  while (words >> word) given[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const Described& f = functions[k];
    if (f.name != name) continue;
    std::vector<double> values;
    for (const auto& [input, value] : f.inputs)
      values.push_back(given.count(input) ? std::strtod(given[input].c_str(), nullptr) : value);
    if (given.count(f.list))
      for (const std::string& v : split(given[f.list], ','))
        values.push_back(std::strtod(v.c_str(), nullptr));
    double* into = live_buffer(static_cast<int>(values.size()));
    std::copy(values.begin(), values.end(), into);
    const int count = live_call(static_cast<int>(k), static_cast<int>(values.size()));
    nlohmann::json result{{"state", line}, {"text", live_text()}};
    if (count < 0) return result;
    result["numbers"] = nlohmann::json::array();
    for (int i = 0; i < count; ++i) {
      const double x = live_buffer(0)[i];
      if (std::isfinite(x))
        result["numbers"].push_back(x);
      else
        result["numbers"].push_back(std::isnan(x) ? "NaN" : x > 0 ? "Infinity" : "-Infinity");
    }
    return result;
  }
  throw std::runtime_error("no function \"" + name + "\"");
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("live_answers STATES");
  std::ifstream states(argv[1]);
  if (!states) throw std::runtime_error("no file " + std::string(argv[1]));
  const auto functions = described();
  std::cout << nlohmann::json{{"describe", live_describe()}} << '\n';
  for (std::string line; std::getline(states, line);)
    if (!line.empty() && line.front() != '#') std::cout << answer(functions, line) << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
