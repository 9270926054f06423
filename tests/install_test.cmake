# SPDX-License-Identifier: BSD-3-Clause
# Installs BUILD, moves the prefix elsewhere, runs the program from another folder with the data beside it, and
# builds and runs the example of tests/find_package against it with the compiler CXX.
cmake_minimum_required(VERSION 3.25)

# What the command prints, on either stream; ends the test when it fails or does not match the expression.
function(expect expression)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${elsewhere} RESULT_VARIABLE status OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT status EQUAL 0 OR NOT output MATCHES "${expression}")
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nstatus ${status}, expected '${expression}' in:\n${output}")
  endif()
endfunction()

set(folder ${BUILD}/tests/install_test)
set(prefix ${folder}/moved)
set(elsewhere ${folder}/elsewhere)
set(data ${prefix}/share/armature)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${elsewhere})

expect("bin/armature" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/prefix)
file(RENAME ${folder}/prefix ${prefix})
foreach(file datasets/scenes/seq1.yaml results/paper_object_errors.csv)
  if(NOT EXISTS ${data}/${file})
    message(FATAL_ERROR "${data}/${file} is not installed")
  endif()
endforeach()

expect("armature 0" ${prefix}/bin/armature --version)
expect("sample" ${prefix}/bin/armature generate --only sample --without-cad --frames 6 --out ${folder})
# A preset that the source tree does not have tells whose data the program takes.
file(COPY_FILE ${data}/configs/presets/fast.yaml ${data}/configs/presets/installed.yaml)
expect("Results:" ${prefix}/bin/armature run ${folder}/sample --preset installed --out ${elsewhere}/run)

expect("Generating done" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/find_package -B ${folder}/build
       -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX}
       -DCMAKE_EXE_LINKER_FLAGS=-fno-lto)  # what scripts/test.sh builds would be compiled once more
expect("Built target" ${CMAKE_COMMAND} --build ${folder}/build)
foreach(object chair0 table0)
  expect("${object} at \\([-0-9., ]+\\) m, [0-9.]+ m high" ${folder}/build/example ${data}/configs/categories
         ${folder}/sample)
endforeach()
file(REMOVE_RECURSE ${folder})
