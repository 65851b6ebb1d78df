# Sourced by build and run, with $here set: where the lab is kept and logs to.

cache=${XDG_CACHE_HOME:-$HOME/.cache}/eyebridge
logs=$cache
[ ! -e "$here/../../CMakeLists.txt" ] || logs=$(readlink -f "$here/../..")/build/lab

# Of everything that the kernel is made from, besides Debian's source.
kernel_hash() {
  (cd "$here" && sha256sum build change_source.py kernel.config register_size.c) | sha256sum | cut -c1-12
}

# File name of process 1, beside the kernel.
init_name() {
  printf 'guest_init-%s' "$(sha256sum <"$here/guest_init.c" | cut -c1-12)"
}

# Whether the kernel in this folder can keep all registers of this processor.
has_room() {
  [ "$("$1/register_size")" -le "$(cat "$1/register_room")" ]
}
