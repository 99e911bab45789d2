# Third-party parts (DESIGN, "Parts chosen"). Headers are SYSTEM, so that their warnings are not ours.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(embree 3 REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(Boost REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(meshoptimizer REQUIRED)

add_library(alcove_glm INTERFACE)
target_compile_definitions(alcove_glm INTERFACE GLM_FORCE_XYZW_ONLY GLM_ENABLE_EXPERIMENTAL GLM_FORCE_CTOR_INIT)

add_library(alcove_xxhash INTERFACE)
target_link_libraries(alcove_xxhash INTERFACE xxhash)

add_library(alcove_lz4 INTERFACE)
target_link_libraries(alcove_lz4 INTERFACE lz4)

# Debian's embree exports a bare target name.
add_library(alcove_embree INTERFACE)
target_link_libraries(alcove_embree INTERFACE embree)

# Debian's CMake package of OpenImageIO insists on its command line tools being installed as well.
find_library(ALCOVE_OIIO_LIBRARY OpenImageIO REQUIRED)
find_library(ALCOVE_OIIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
find_path(ALCOVE_IMATH_INCLUDE Imath/half.h REQUIRED)
add_library(alcove_oiio INTERFACE)
target_link_libraries(alcove_oiio INTERFACE ${ALCOVE_OIIO_LIBRARY} ${ALCOVE_OIIO_UTIL_LIBRARY})
target_include_directories(alcove_oiio SYSTEM INTERFACE ${ALCOVE_IMATH_INCLUDE} ${ALCOVE_IMATH_INCLUDE}/Imath)

find_package(NLopt REQUIRED)
add_library(alcove_nlopt INTERFACE)
target_link_libraries(alcove_nlopt INTERFACE NLopt::nlopt)
