// containers FILE [DATASET]: a table of an HDF5 or MAT file as CSV on standard output. The command
// `railbook` starts it. What goes wrong is one line on standard error: status 2 for the file, 3 for
// the machine.
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include <railbook/containers/container.hpp>
#include <railbook/files/staged.hpp>
#include <railbook/units/input_error.hpp>

namespace {

constexpr rlim_t most_memory = rlim_t{2} << 30;  // bytes

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

}  // namespace

int main(int count, char** arguments) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // it does not outlive who reads it
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
#ifndef __SANITIZE_ADDRESS__
  limit(RLIMIT_AS, most_memory);
#endif
  if (count < 2) return 2;
  const auto put = [](const std::string& text) {
    if (const int error = railbook::files::write_all(STDOUT_FILENO, text); error != 0)
      throw std::system_error(error, std::generic_category());
  };
  try {
    railbook::containers::write_table(railbook::containers::contents_of(arguments[1]),
                                      count > 2 ? arguments[2] : "", put);
    return 0;
  } catch (const railbook::InputError& error) {
    std::fputs(error.what(), stderr);
    return 2;
  } catch (const std::bad_alloc&) {
    std::fputs("it needs more than 2 GiB of memory; of a MAT file, save it by -v7.3", stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 3;
  }
}
