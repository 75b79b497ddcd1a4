// replay COUNT FILES...: the parsers on each file of the corpus, and on COUNT seeded mutations of
// them (bytes flipped, cut, doubled and crossed). What libFuzzer found once stays in the corpus.
// Files in a folder `containers` are read by the program of that name.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 2;
  std::vector<std::string> corpus;
  for (int k = 2; k < count; ++k) {
    const std::string name = arguments[k];
    std::ifstream in(name, std::ios::binary);
    corpus.emplace_back(name.find("/containers/") != name.npos ? "h\n" : "");
    corpus.back().append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    run(corpus.back());
  }
  std::mt19937_64 random(1);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::string telling = "0123456789+-.eE,;\t\"'#=[]{}\\\n\r _/^*()%\xc3\xbc";
  const long wanted = std::atol(arguments[1]);
  for (long n = 0; n < wanted; ++n) {
    std::string bytes = corpus[below(corpus.size())];
    for (std::size_t change = below(4) + 1; change > 0 && bytes.size() > 1; --change) {
      const std::size_t at = 1 + below(bytes.size() - 1);
      switch (below(6)) {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes[at] = telling[below(telling.size())];
          break;
        case 2:
          bytes.insert(at, 1, telling[below(telling.size())]);
          break;
        case 3:
          bytes.erase(at, 1 + below(8));
          break;
        case 4:
          bytes.insert(at, bytes.substr(at, 1 + below(16)));
          break;
        default: {
          const std::string& other = corpus[below(corpus.size())];
          bytes = bytes.substr(0, at) + other.substr(below(other.size()));
        }
      }
    }
    run(bytes);
  }
  std::printf("%zu files, %ld mutations\n", corpus.size(), wanted);
}
