#include "sim/world/mujoco_errors.h"

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

namespace drydock::sim {
namespace {

void ThrowError(const char* message) {
  throw std::runtime_error(fmt::format("MuJoCo: {}", message));
}

void PrintWarning(const char* message) { fmt::print(stderr, "warning: MuJoCo: {}\n", message); }

}  // namespace

void InstallMujocoErrorHandlers() {
  mju_user_error = ThrowError;
  mju_user_warning = PrintWarning;
}

}  // namespace drydock::sim
