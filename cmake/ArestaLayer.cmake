# SPDX-License-Identifier: Apache-2.0
# One folder of src/ is one shared library; its link list is the architecture.

add_library(aresta_flags INTERFACE)
target_compile_options(aresta_flags INTERFACE -Wall -Wextra -Wshadow -Wno-unused-parameter -ffp-contract=off)
if(ARESTA_SANITIZE)
  # GCC takes the sanitizers' own checks for uses of what may be uninitialised; the build without them keeps that warning.
  target_compile_options(aresta_flags INTERFACE -fsanitize=${ARESTA_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    -Wno-maybe-uninitialized)
  target_link_options(aresta_flags INTERFACE -fsanitize=${ARESTA_SANITIZE})
endif()
if(ARESTA_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "ARESTA_FUZZ needs clang: cmake --preset fuzz")
  endif()
  target_compile_options(aresta_flags INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(aresta_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# What a user of the program needs: the program and every module that it may load. Targets add themselves.
add_custom_target(aresta_program)

# aresta_layer(NAME [USES layers and libraries seen by users...] [PRIVATE libraries hidden inside...])
function(aresta_layer name)
  cmake_parse_arguments(ARG "" "" "USES;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(aresta_${name} SHARED ${sources})
  add_library(aresta::${name} ALIAS aresta_${name})
  set_target_properties(aresta_${name} PROPERTIES EXPORT_NAME ${name} SOVERSION ${PROJECT_VERSION_MAJOR}
    VERSION ${PROJECT_VERSION} INSTALL_RPATH "$ORIGIN" LINKER_LANGUAGE CXX)
  target_include_directories(aresta_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/aresta>)
  target_link_libraries(aresta_${name} PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATE} aresta_flags)
  set_property(GLOBAL APPEND PROPERTY aresta_public_libraries ${ARG_USES})
  install(TARGETS aresta_${name} EXPORT arestaTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/aresta FILES_MATCHING PATTERN "*.h")
endfunction()

# aresta_links_occt(TARGET libraries...): OCCT's libraries, hidden inside the target, its headers free of our warnings.
function(aresta_links_occt target)
  target_include_directories(${target} SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
  target_link_libraries(${target} PRIVATE ${ARGN})
endfunction()

# aresta_module(NAME SOURCES... PRIVATE libraries): loaded at run time, when used; see base/module.h.
function(aresta_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PRIVATE" ${ARGN})
  add_library(aresta_${name} MODULE ${ARG_SOURCES})
  set_target_properties(aresta_${name} PROPERTIES INSTALL_RPATH "$ORIGIN/..")
  target_link_libraries(aresta_${name} PRIVATE ${ARG_PRIVATE} aresta_flags)
  set_target_properties(aresta_${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/modules)
  add_dependencies(aresta_program aresta_${name})
  install(TARGETS aresta_${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/aresta)
endfunction()

# aresta_tests(NAME USES...): all *.cpp of this folder in one test program, found by CTest one by one. Paths to files are
# in tests/support/paths.h.
function(aresta_tests name)
  cmake_parse_arguments(ARG "" "" "USES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE ${ARG_USES} test_support aresta_flags GTest::gtest_main)
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 120)
endfunction()

# aresta_topics(): each tests/full/TOPIC.sh is test full.TOPIC, at about a hundredth of the size of `./test --full TOPIC`.
function(aresta_topics)
  file(GLOB scripts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/full/*.sh)
  foreach(script IN LISTS scripts)
    get_filename_component(topic ${script} NAME_WE)
    if(ARESTA_SANITIZE AND NOT topic STREQUAL wrong_input)
      continue() # under sanitizers the others take too long
    endif()
    add_test(NAME full.${topic} COMMAND sh ${PROJECT_SOURCE_DIR}/scripts/run-topic.sh ${topic} quick)
    set_tests_properties(full.${topic} PROPERTIES ENVIRONMENT BUILD=${PROJECT_BINARY_DIR} SKIP_RETURN_CODE 77 LABELS full)
  endforeach()
endfunction()
