# Sourced, with say and die of cmake/prepare.sh: fresh Debian machines of any release and processor, as chroots.
# A machine is a folder: its base is shared and never written to, what it changes lies in FOLDER/changes.

machines=${XDG_CACHE_HOME:-$HOME/.cache}/eyebridge/machines

# cannot_make_machines FOLDER: prints why no machine can be made in FOLDER; prints nothing when one can.
cannot_make_machines() {
  [ "$(id -u)" = 0 ] || { echo "root is needed for mounts"; return; }
  local try
  try=$(mktemp -d "$1/eyebridge-try.XXXXXX")
  mkdir "$try"/{base,changes,work,root}
  unshare --mount --pid --fork bash -c '
    mount -t overlay overlay -o "volatile,lowerdir=$1/base,upperdir=$1/changes,workdir=$1/work" "$1/root"
  ' try "$try" >/dev/null 2>&1 || echo "$1 cannot hold an overlay of its own (unshare --mount, mount -t overlay)"
  rm -rf --one-file-system "$try"
}

prepare_machines() {
  local lack
  lack=$(cannot_make_machines "${TMPDIR:-/tmp}")
  [ -z "$lack" ] || die "no machine can be made here: $lack" "as root, on a disk: sudo $0 ${1:-}"
  install_packages machines
  mkdir -p "$machines"
}

# For machines of another processor: qemu runs their programs.
prepare_emulation() {
  [ -w /proc/sys/fs/binfmt_misc/register ] || mount -t binfmt_misc none /proc/sys/fs/binfmt_misc ||
    die "the kernel has no binfmt_misc" "expected CONFIG_BINFMT_MISC: it starts programs for arm64 by qemu-user"
  [ -e /proc/sys/fs/binfmt_misc/qemu-aarch64 ] ||
    cat /usr/lib/binfmt.d/qemu-aarch64.conf >/proc/sys/fs/binfmt_misc/register
}

# machine_base SUITE ARCHITECTURE: prints the folder of its base; makes it (20 s; arm64: 2 min) when it is missing or a month old.
machine_base() {
  local base=$machines/$1-$2
  (
    flock 9
    if [ -d "$base" ] && [ -n "$(find "$base" -maxdepth 0 -mtime +30)" ]; then rm -rf "$base"; fi
    [ ! -d "$base" ] || exit 0
    rm -rf "$base.new"
    mmdebstrap --quiet --mode=root --variant=apt --architectures="$2" --include=ca-certificates \
      "$1" "$base.new" >"$base.log" 2>&1 ||
      { tail -n 20 "$base.log" >&2; exit 1; }
    mv "$base.new" "$base"
  ) 9>"$base.lock" || die "mmdebstrap could not make a Debian $1 for $2" "all of its messages: $base.log"
  printf '%s\n' "$base"
}

# new_machine FOLDER SUITE ARCHITECTURE: a machine with nothing but Debian's essential packages and apt.
new_machine() {
  local base
  base=$(machine_base "$2" "$3") || exit 1
  delete_machine "$1"
  mkdir -p "$1/changes/var/cache/apt/archives" "$1/work" "$1/root" "$machines/archives-$2-$3"
  # Packages that another machine has downloaded. Links, because apt locks its folder.
  find "$machines/archives-$2-$3" -name '*.deb' -exec ln -t "$1/changes/var/cache/apt/archives" {} +
  printf '%s\n' "$base" >"$1/base"
  printf '%s\n' "$machines/archives-$2-$3" >"$1/archives"
}
# What it has downloaded stays for the next one.
delete_machine() {
  [ ! -f "$1/archives" ] || find "$1/changes/var/cache/apt/archives" -maxdepth 1 -name '*.deb' -links 1 \
    -exec mv -t "$(cat "$1/archives")" {} + 2>/dev/null || true
  rm -rf --one-file-system "$1"
}

# clone_into FOLDER: a fresh clone of this tree, changes that are not committed included, at the same path as here. The same path
# lets ccache find what it knows.
clone_into() {
  local target=$1/changes$PWD folder=$PWD base
  base=$(cat "$1/base")
  rm -rf "$target"
  mkdir -p "$target"
  # These new folders hide the machine's own, so they get the same modes: apt needs a /tmp that everybody may write to.
  until [ "$folder" = / ]; do
    folder=$(dirname "$folder")
    [ ! -d "$base$folder" ] || chmod --reference="$base$folder" "$1/changes$folder"
  done
  git clone -q --no-hardlinks "$PWD" "$target"
  git ls-files -z -mo --exclude-standard | while IFS= read -r -d '' file; do
    [ -e "$file" ] || { rm -f "$target/$file"; continue; }
    cp -a --parents "$file" "$target"
  done
}

# on_machine FOLDER COMMAND...: runs it there as root in /, with a clean environment; its mounts and processes end with it. ccache, the
# folder shared/ beside the project, and what FOLDER/lent lists are lent.
on_machine() {
  local folder=$1
  shift
  local shared=
  [ ! -d "$PWD/../shared" ] || shared=$(readlink -f "$PWD/../shared")
  local ccache=${CCACHE_DIR:-$HOME/.cache/ccache}
  mkdir -p "$ccache"
  env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    unshare --mount --pid --fork --kill-child \
    bash -c '
      set -euo pipefail
      folder=$1 shared=$2 ccache=$3
      shift 3
      root=$folder/root
      # volatile: nothing waits for the disk, which is half of the time to install packages. The mark of the last mount has to go.
      rm -rf "$folder/work/work/incompat"
      mount -t overlay overlay \
        -o "volatile,lowerdir=$(cat "$folder/base"),upperdir=$folder/changes,workdir=$folder/work" "$root"
      mount -t proc proc "$root/proc"
      mount --rbind /sys "$root/sys"
      # Devices of its own: a stand-in for a board must not appear on this computer.
      mount -t tmpfs -o mode=755 dev "$root/dev"
      for device in null zero full random urandom tty fuse; do
        [ -e "/dev/$device" ] || continue
        touch "$root/dev/$device"
        mount --bind "/dev/$device" "$root/dev/$device"
      done
      mkdir "$root/dev/pts" "$root/dev/shm"
      mount -t devpts -o newinstance,ptmxmode=666 devpts "$root/dev/pts"
      mount -t tmpfs -o mode=1777 shm "$root/dev/shm"
      for link in ptmx=pts/ptmx fd=/proc/self/fd stdin=/proc/self/fd/0 stdout=/proc/self/fd/1 stderr=/proc/self/fd/2; do
        ln -s "${link#*=}" "$root/dev/${link%%=*}"
      done
      lend() { mkdir -p "$root$2"; mount --bind "$1" "$root$2"; }
      lend "$ccache" /root/.cache/ccache
      [ -z "$shared" ] || lend "$shared" "$shared"
      [ ! -f "$folder/lent" ] || while read -r path; do lend "$path" "$path"; done <"$folder/lent"
      cp --dereference /etc/resolv.conf "$root/etc/resolv.conf"
      exec chroot "$root" "$@"
    ' on_machine "$folder" "$shared" "$ccache" "$@" </dev/null
}

# lend_lab FOLDER: a copy of the guest kernels that are built here, for those that need one and do not build it.
lend_lab() {
  local cache=${XDG_CACHE_HOME:-$HOME/.cache}/eyebridge
  mkdir -p "$1/changes/root/.cache/eyebridge"
  cp -a "$cache"/lab-* "$1/changes/root/.cache/eyebridge/"
}
