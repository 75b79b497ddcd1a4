// Built by fuzz.sh with libFuzzer, where libhdf5 and libmatio are: HDF5 and MAT files, read in this
// process. What the libraries themselves do with a damaged file is the matter of the program that
// the command starts; here it is found whether our own part stands it.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <railbook/containers/container.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int file = memfd_create("fuzz", 0);
  if (file < 0 || write(file, data, size) != static_cast<ssize_t>(size)) std::abort();
  try {
    const auto contents = containers::contents_of("/proc/self/fd/" + std::to_string(file));
    for (const containers::DataSet& set : contents.sets) {
      std::size_t bytes = 0;
      try {
        containers::write_table(contents, set.path(), [&](const std::string& text) {
          bytes += text.size();
          if (bytes > (std::size_t{1} << 20)) throw InputError{"enough of it"};
        });
      } catch (const InputError&) {
      }
    }
  } catch (const InputError&) {
  }
  close(file);
  return 0;
}
