# SPDX-License-Identifier: MIT
# Cross compiling for 64-bit Windows: Debian's mingw-w64, libraries in build/mingw-packages (get_packages.sh fills it), programs run by
# wine. Programs hold their libraries, so that they run from any folder.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_CROSSCOMPILING_EMULATOR env;WINEDEBUG=-all;/usr/lib/wine/wine64)

cmake_path(SET sinew_packages NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../build/mingw-packages)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${sinew_packages}/lib")
set(CMAKE_FIND_ROOT_PATH ${sinew_packages}/usr ${sinew_packages})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CXX_FLAGS_INIT "-isystem ${sinew_packages}/usr/include -isystem ${sinew_packages}/include")
