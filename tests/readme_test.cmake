# SPDX-License-Identifier: BSD-3-Clause
# The README's C++ is tests/find_package/example.cc, from its first include on.
cmake_minimum_required(VERSION 3.25)
file(READ ${CMAKE_CURRENT_LIST_DIR}/find_package/example.cc example)
file(READ ${CMAKE_CURRENT_LIST_DIR}/../README.md readme)
string(FIND "${example}" "#include" start)
string(SUBSTRING "${example}" ${start} -1 code)
string(FIND "${readme}" "```cpp\n${code}```\n" found)
if(found EQUAL -1)
  message(FATAL_ERROR "README.md does not show tests/find_package/example.cc as it is")
endif()
