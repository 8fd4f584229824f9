// Errors. Whatever a user wrote or passed (a file, a key, an option) that cannot be used is an
// InputError, thrown while loading; the program prints it and exits with 2. A broken promise
// between our own functions is a std::logic_error. Nothing throws in the measurement loop.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace drydock {

/// What the user gave cannot be used; the message names the place, the value and what is allowed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

namespace internal {
[[noreturn]] void ThrowInputError(const std::string& message);
[[noreturn]] void ThrowLogicError(const std::string& message);
}  // namespace internal

/// Throws InputError with the formatted message unless `condition` holds.
template <typename... Args>
void RequireInput(bool condition, fmt::format_string<Args...> format, Args&&... args) {
  if (!condition) internal::ThrowInputError(fmt::format(format, std::forward<Args>(args)...));
}

/// Throws std::logic_error with the formatted message unless `condition` holds.
template <typename... Args>
void Check(bool condition, fmt::format_string<Args...> format, Args&&... args) {
  if (!condition) internal::ThrowLogicError(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace drydock
