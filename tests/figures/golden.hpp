// What a chapter has drawn against what is committed under figures/NN-name: data everywhere, pixels
// where the pictures were made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace railbook::figures {

inline constexpr int levels = 3;  // a pixel is off when a channel is further off than this
inline constexpr double allowed_share = 0.001;  // of the pixels may be off
inline constexpr double relative = 1e-6;        // what a number may be off, of its value
inline constexpr double of_largest = 1e-9;      // or of the largest in its column

// A figure of a chapter's record.
struct Figure {
  std::string png;               // name in `pictures`
  std::vector<std::string> csv;  // names in `data`; a scene has none
  bool drawn = true;             // not a scene in a build that draws none
  std::string caption;
};
struct Drawn {
  std::string chapter, title;
  std::filesystem::path pictures, data;
  std::vector<Figure> figures;
};

// The figures of the run whose --out was `out`. Throws std::runtime_error when it left no whole
// record.
Drawn read_run(const std::filesystem::path& out, const std::string& chapter);

// What was compared, one line a file, and what is wrong with it, one line a fault.
struct Report {
  std::vector<std::string> compared;
  std::vector<std::string> faults;
};

// Compares every figure with the folder `golden`. Each file must be on both sides; data agree to
// the tolerance that the drawn file states (report::Data::holds_to); pictures are alike up to
// `levels` and `allowed_share` when `pixels` and their data fix them, and otherwise whole, of the
// golden's size and of more than one colour. A record without figures is a fault.
Report compare(const Drawn& drawn, const std::filesystem::path& golden, bool pixels);

// The same of the golden folder's data alone, for a run without pictures that left its data in the
// folder `data`.
Report compare_data(const std::filesystem::path& data, const std::filesystem::path& golden);

// Makes the figures the golden set in the folder `golden`, with a README.md that shows them. A file
// that compares as alike stays as it was committed, so that only what has changed changes. Files of
// more than `kept_bytes` keep every n-th row.
inline constexpr std::size_t kept_bytes = 40'000;
Report accept(const Drawn& drawn, const std::filesystem::path& golden);

// The data of two files: empty when they agree, otherwise the first number that does not, and in
// how many it is so.
std::string data_fault(const std::filesystem::path& drawn, const std::filesystem::path& golden);
// The text to commit for a file of data: numbers of eight digits, every n-th row where it is long.
std::string golden_text(const std::filesystem::path& drawn);
// Whether the file says that it is not compared.
bool is_compared(const std::filesystem::path& data);
// Whether all its columns hold to less than what shows in a picture, 1e-3 of a value or of the
// largest in its column.
bool fixes_the_picture(const std::filesystem::path& data);

}  // namespace railbook::figures
