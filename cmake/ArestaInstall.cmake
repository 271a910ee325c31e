# SPDX-License-Identifier: Apache-2.0
# `cmake --install` gives headers, libraries, modules, the program, and a package that find_package(aresta) finds.
include(CMakePackageConfigHelpers)
set(aresta_package ${CMAKE_INSTALL_LIBDIR}/cmake/aresta)
install(EXPORT arestaTargets NAMESPACE aresta:: DESTINATION ${aresta_package})
file(WRITE ${PROJECT_BINARY_DIR}/arestaConfig.cmake
  "include(CMakeFindDependencyMacro)\nfind_dependency(Threads)\ninclude(\${CMAKE_CURRENT_LIST_DIR}/arestaTargets.cmake)\n")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/arestaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/arestaConfig.cmake ${PROJECT_BINARY_DIR}/arestaConfigVersion.cmake DESTINATION ${aresta_package})
