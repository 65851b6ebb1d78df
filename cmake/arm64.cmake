# Toolchain of the preset arm64: Debian's cross compiler, and the libraries of a Debian for arm64 that tests/machines/arm64 unpacks.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)

set(EYEBRIDGE_SYSROOT "$ENV{EYEBRIDGE_SYSROOT}")
if(NOT EYEBRIDGE_SYSROOT)
  set(cache "$ENV{XDG_CACHE_HOME}")
  if(NOT cache)
    set(cache "$ENV{HOME}/.cache")
  endif()
  file(STRINGS /etc/os-release suite REGEX "^VERSION_CODENAME=")
  string(REPLACE "VERSION_CODENAME=" "" suite "${suite}")
  set(EYEBRIDGE_SYSROOT "${cache}/eyebridge/machines/${suite}-arm64-build")
endif()
if(NOT EXISTS "${EYEBRIDGE_SYSROOT}/usr/include/stdio.h")
  message(FATAL_ERROR "No libraries for arm64 in ${EYEBRIDGE_SYSROOT}.\nMake them: tests/machines/arm64 sysroot")
endif()
set(CMAKE_SYSROOT "${EYEBRIDGE_SYSROOT}")
set(multiarch aarch64-linux-gnu)
set(CMAKE_LIBRARY_ARCHITECTURE ${multiarch})

set(CMAKE_C_COMPILER ${multiarch}-gcc)
set(CMAKE_CXX_COMPILER ${multiarch}-g++)

# Programs that run while building are this computer's; everything else is arm64's.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${CMAKE_SYSROOT}")
set(ENV{PKG_CONFIG_LIBDIR} "${CMAKE_SYSROOT}/usr/lib/${multiarch}/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig")

# Qt compiles its descriptions of objects with programs of its own.
set(QT_HOST_PATH /usr)
set(QT_HOST_PATH_CMAKE_DIR "/usr/lib/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu/cmake")

# Python's module is for the interpreter of the sysroot, which the configure step cannot ask.
file(GLOB python_headers "${CMAKE_SYSROOT}/usr/include/python3.*")
set(Python_INCLUDE_DIR "${python_headers}")
string(REGEX REPLACE ".*python3\\.([0-9]+)$" "\\1" python_minor "${python_headers}")
set(PYTHON_MODULE_EXTENSION ".cpython-3${python_minor}-${multiarch}.so")

# The LCD's font is drawn by a program of ours while building.
find_program(EYEBRIDGE_QEMU qemu-aarch64-static REQUIRED)  # qemu-user-static
set(CMAKE_CROSSCOMPILING_EMULATOR "${EYEBRIDGE_QEMU};-L;${CMAKE_SYSROOT}")

# mpicc would answer for this computer.
set(mpi "${CMAKE_SYSROOT}/usr/lib/${multiarch}/openmpi")
set(MPI_C_COMPILER NOTFOUND)
set(MPI_C_HEADER_DIR "${mpi}/include")
set(MPI_C_LIB_NAMES mpi)
set(MPI_mpi_LIBRARY "${mpi}/lib/libmpi.so")
