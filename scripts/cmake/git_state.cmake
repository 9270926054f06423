# SPDX-License-Identifier: BSD-3-Clause
# Writes build/<preset>/git_state.h with the commit and whether the tree was dirty, refreshed at every build and
# rewritten only when it changed.
add_custom_target(
  armature_git_state
  COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${CMAKE_SOURCE_DIR} -DOUTPUT=${CMAKE_BINARY_DIR}/generated/git_state.h
          -P ${CMAKE_SOURCE_DIR}/scripts/cmake/write_git_state.cmake
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/git_state.h
  COMMENT "Recording the git state")
