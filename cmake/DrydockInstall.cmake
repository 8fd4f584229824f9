# What `cmake --install` puts where, and the CMake package `find_package(Drydock)` finds. The installed tree
# can be moved: the program finds its data and MuJoCo beside itself.
include(CMakePackageConfigHelpers)

set(DRYDOCK_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/Drydock)
set(DRYDOCK_INSTALL_MUJOCODIR ${CMAKE_INSTALL_LIBDIR}/drydock/mujoco)

# Headers keep their place in the house: #include "sensors_models/base/time.h" outside as inside.
get_property(libraries GLOBAL PROPERTY DRYDOCK_LIBRARIES)
foreach(library IN LISTS libraries)
  get_target_property(folder ${library} SOURCE_DIR)
  file(RELATIVE_PATH place ${PROJECT_SOURCE_DIR} ${folder})
  if(place MATCHES "^tests/")
    list(REMOVE_ITEM libraries ${library})
    continue()
  endif()
  file(GLOB headers CONFIGURE_DEPENDS ${folder}/*.h)
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/drydock/${place})
endforeach()
install(TARGETS ${libraries} EXPORT DrydockTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT DrydockTargets NAMESPACE drydock:: DESTINATION ${DRYDOCK_INSTALL_CMAKEDIR})

install(TARGETS drydock RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
file(GLOB scenario_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/scenarios/*.yaml)
install(FILES ${scenario_files} DESTINATION ${CMAKE_INSTALL_DATADIR}/drydock/scenarios)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenarios/suites DESTINATION ${CMAKE_INSTALL_DATADIR}/drydock/scenarios)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/sensors_models/measurement/rigs
  DESTINATION ${CMAKE_INSTALL_DATADIR}/drydock/sensors_models/measurement)
install(FILES ${PROJECT_SOURCE_DIR}/estimator/svin2/vocabulary/brisk.vocabulary
  DESTINATION ${CMAKE_INSTALL_DATADIR}/drydock/estimator/svin2/vocabulary)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# MuJoCo comes along, with its licences, whether or not the machine has one of its own.
if(DRYDOCK_SIM)
  file(REAL_PATH ${MuJoCo_LIBRARY} mujoco_library)
  cmake_path(GET mujoco_library FILENAME mujoco_file)
  install(FILES ${mujoco_library} DESTINATION ${DRYDOCK_INSTALL_MUJOCODIR}/lib)
  install(CODE "file(CREATE_LINK ${mujoco_file}
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${DRYDOCK_INSTALL_MUJOCODIR}/lib/libmujoco.so\" SYMBOLIC)")
  install(DIRECTORY ${MuJoCo_INCLUDE_DIR}/mujoco DESTINATION ${DRYDOCK_INSTALL_MUJOCODIR}/include)
  file(GLOB mujoco_licences ${MuJoCo_INCLUDE_DIR}/../LICENSE*)
  install(FILES ${mujoco_licences} DESTINATION ${DRYDOCK_INSTALL_MUJOCODIR})
  file(RELATIVE_PATH to_mujoco /${CMAKE_INSTALL_BINDIR} /${DRYDOCK_INSTALL_MUJOCODIR}/lib)
  set_target_properties(drydock PROPERTIES INSTALL_RPATH $ORIGIN/${to_mujoco})
endif()

configure_package_config_file(cmake/DrydockConfig.cmake.in ${PROJECT_BINARY_DIR}/DrydockConfig.cmake
  INSTALL_DESTINATION ${DRYDOCK_INSTALL_CMAKEDIR} PATH_VARS DRYDOCK_INSTALL_MUJOCODIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/DrydockConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/DrydockConfig.cmake ${PROJECT_BINARY_DIR}/DrydockConfigVersion.cmake
  cmake/FindMuJoCo.cmake DESTINATION ${DRYDOCK_INSTALL_CMAKEDIR})
