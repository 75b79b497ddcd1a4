// An environment variable of one test, which is put back when the test ends.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

class SetVariable {
 public:
  explicit SetVariable(const char* name) : name_(name) {
    if (const char* value = std::getenv(name); value != nullptr) before_ = value;
  }
  ~SetVariable() { to(before_ ? before_->c_str() : nullptr); }
  SetVariable(const SetVariable&) = delete;
  SetVariable& operator=(const SetVariable&) = delete;

  // nullptr: it is not there.
  void to(const char* value) const {
    if (value != nullptr)
      setenv(name_, value, 1);
    else
      unsetenv(name_);
  }

 private:
  const char* name_;
  std::optional<std::string> before_;
};
