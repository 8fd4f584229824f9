# Finds MuJoCo 3 under MUJOCO_ROOT (or the system's paths) and offers mujoco::mujoco.
find_path(MuJoCo_INCLUDE_DIR mujoco/mujoco.h HINTS "${MUJOCO_ROOT}/include")
find_library(MuJoCo_LIBRARY mujoco HINTS "${MUJOCO_ROOT}/lib")
include(FindPackageHandleStandardArgs)
if(MuJoCo_LIBRARY)
  # The header's number has changed its meaning over the years; the library's file name has not.
  file(REAL_PATH "${MuJoCo_LIBRARY}" real_library)
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+$" MuJoCo_VERSION "${real_library}")
endif()
find_package_handle_standard_args(MuJoCo REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR VERSION_VAR MuJoCo_VERSION
  REASON_FAILURE_MESSAGE "run tools/setup, or pass -DMUJOCO_ROOT=DIR, or build without it: --preset estimator-only")
if(MuJoCo_FOUND AND NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco SHARED IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES
    IMPORTED_LOCATION "${MuJoCo_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${MuJoCo_INCLUDE_DIR}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${MuJoCo_INCLUDE_DIR}")
endif()
