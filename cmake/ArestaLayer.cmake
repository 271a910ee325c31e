# SPDX-License-Identifier: Apache-2.0
# One folder of src/ is one shared library; its link list is the architecture.

add_library(aresta_flags INTERFACE)
target_compile_options(aresta_flags INTERFACE -Wall -Wextra -Wshadow -Wno-unused-parameter -ffp-contract=off)
if(ARESTA_SANITIZE)
  target_compile_options(aresta_flags INTERFACE -fsanitize=${ARESTA_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(aresta_flags INTERFACE -fsanitize=${ARESTA_SANITIZE})
endif()
install(TARGETS aresta_flags EXPORT arestaTargets)

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
  install(TARGETS aresta_${name} EXPORT arestaTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/aresta FILES_MATCHING PATTERN "*.h")
endfunction()

# aresta_module(NAME SOURCES... PRIVATE libraries): loaded at run time, when used; see base/module.h.
function(aresta_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PRIVATE" ${ARGN})
  add_library(aresta_${name} MODULE ${ARG_SOURCES})
  set_target_properties(aresta_${name} PROPERTIES INSTALL_RPATH "$ORIGIN/..")
  target_link_libraries(aresta_${name} PRIVATE ${ARG_PRIVATE} aresta_flags)
  set_target_properties(aresta_${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/modules)
  install(TARGETS aresta_${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/aresta)
endfunction()

# aresta_tests(NAME USES...): all *.cpp of this folder in one test program, found by CTest one by one.
function(aresta_tests name)
  cmake_parse_arguments(ARG "" "" "USES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE ${ARG_USES} aresta_flags GTest::gtest_main)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(test_${name} PRIVATE ARESTA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 120)
endfunction()
