# drydock_library(NAME SOURCES a.cc… [PUBLIC lib…] [PRIVATE lib…])
#
# One library a folder: target drydock_NAME, alias drydock::NAME, installed and exported. Includes are
# written from the repository's root ("sensors_models/base/time.h"). A library without sources is
# header-only. The arrows of the house are the PUBLIC and PRIVATE lists: link downwards only.
function(drydock_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target drydock_${name})
  set(include_root $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/drydock>)
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    target_include_directories(${target} PUBLIC ${include_root})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:drydock_options>)
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${include_root})
    target_compile_features(${target} INTERFACE cxx_std_20)
    target_link_libraries(${target} INTERFACE ${ARG_PUBLIC})
  endif()
  add_library(drydock::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY DRYDOCK_LIBRARIES ${target})
endfunction()

# drydock_test(NAME SOURCES a.cc… LINKS lib… [LABELS label…])
#
# One GoogleTest executable; each of its tests is a CTest.
function(drydock_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gmock GTest::gtest_main drydock_options)
  # Without pretty values: of parameters that are structs these are bytes, addresses among them.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES
    PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
endfunction()

# drydock_benchmark(NAME SOURCES a.cc… LINKS lib…): one Google Benchmark executable, not run by CTest.
function(drydock_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} benchmark::benchmark benchmark::benchmark_main drydock_options)
endfunction()
