# SPDX-License-Identifier: Apache-2.0
# `cmake --install` gives headers, libraries, modules, the program, and a package that find_package(aresta) finds.
include(CMakePackageConfigHelpers)
set(aresta_package ${CMAKE_INSTALL_LIBDIR}/cmake/aresta)
install(EXPORT arestaTargets NAMESPACE aresta:: DESTINATION ${aresta_package})

# The packages of the libraries that the layers' own users see; what is hidden inside a layer is none of their business.
set(package_of_Threads::Threads Threads)
set(package_of_Eigen3::Eigen Eigen3)
set(package_of_TBB::tbb TBB)
set(package_of_fmt::fmt fmt)
set(package_of_nlohmann_json::nlohmann_json nlohmann_json)
get_property(libraries GLOBAL PROPERTY aresta_public_libraries)
list(REMOVE_DUPLICATES libraries)
set(aresta_dependencies "")
foreach(library IN LISTS libraries)
  if(DEFINED package_of_${library})
    string(APPEND aresta_dependencies "find_dependency(${package_of_${library}})\n")
  elseif(NOT library MATCHES "^aresta")
    message(FATAL_ERROR "a layer USES ${library}: name its package in cmake/ArestaInstall.cmake, or hide it (PRIVATE)")
  endif()
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/arestaConfig.cmake
  "include(CMakeFindDependencyMacro)\n${aresta_dependencies}include(\${CMAKE_CURRENT_LIST_DIR}/arestaTargets.cmake)\n")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/arestaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/arestaConfig.cmake ${PROJECT_BINARY_DIR}/arestaConfigVersion.cmake DESTINATION ${aresta_package})
