# Everything that is not ours. All of it is in Debian 12 (the list of packages is in `run`); nothing
# is downloaded.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED)          # renderer: linear algebra, as in Nori
find_package(embree 3.13 REQUIRED)         # renderer: ray tracing
find_package(TBB 2021 REQUIRED)            # renderer: threads
find_package(OpenEXR 3.1 REQUIRED)         # renderer: HDR images
find_package(PNG 1.6 REQUIRED)             # renderer: LDR images
find_package(JPEG REQUIRED)                # renderer: LDR textures
find_package(pugixml REQUIRED)             # renderer: scene files
find_package(CLI11 2.1 REQUIRED)           # command lines
find_package(fmt 9 REQUIRED)               # text
find_package(Boost 1.74 REQUIRED)          # statistics: distributions and quadrature
find_package(nlohmann_json 3.11 REQUIRED)  # results
find_package(ICU 72 REQUIRED COMPONENTS uc) # names: Unicode normalisation
find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto) # digests and seeds
pkg_check_modules(LibArchive REQUIRED IMPORTED_TARGET libarchive>=3.6) # submissions
pkg_check_modules(Seccomp REQUIRED IMPORTED_TARGET libseccomp>=2.5)    # sandbox
find_path(TOMLPLUSPLUS_INCLUDE_DIR toml++/toml.h REQUIRED)             # rubrics

if(NORI_GUI) # windows
    find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
    find_package(glfw3 3.3 REQUIRED)
    pkg_check_modules(ImGui REQUIRED IMPORTED_TARGET imgui>=1.86)
endif()

if(NORI_BUILD_TESTS)
    find_package(GTest 1.12 REQUIRED)
endif()
