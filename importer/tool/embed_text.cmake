# SPDX-License-Identifier: MIT
# Makes a C++ string literal of a text file: cmake -DIN=... -DOUT=... -P embed_text.cmake
file(READ "${IN}" text)
file(WRITE "${OUT}" "R\"sinew(${text})sinew\"\n")
