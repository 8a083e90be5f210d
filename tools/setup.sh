# Sourced by the other tools: installs what is missing and builds. Needs no question answered.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Everything that building, running and testing needs, as Debian and Ubuntu name it.
packages=(
  g++ cmake ninja-build pkg-config
  libassimp-dev libcli11-dev libegl-dev libeigen3-dev libfmt-dev libfontconfig-dev libfreetype-dev
  libgl-dev libglfw3-dev libhdf5-dev libhwy-dev libjpeg-dev libmuparser-dev libode-dev libpng-dev libtbb-dev
  libyaml-cpp-dev libminizip-dev nlohmann-json3-dev
  libgtest-dev libgmock-dev python3 python3-numpy
  fonts-dejavu-core libegl-mesa0 libgl1-mesa-dri
)

# What only Python's module needs.
python_packages=(pybind11-dev python3-dev)

# What only the report's page needs, to bundle it. A node and npm from elsewhere will do.
report_packages=()
command -v npm > /dev/null || report_packages+=(nodejs npm)

# What only tests need, each skipped without it: Python's to read what the program writes, and a
# screen without a monitor for the window.
test_packages=(
  python3-h5py python3-jsonschema python3-matplotlib python3-pandas python3-pil python3-pytest python3-yaml
  xvfb
)
# What only those of tools/test --all need: clang's sanitizers, Doxygen for the pages of the API, what
# makes and measures videos, and a browser to open the page, of which Ubuntu has no package that runs
# by itself.
thorough_packages=(clang-14 doxygen libclang-rt-14-dev ffmpeg mypy python3-venv)
if grep -qs '^ID=debian' /etc/os-release; then thorough_packages+=(chromium); fi

say() { printf '%s\n' "$*" >&2; }

# Prints the comment at the top of the tool that sources this, which is its help, and ends the tool.
print_help() { sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 0; }

# install_missing PACKAGE...: by the system's package manager, after saying which.
install_missing() {
  if ! command -v dpkg-query > /dev/null; then
    say "plimsoll: this is no Debian or Ubuntu; going on in the hope that these are installed: $*"
    return
  fi
  local missing=() package installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2> /dev/null || true)
  for package in "$@"; do
    [[ $'\n'$installed$'\n' == *$'\ninstalled '$package$'\n'* ]] || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return
  say "plimsoll: installing ${missing[*]}"
  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo > /dev/null; then
      say "plimsoll: run this as root, or install them first: apt-get install ${missing[*]}"
      exit 2
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends \
    -o Dpkg::Use-Pty=0 install "${missing[@]}" > "${TMPDIR:-/tmp}/plimsoll-apt.$$" 2>&1 || {
    cat "${TMPDIR:-/tmp}/plimsoll-apt.$$" >&2
    exit 2
  }
  rm -f "${TMPDIR:-/tmp}/plimsoll-apt.$$"
}

# build PRESET FOLDER TARGET [KNOWN [-DOPTION=ON|OFF]]: configures where that has not been done, or was
# done before what the target KNOWN (TARGET) needs was installed, or with the option otherwise, and
# builds what has changed. Two at once in one folder wait for each other.
build() {
  local preset=$1 folder=$root/$2 target=$3 known=${4:-$3} option=${5:-}
  local set=${option#-D}
  mkdir -p "$folder"
  exec 9> "$folder/.lock"
  flock 9
  if [[ ! -f $folder/build.ninja ]] || ! ninja -C "$folder" -t query "$known" &> /dev/null ||
    { [[ -n $set ]] && ! grep -q "^${set%=*}:[A-Z]*=${set#*=}$" "$folder/CMakeCache.txt"; }; then
    say "plimsoll: configuring ($preset)"
    (cd "$root" && cmake --preset "$preset" $option > "$folder/configure.log" 2>&1) || {
      cat "$folder/configure.log" >&2
      exit 2
    }
  fi
  if ! ninja -C "$folder" -n "$target" | tail -n 1 | grep -q 'no work to do'; then
    say "plimsoll: building ($preset)"
    # One compiler a core: more of them wait for memory and take longer.
    ninja -C "$folder" -j "$(nproc)" "$target" >&2 || exit 2
  fi
  exec 9>&-
}
