// MuJoCo's errors as ours.
#pragma once

namespace drydock::sim {

/// Makes MuJoCo throw std::runtime_error where it would print and end the process, and keeps its
/// warnings off the working folder (it writes MUJOCO_LOG.TXT otherwise). MuJoCo's handlers are
/// process-wide, so this is called by everything that is about to use MuJoCo; calling it again
/// changes nothing.
void InstallMujocoErrorHandlers();

}  // namespace drydock::sim
