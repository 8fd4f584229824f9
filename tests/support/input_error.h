// What bad input is told.
#pragma once

#include <string>

#include "sensors_models/base/check.h"

namespace drydock::testing {

/// What `act` complains of in its InputError; empty where it does not.
template <typename Act>
std::string InputErrorOf(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace drydock::testing
