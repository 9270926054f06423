# SPDX-License-Identifier: BSD-3-Clause
# A floor of the house: one folder, one static library armature_NAME.
#
#   armature_floor(NAME BELOW FLOOR... LIBRARIES LIBRARY... SOURCES FILE...)
#
# Headers are included as "floor/name.h". The only include directory of a floor is build/<preset>/floors/NAME, which
# holds nothing but a link to its folder; so a file sees its own floor and those that it is linked with, all of them
# below, and an include that runs up does not compile.
function(armature_floor name)
  cmake_parse_arguments(PARSE_ARGV 1 floor "" "" "BELOW;LIBRARIES;SOURCES")
  set(target armature_${name})
  set(root ${CMAKE_BINARY_DIR}/floors/${name})
  file(MAKE_DIRECTORY ${root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/${name} SYMBOLIC)

  add_library(${target} STATIC ${floor_SOURCES})
  set_property(GLOBAL APPEND PROPERTY ARMATURE_FLOORS ${target})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${root}>)
  target_include_directories(
    ${target} SYSTEM PUBLIC ${OpenCV_INCLUDE_DIRS} ${CERES_INCLUDE_DIRS}
    PRIVATE ${FLANN_INCLUDE_DIR} ${PCL_INCLUDE_DIR})
  list(TRANSFORM floor_BELOW PREPEND armature_)
  target_link_libraries(
    ${target}
    PUBLIC ${floor_BELOW} Eigen3::Eigen fmt::fmt
    PRIVATE armature_flags ${floor_LIBRARIES})
  armature_instrument(${target})
  # The files of a floor are compiled together, so the names in their anonymous namespaces differ. Who changes a file
  # again and again configures with -DARMATURE_UNITY=OFF.
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ARMATURE_UNITY} UNITY_BUILD_BATCH_SIZE 0)
endfunction()

# What our code is compiled with, and its tests are not.
function(armature_instrument target)
  if(ARMATURE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)  # leads the fuzzer
  endif()
  if(ARMATURE_COVERAGE)
    # Our files alone: to count in Eigen's and the standard library's headers, too, costs a third of the compile time, and
    # most of what a process does when it ends.
    file(REAL_PATH ${CMAKE_SOURCE_DIR} root)
    string(REGEX REPLACE "([][+.*()^$?{}|\\])" "\\\\\\1" root ${root})
    target_compile_options(${target} PRIVATE --coverage "-fprofile-filter-files=^${root}/")
  endif()
  if(ARMATURE_ODR)
    target_compile_options(${target} PRIVATE -flto -ffat-lto-objects)  # for the target armature_odr alone
    set_property(GLOBAL APPEND PROPERTY ARMATURE_ODR_ARCHIVES $<TARGET_FILE:${target}>)
  endif()
endfunction()

# Reads all our libraries as one and makes nothing of it: one name with two definitions is an error.
function(armature_add_odr_check)
  get_property(archives GLOBAL PROPERTY ARMATURE_ODR_ARCHIVES)
  add_custom_command(
    OUTPUT ${CMAKE_BINARY_DIR}/odr.o
    COMMAND ${CMAKE_CXX_COMPILER} -flto=auto -O0 -Werror=odr -Werror=lto-type-mismatch -r -flinker-output=rel -nostdlib -o
            odr.o -Wl,--whole-archive ${archives}
    DEPENDS ${archives}
    COMMENT "Looking for one name with two definitions"
    VERBATIM)
  add_custom_target(armature_odr DEPENDS ${CMAKE_BINARY_DIR}/odr.o)
endfunction()
