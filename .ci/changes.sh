# SPDX-License-Identifier: MIT
# Of .ci/run: what changed since the last landing, which parts that asks for, and what each step took.

say() { printf '\033[1m==>\033[0m %s\n' "$*" >&2; }

# The changed paths, or "everything": with --all, without a history, or when what decides about all files has changed. A landing is some
# hours of commits, so the base is the newest ancestor that is more than eight hours older.
decides_about_all='^(CMakeLists\.txt|CMakePresets\.json|packages\.txt|run|\.ci/.*)$'
ci_changes=everything
ci_base=${SINEW_CI_BASE:-} ci_all=
if [ "${1:-}" = --all ]; then
  ci_all=1
else
  head_time=$(git log -1 --format=%ct)
  [ -n "$ci_base" ] || ci_base=$(git rev-list -1 --before="@$((head_time - 8 * 3600))" HEAD)
  if [ -n "$ci_base" ]; then
    ci_changes=$(git diff --name-only --no-renames "$ci_base" HEAD)
    ! grep -qE "$decides_about_all" <<< "$ci_changes" || ci_changes=everything
  fi
fi
ci_commit=$(git rev-parse HEAD)

# when PART PATTERN: whether the part is taken.
ci_parts=() ci_taken=()
when() {
  ci_parts+=("$1")
  if [ "$ci_changes" = everything ] || grep -qE "$2" <<< "$ci_changes"; then ci_taken+=("$1"); fi
}

# The part whose turn it is, by the commit's hash.
part_in_turn() { echo "${ci_parts[$((16#${ci_commit:0:6} % ${#ci_parts[@]}))]}"; }
takes() { [[ " ${ci_taken[*]:-} $(part_in_turn) " == *" $1 "* ]]; }

# Other builds of the same code. Each commit takes one of them, by its hash.
ci_builds=("thread sanitizer" "64-bit ARM" "64-bit Windows" "Python package" "Slurm and GNU parallel")
ci_build=${ci_builds[$((16#${ci_commit:6:6} % ${#ci_builds[@]}))]}
builds() { [ -n "$ci_all" ] || [ "$ci_build" = "$1" ]; }

# The headers that changed since the base, and a quarter of all in turn.
headers_in_turn() {
  [ -z "$ci_base" ] || git diff --name-only --no-renames "$ci_base" HEAD -- '*.h'
  git ls-files '*.h' | awk -v turn=$((16#${ci_commit:12:6} % 4)) 'NR % 4 == turn'
}

what_was_left_out() {
  local part
  for part in "${ci_builds[@]}"; do builds "$part" || echo "left out: $part (its turn comes; ./run check-all takes all)"; done
  [ "$ci_all" ] || ! takes headers || echo "left out: three quarters of the headers that did not change (their turn comes)"
  if [ "$ci_changes" = everything ]; then
    echo "every part was taken: that was asked for, there is no older commit, or what decides about all files has changed"
    echo "left out: mutants, of which a few say nothing about so many changes (./run mutate)"
    [ "$ci_all" ] || echo "left out: programs under the sanitizers beyond the first, which the commit's hash chose"
    return
  fi
  echo "changes since ${ci_base:0:12}: $(wc -l <<< "$ci_changes") files; in turn: $(part_in_turn)"
  for part in "${ci_parts[@]}"; do
    takes "$part" || echo "left out: $part (no changed path asks for it, see .ci/run)"
  done
}

# The test programs of a folder, by the CMakeLists.txt of the folder of tests that has its name.
programs_of_folder() {
  local room=${1#runtime/}
  room=${room#tests/}
  case "$room" in
    importer/tool/bake* | importer/geometry_cache*) room=geometry_cache ;;
    c_assets* | c_geometry*) room=c ;;
  esac
  room=tests/${room%%/*}/CMakeLists.txt
  [ ! -e "$room" ] || sed -nE 's/^ *sinew_test\(([a-z_-]+).*/\1/p' "$room"
}

# The folders of changed files, and of the files that include a changed header.
changed_folders() {
  local headers
  if [ "$ci_changes" = everything ]; then
    git ls-files runtime importer viewer tests
  else
    headers=$(grep -E '\.h$' <<< "$ci_changes" || true)
    echo "$ci_changes"
    [ -z "$headers" ] || git grep -lF -f <(echo "$headers") -- '*.h' '*.cpp' || true
  fi | sed -n 's|/[^/]*$||p' | sort -u
}

# Names of at most $1 programs: those that follow, then those of changed folders, then others; the latter two in an order that the
# commit's hash gives, so that each has its turn. Of what tests/not_sanitized.txt leaves out whole, none.
sanitized_programs() {
  local most=$1 folder changed all shuffle
  shift
  shuffle() { while read -r name; do echo "$(printf '%s%s' "$ci_commit" "$name" | sha256sum | cut -c1-16) $name"; done | sort | cut -d' ' -f2; }
  changed=$(for folder in $(changed_folders); do programs_of_folder "$folder"; done | sort -u)
  all=$(sed -nE 's/^ *sinew_test\(([a-z_-]+).*/\1/p' $(git ls-files 'tests/*CMakeLists.txt') | sort -u)
  { printf '%s\n' "$@"; shuffle <<< "$changed"; shuffle <<< "$all" | head -n 2; } | awk 'NF && !seen[$0]++' |
    grep -vxF -f <(sed -nE 's|^([a-z-]+)/$|\1|p' tests/not_sanitized.txt; echo architecture) |
    if [ "$ci_all" ]; then cat; else head -n "$most"; fi | paste -sd ,
}

# step NAME COMMAND...: runs it, and keeps its seconds.
: > build/ci-steps.txt
step() {
  local TIMEFORMAT="$1"$'\t%R\t%U\t%S'
  say "step: $1"
  shift
  { time "$@" 2>&3; } 3>&2 2>> build/ci-steps.txt
}
table_of_steps() {
  awk -F '\t' 'BEGIN { print "| step | wall, minutes | CPU, minutes |\n|---|---|---|" }
    { printf "| %s | %.1f | %.1f |\n", $1, $2 / 60, ($3 + $4) / 60; wall += $2; cpu += $3 + $4 }
    END { printf "| all | %.1f | %.1f |\n", wall / 60, cpu / 60 }' build/ci-steps.txt
}

# Tools that tests use where they are there, too large for everybody's machine, and the compilers of the other steps. Here a test that
# is skipped is a failure.
install_tools() {
  local as_root=() packages=(chromium python3-clang python3-numpy python3-yaml abigail-tools groff zsh fish)
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  command -v npm > /dev/null || packages+=(npm)  # a Node.js from elsewhere brings its own, and Debian's does not go beside it
  ! builds "Slurm and GNU parallel" || packages+=(parallel slurm-wlm munge)
  "${as_root[@]}" apt-get update -qq -o Acquire::Retries=5
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends -o Acquire::Retries=5 "${packages[@]}" > /dev/null
  npm install --prefix build/npm --no-audit --no-fund --silent --fetch-retries=5 gltf-validator@2.0.0-dev.3.10 three@0.170.0 \
    @pixiv/three-vrm@3.4.5 @pixiv/three-vrm-animation@3.4.5
  ./run --preset asan install
  ! builds "64-bit ARM" || ./run --preset aarch64 install
  ! builds "64-bit Windows" || ./run --preset mingw install
}

# Nothing that is compiled needs the tools: they are loaded and unpacked beside it.
build_beside_tools() {
  local tools
  install_tools > build/tools.log 2>&1 &
  tools=$!
  ./run build
  wait $tools || { cat build/tools.log >&2; exit 1; }
}
