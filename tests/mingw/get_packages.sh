#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fills build/mingw-packages for the preset mingw: headers that suit any machine are copied out of installed Debian packages, libraries
# are built from Debian's sources.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$here/../../build/mingw-packages"
cd "$here/../../build/mingw-packages"
# Filled once, and again where the list of packages has changed.
list=$(cat "$here"/get_packages.sh "$here"/packages/CMakeLists.txt "$here"/toolchain.cmake | sha256sum)
[ "$(cat done 2> /dev/null)" != "$list" ] || exit 0
rm -f done

headers=(libglm-dev libexpected-dev libeigen3-dev libxxhash-dev nlohmann-json3-dev rapidjson-dev libtinygltf-dev libstb-dev libcli11-dev)
for package in "${headers[@]}"; do
  dpkg -L "$package" | grep -E '^/usr/(include|share/(cmake|eigen3)|lib/.*/cmake)/' | grep -v -- '-none.cmake$' |
    while read -r file; do [ -d "$file" ] || cp --parents "$file" .; done
done

# A list of sources of its own, from where the machine has its packages: the machine's lists stay as they are.
sources=(highway libzstd zlib openmesh meshoptimizer fmtlib)
mkdir -p lists/partial cache/archives/partial src
. /etc/os-release
site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' "Release: $VERSION_CODENAME" 'Component: main' | head -n 1)
echo "deb-src $site $VERSION_CODENAME main" > sources.list
apt=(apt-get -qq -o Acquire::Retries=5 -o Dir::Etc::SourceList="$PWD/sources.list" -o Dir::Etc::SourceParts=-
  -o Dir::State::Lists="$PWD/lists" -o Dir::Cache="$PWD/cache" -o APT::Sandbox::User="$(id -un)")
"${apt[@]}" update
(cd src && "${apt[@]}" source --download-only "${sources[@]}")
for source in "${sources[@]}"; do
  rm -rf "src/$source"
  dpkg-source --no-check -x src/"$source"_*.dsc "src/$source" > /dev/null
done

launcher=$(command -v ccache || true)
cmake -S "$here/packages" -B build -G Ninja -DCMAKE_TOOLCHAIN_FILE="$here/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" -DCMAKE_C_COMPILER_LAUNCHER="$launcher" -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
  -DCMAKE_C_FLAGS_RELEASE=-O1 -DSOURCES="$PWD/src" -DCMAKE_INSTALL_PREFIX="$PWD" > /dev/null
cmake --build build --target install > build/log || { cat build/log >&2; exit 1; }
echo "$list" > done
