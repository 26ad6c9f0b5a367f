# Installs the C++ library for find_package(lacquer CONFIG). The program and the data it shares with
# the library are installed where they are made.

# All of the public C++ API under one name.
add_library(lacquer_api INTERFACE)
add_library(lacquer::lacquer ALIAS lacquer_api)
target_link_libraries(lacquer_api INTERFACE lacquer_core lacquer_material lacquer_shading)
set_target_properties(lacquer_api PROPERTIES EXPORT_NAME lacquer)

foreach(part IN ITEMS core material shading)
    set_target_properties(lacquer_${part} PROPERTIES EXPORT_NAME ${part})
endforeach()

install(TARGETS lacquer_api lacquer_core lacquer_material lacquer_shading
        EXPORT lacquerTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY host/include/lacquer DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# What the headers above include with "core/...": a quoted include looks beside its includer first.
install(FILES host/core/error.h host/core/model.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lacquer/core)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/lacquer)
set(share ${CMAKE_INSTALL_DATADIR}/lacquer)
install(EXPORT lacquerTargets NAMESPACE lacquer:: DESTINATION ${package})
configure_package_config_file(host/lacquerConfig.cmake.in ${CMAKE_BINARY_DIR}/lacquerConfig.cmake
                              INSTALL_DESTINATION ${package} PATH_VARS share)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/lacquerConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/lacquerConfig.cmake
              ${CMAKE_BINARY_DIR}/lacquerConfigVersion.cmake DESTINATION ${package})
