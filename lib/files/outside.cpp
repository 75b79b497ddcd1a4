#include <railbook/files/outside.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>

#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::files {

std::string quoted_name(const std::filesystem::path& name) {
  return "\"" + units::printable(name.string(), 1000) + "\"";
}

bool is_of_machine(int error) {
  for (const int e : {ENOSPC, EDQUOT, EIO, EFBIG, EMFILE, ENFILE, ENOMEM, EROFS, ESTALE})
    if (error == e) return true;
  return false;
}

void flush_standard_output() {
  errno = 0;
  std::fflush(stdout);
  if (std::ferror(stdout) == 0) return;
  const int error = errno == 0 ? EIO : errno;
  std::clearerr(stdout);
  const std::string text = "standard output: " + std::generic_category().message(error);
  if (error == EPIPE) throw ClosedPipe(text);
  throw OutsideError(text);
}

int status_of_exception(const std::string& program) {
  const auto say = [&](const char* what) {
    std::fprintf(stderr, "%s: %s\n", program.c_str(), units::printable(what, 2000).c_str());
  };
  try {
    throw;
  } catch (const InputError& error) {
    say(error.what());
    return 2;
  } catch (const ClosedPipe&) {
    return 3;
  } catch (const OutsideError& error) {
    say(error.what());
    return 3;
  } catch (const std::bad_alloc&) {
    say("not enough memory for this (a limit of the shell, ulimit -v, or of the machine)");
    return 3;
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::broken_pipe) say(error.what());
    return 3;
  } catch (const std::exception& error) {
    say(error.what());
    return 1;
  }
}

int finish_process(const std::string& program, int status) {
  if (status == 3) return status;  // already reported
  try {
    flush_standard_output();
  } catch (const OutsideError&) {
    return status_of_exception(program);
  }
  return status;
}

}  // namespace railbook::files
