# Sourced after machine.sh: the machine that another processor's build is compiled against and run in.

# What only this computer runs: checks of sources, sanitizers' tools, displays.
only_here='^(ccache|clang.*|libclang.*|lld|xvfb|xauth|libxcb-xtest0-dev|valgrind)$'
# What every Debian has, and its tests and compilers call.
system=base-files,base-passwd,bash,coreutils,dash,debianutils,diffutils,findutils,grep,gzip,hostname,libc-bin,login,mawk,ncurses-base,ncurses-bin,perl-base,procps,sed,tar,util-linux

# make_sysroot SUITE ARCHITECTURE TRIPLET: prints its folder; makes it (3 min) when it is missing or cmake/packages.txt has changed.
# Packages are unpacked and not configured: their scripts would need many minutes of an emulated processor.
make_sysroot() {
  local sysroot=$machines/$1-$2-build packages
  packages=$(wanted_packages test gui | grep -vE "$only_here" | sort -u | paste -sd,)
  (
    flock 9
    [ "$(cat "$sysroot/packages" 2>/dev/null)" != "$packages" ] || exit 0
    rm -rf "$sysroot" "$sysroot.new"
    mmdebstrap --quiet --mode=root --variant=extract --architectures="$2" --include="$system,$packages" \
      --hook-dir=/usr/share/mmdebstrap/hooks/merged-usr "$1" "$sysroot.new" >"$sysroot.log" 2>&1 ||
      { tail -n 20 "$sysroot.log" >&2; exit 1; }
    finish_sysroot "$sysroot.new" "$3"
    printf '%s\n' "$packages" >"$sysroot.new/packages"
    mv "$sysroot.new" "$sysroot"
  ) 9>"$sysroot.lock" || die "mmdebstrap could not unpack a Debian $1 for $2" "all of its messages: $sysroot.log"
  printf '%s\n' "$sysroot"
}

# finish_sysroot FOLDER TRIPLET: what the scripts of the packages would have done, as far as compilers and programs need it.
finish_sysroot() {
  local root=$1 lib=$1/usr/lib/$2 link target folder name
  # The linker of another system follows a link to /lib/... to its own.
  find "$root" -type l -lname '/*' -printf '%P\t%l\n' | while IFS=$'\t' read -r link target; do
    folder=$(dirname "/$link")
    ln -sfnr "$root$target" "$root$folder/$(basename "$link")"
  done
  cp "$root/usr/share/base-passwd/passwd.master" "$root/etc/passwd"
  cp "$root/usr/share/base-passwd/group.master" "$root/etc/group"
  for name in blas lapack; do ln -sfn "$name/lib$name.so.3" "$lib/lib$name.so.3"; done
  for name in awk:mawk mpirun:mpirun.openmpi cc:gcc c++:g++; do ln -sfn "${name#*:}" "$root/usr/bin/${name%%:*}"; done
  chroot "$root" /sbin/ldconfig
}
