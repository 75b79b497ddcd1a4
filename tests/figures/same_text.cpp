// same_text A.json B.json: whether two runs of a chapter say the same in every text of their
// records: values of the prose, computed values of checks, rows of tables, results of stability
// cases. Names of pictures, the machine and the compiler, and numbers behind the texts may differ,
// and so may a text that says in one of the two that something was "not timed". Exit status 0: they
// do; 1: not, each place on a line of its own; 2: usage.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace {

using nlohmann::json;

json read(const char* file) {
  std::ifstream in(file);
  json record = json::parse(in, nullptr, false);
  if (record.is_discarded())
    throw std::runtime_error(std::string(file) + ": no record of a whole run");
  return record;
}

// The place of a member for the reader: by its id where it has one.
std::string named(const json& value, const std::string& key) {
  if (value.is_object() && value.contains("id") && value["id"].is_string())
    return value["id"].get<std::string>();
  return key;
}

bool untimed(const json& text) {
  return text.is_string() && text.get<std::string>().find("not timed") != std::string::npos;
}

// Prints the places where the texts of `a` and `b` differ, and counts them.
int differences(const json& a, const json& b, const std::string& place) {
  if (a.type() != b.type() && !(a.is_number() && b.is_number())) {
    fmt::print("{}: {} and {}\n", place, a.dump(), b.dump());
    return 1;
  }
  if (a.is_string() || a.is_boolean()) {
    if (a == b || untimed(a) != untimed(b)) return 0;
    fmt::print("{}: {} and {}\n", place, a.dump(), b.dump());
    return 1;
  }
  if (!a.is_structured()) return 0;
  if (a.size() != b.size()) {
    fmt::print("{}: {} and {} entries\n", place, a.size(), b.size());
    return 1;
  }
  int count = 0;
  const auto flat_b = b.items();
  auto other = flat_b.begin();
  for (const auto& [key, value] : a.items()) {
    if (key != other.key()) {
      fmt::print("{}: {} and {}\n", place, key, other.key());
      return count + 1;
    }
    if (key != "png" && key != "machine")  // one of the two may be without pictures, or another's
      count += differences(value, other.value(), place + "/" + named(value, key));
    ++other;
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    fmt::print(stderr, "usage: same_text A.json B.json\n");
    return 2;
  }
  const int count = differences(read(argv[1]), read(argv[2]), "");
  fmt::print("{} texts differ\n", count);
  return count == 0 ? 0 : 1;
} catch (const std::exception& e) {
  fmt::print(stderr, "same_text: {}\n", e.what());
  return 2;
}
