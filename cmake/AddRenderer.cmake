include(${PROJECT_SOURCE_DIR}/renderer/sources.cmake)

# add_renderer(<name>)
#
# Defines <name>_core (static) and <name>_plugins (objects: a linker drops an archive member that
# nothing refers to by name, and with it the class it registers). The grader does not use this: it
# builds submissions itself, in the sandbox, from the same lists (grading/grader/build).
function(add_renderer name)
    set(renderer_dir ${PROJECT_SOURCE_DIR}/renderer)
    list(TRANSFORM NORI_CORE_SOURCES PREPEND ${renderer_dir}/src/ OUTPUT_VARIABLE core_files)
    set(plugin_files ${NORI_PLUGIN_SOURCES} ${NORI_REFERENCE_SOURCES})
    list(TRANSFORM plugin_files PREPEND ${renderer_dir}/src/)

    add_library(${name}_core STATIC ${core_files})
    add_library(${name}_plugins OBJECT ${plugin_files})
    foreach(target IN ITEMS ${name}_core ${name}_plugins)
        target_include_directories(${target} PUBLIC ${renderer_dir}/include)
        target_include_directories(${target} SYSTEM PUBLIC ${renderer_dir}/compat)
        target_compile_features(${target} PUBLIC cxx_std_17)
        # CMake leaves g++'s default unsaid, but clang-tidy reads the commands and has another one
        target_compile_options(${target} PRIVATE -std=gnu++17)
        target_link_libraries(${target} PUBLIC Eigen3::Eigen Threads::Threads
                              PRIVATE project_warnings OpenEXR::OpenEXR pugixml::pugixml
                              embree TBB::tbb PNG::PNG JPEG::JPEG)
    endforeach()
    target_link_libraries(${name}_plugins PUBLIC ${name}_core)
endfunction()
