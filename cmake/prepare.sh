# Sourced by ./run, ./test and nothing else: messages, packages, building.

say() { printf '\033[1m== %s\033[0m\n' "$*"; }
[ -t 1 ] || say() { printf '== %s\n' "$*"; }

# Ends the script: what failed, and what can be done about it.
die() {
  printf '%s: %s\n' "${0##*/}" "$1" >&2
  shift
  for line in "$@"; do printf '  %s\n' "$line" >&2; done
  exit 1
}

# Lines of cmake/packages.txt without comments: those above all sections, and of the sections given.
wanted_packages() {
  awk -v sections=" $* " 'BEGIN { wanted = 1 } { sub(/#.*/, "") }
    /^\[/ { wanted = index(sections, " " substr($1, 2, length($1) - 2) " "); next }
    NF && wanted { gsub(/[ \t]+/, ""); print }' cmake/packages.txt
}

is_installed() { dpkg-query -W -f '${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed; }
is_known() { [ -n "$(apt-cache madison "$1" 2>/dev/null)" ]; }

# Names of the packages that are to be installed. Of alternatives (A|B) the first that the release has.
missing_packages() {
  local alternatives package chosen
  wanted_packages "$@" | while read -r alternatives; do
    chosen=${alternatives%%|*}
    for package in ${alternatives//|/ }; do
      if is_installed "$package" || { [ "$package" != "$alternatives" ] && is_known "$package"; }; then
        chosen=$package
        break
      fi
    done
    is_installed "$chosen" || printf '%s\n' "$chosen"
  done
}

# install_packages [SECTION…]: installs what is missing; says nothing when nothing is.
install_packages() {
  command -v dpkg-query >/dev/null ||
    die "this is not a Debian system (no dpkg-query)" \
      "install what cmake/packages.txt lists, then: cmake --preset release && cmake --build --preset release"
  local missing log as_root=()
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null ||
      die "packages are missing, and there is no sudo to install them with" \
        "as root: apt-get install" $missing
    as_root=(sudo --)
  fi
  say "Installing" $missing
  log=$(mktemp)
  if ! "${as_root[@]}" apt-get update -qq >"$log" 2>&1 </dev/null; then
    tail -n 3 "$log" >&2
    say "the package lists could not be refreshed; trying with the old ones"
  fi
  missing=$(missing_packages "$@")  # a machine without package lists does not know which alternatives it has
  [ -n "$missing" ] || return 0
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    $missing >"$log" 2>&1 </dev/null || {
    tail -n 5 "$log" >&2
    die "apt-get could not install the packages above" \
      "no network, or older than Debian 12? The list is cmake/packages.txt."
  }
  rm -f "$log"
}

# A build folder remembers its path; one that was moved or copied here cannot be used.
forget_moved_build() {
  local cache=build/$1/CMakeCache.txt home
  [ -f "$cache" ] || return 0
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")
  [ "$home" = "$PWD" ] || rm -rf "build/$1"
}

# build_preset PRESET [cmake --build arguments…]
build_preset() {
  local preset=$1 log=build/$1.configure.log quiet=()
  shift
  mkdir -p build
  forget_moved_build "$preset"
  cmake --preset "$preset" >"$log" 2>&1 </dev/null || {
    tail -n 20 "$log" >&2
    die "cmake could not configure the preset '$preset' (all of it: $log)"
  }
  [ -t 1 ] || quiet=(-- --quiet)
  cmake --build --preset "$preset" "$@" "${quiet[@]}" </dev/null ||
    die "the preset '$preset' does not build; the compiler's messages are above"
}
