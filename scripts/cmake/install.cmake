# SPDX-License-Identifier: BSD-3-Clause
# What `cmake --install` puts where. Nothing in it names the prefix, which may be moved afterwards.
#   bin/armature, share/armature   the program and its data, as cli/data_folders.h looks for them
#   include/armature, lib          the libraries: armature::armature, armature::eval, armature::bench, ...
#   lib/cmake/armature             find_package(armature)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(data ${CMAKE_INSTALL_DATADIR}/armature)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/armature)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/armature)

install(TARGETS armature_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS armature_video LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/armature)
install(DIRECTORY configs DESTINATION ${data})
install(DIRECTORY datasets/scenes DESTINATION ${data}/datasets)
install(FILES results/paper_object_errors.csv DESTINATION ${data}/results)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(CODE [[
  execute_process(COMMAND $<TARGET_FILE:armature_program> completion bash OUTPUT_VARIABLE script RESULT_VARIABLE failed
                  ERROR_QUIET)
  if(NOT failed)
    file(WRITE $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/bash-completion/completions/armature "${script}")
  endif()
]])

# armature_NAME is armature::NAME in other projects. The flags have to be there because the others name them.
get_property(floors GLOBAL PROPERTY ARMATURE_FLOORS)
set(libraries armature armature_flags ${floors})
foreach(library ${libraries})
  string(REGEX REPLACE "^armature_" "" name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS ${libraries} EXPORT armatureTargets ARCHIVE INCLUDES DESTINATION ${headers})
install(EXPORT armatureTargets NAMESPACE armature:: DESTINATION ${package})

# As code includes them: "stage/name.h", "eval/name.h".
set(only_headers FILES_MATCHING PATTERN "*.h" REGEX "/src/app$|/datasets/(scenes|generated[^.]*)$" EXCLUDE)
install(DIRECTORY src/ DESTINATION ${headers} ${only_headers})
install(DIRECTORY bench datasets eval DESTINATION ${headers} ${only_headers})

configure_package_config_file(scripts/cmake/armatureConfig.cmake.in ${CMAKE_BINARY_DIR}/armatureConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/armatureConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/armatureConfig.cmake ${CMAKE_BINARY_DIR}/armatureConfigVersion.cmake
        DESTINATION ${package})
