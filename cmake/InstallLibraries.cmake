# `cmake --install build/release --component warptest --prefix DIR`: the libraries of warptest with
# their headers, for `find_package(norigrade)` in another project.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/norigrade)
install(TARGETS statistics catalog battery EXPORT norigrade COMPONENT warptest
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT warptest)
install(EXPORT norigrade NAMESPACE norigrade:: FILE norigrade-targets.cmake
        DESTINATION ${package_dir} COMPONENT warptest)
foreach(folder IN ITEMS statistics catalog battery)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/warptest/${folder} COMPONENT warptest
            DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/norigrade
            FILES_MATCHING PATTERN "*.h" PATTERN battery_run.h EXCLUDE)
endforeach()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/norigrade-config.cmake.in
    ${PROJECT_BINARY_DIR}/norigrade-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/norigrade-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/norigrade-config.cmake
              ${PROJECT_BINARY_DIR}/norigrade-config-version.cmake
        DESTINATION ${package_dir} COMPONENT warptest)
