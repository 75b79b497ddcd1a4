// What can fail outside the program, and how a program starts and ends so that it fails well.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace railbook::files {

// The world outside failed in mid-work: a full disk, a size limit, a read error, gnuplot. A program
// turns it into a one-line message and exit status 3. The text names the file and the operating
// system's reason.
class OutsideError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whether an error of the system is one of the machine (a full disk, no memory, no descriptors)
// rather than of the name that was given.
bool is_of_machine(int error);

// The reader of standard output went away; programs end with status 3 and say nothing.
class ClosedPipe : public OutsideError {
 public:
  using OutsideError::OutsideError;
};

// A name as it may be shown: in double quotes, control characters (a line break, a terminal's
// escapes) as \x1b.
std::string quoted_name(const std::filesystem::path& name);

// To be called first in main. What is staged is removed, a running child is ended, and then the
// program ends by the signal, on SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXCPU (one that the parent
// ignores stays ignored). A size limit becomes an error of the write. A standard stream that was
// closed by the parent is never given to another file.
void prepare_process();

// What was printed so far goes out; throws OutsideError (ClosedPipe) where it cannot.
void flush_standard_output();

// To be called last in main: the exit status, which becomes 3, with a message, when what was
// printed could not go out.
int finish_process(const std::string& program, int status);

// To be called in a catch block: the exit status of the exception being handled, its message
// printed. 2 for bad input, 3 for the world outside (a closed pipe says nothing; no more memory), 1
// for all others.
int status_of_exception(const std::string& program);

}  // namespace railbook::files
