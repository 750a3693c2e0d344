#!/bin/sh
# Usage: setup.sh FILE [PACKAGE...]. Installs the packages that the tests need and this machine lacks, or else these, by apt-get,
# as root or by sudo. Writes what is installed to FILE as make variables. Packages that can't be installed are named; their tests
# will be skipped.
file=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
CC=${CC:-cc}
CXX=${CXX:-c++}

compiles() { # compiler, suffix of the source, source, flags
    compiler=$1 suffix=$2 source=$3
    shift 3
    printf '%s\n' "$source" >"$work/probe.$suffix"
    $compiler "$work/probe.$suffix" -o "$work/probe" "$@" >/dev/null 2>&1
}
has() { # package: is it installed?
    case $1 in
    libcmocka-dev) compiles "$CC" c '#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <setjmp.h>
#include <cmocka.h>
int main(void) { return 0; }' -lcmocka ;;
    libgmp-dev) compiles "$CC" c '#include <gmp.h>
int main(void) { mpz_t z; mpz_init(z); return 0; }' -lgmp ;;
    g++) compiles "$CXX" cc 'int main() { return 0; }' ;;
    libcgal-dev) compiles "$CXX" cc '#include <CGAL/version.h>
int main() { return 0; }' -lmpfr -lgmp ;;
    libeigen3-dev) test -d /usr/include/eigen3 || test -d /usr/local/include/eigen3 ;;
    gcc-multilib) ! gcc -dumpmachine 2>/dev/null | grep -q '^x86_64' || compiles gcc c '#include <stdlib.h>
int main(void) { return 0; }' -m32 ;;
    g++-multilib) ! g++ -dumpmachine 2>/dev/null | grep -q '^x86_64' || compiles g++ cc '#include <vector>
int main() { return 0; }' -m32 ;;
    qemu-user) command -v qemu-aarch64 >/dev/null 2>&1 ;;
    binutils-aarch64-linux-gnu) command -v aarch64-linux-gnu-ld >/dev/null 2>&1 ;;
    binutils-s390x-linux-gnu) command -v s390x-linux-gnu-ld >/dev/null 2>&1 ;;
    binutils-riscv64-linux-gnu) command -v riscv64-linux-gnu-ld >/dev/null 2>&1 ;;
    libc6-dev-s390x-cross) test -e /usr/s390x-linux-gnu/include/stdio.h ;;
    libc6-dev-riscv64-cross) test -e /usr/riscv64-linux-gnu/include/stdio.h ;;
    libgcc-12-dev-s390x-cross) test -d /usr/lib/gcc-cross/s390x-linux-gnu ;;
    libgcc-12-dev-riscv64-cross) test -d /usr/lib/gcc-cross/riscv64-linux-gnu ;;
    libc6-dev-arm64-cross) test -e /usr/aarch64-linux-gnu/include/stdio.h ;;
    wasi-libc) test -e /usr/include/wasm32-wasi/stdio.h ;;
    lld) command -v wasm-ld >/dev/null 2>&1 ;;
    libclang-rt-dev-wasm32) ls /usr/lib/llvm-*/lib/clang/*/lib/wasi/*wasm32* >/dev/null 2>&1 ;;
    python3-vtk9) python3 -c 'import vtkmodules' >/dev/null 2>&1 || /usr/bin/python3 -c 'import vtkmodules' >/dev/null 2>&1 ;;
    python3-meshio) python3 -c 'import meshio' >/dev/null 2>&1 || /usr/bin/python3 -c 'import meshio' >/dev/null 2>&1 ;;
    python3-gemmi) python3 -c 'import gemmi' >/dev/null 2>&1 || /usr/bin/python3 -c 'import gemmi' >/dev/null 2>&1 ;;
    zlib1g-dev) compiles "$CC" c '#include <zlib.h>
int main(void) { return zlibVersion() == 0; }' -lz ;;
    voro++-dev) compiles "$CXX" cc '#include <voro++/voro++.hh>
int main() { return 0; }' -lvoro++ ;;
    nodejs) command -v node >/dev/null 2>&1 ;;
    libgcc-12-dev-arm64-cross) test -d /usr/lib/gcc-cross/aarch64-linux-gnu ;;
    llvm) command -v llvm-cov >/dev/null 2>&1 && command -v llvm-profdata >/dev/null 2>&1 ;;
    libclang-rt-14-dev) compiles clang c 'int main(void) { return 0; }' -fprofile-instr-generate ;;
    afl++) command -v afl-fuzz >/dev/null 2>&1 && command -v afl-clang-fast >/dev/null 2>&1 ;;
    mpich) command -v mpiexec >/dev/null 2>&1 ;;
    libmpich-dev) compiles "$(command -v mpicc.mpich || echo mpicc)" c '#include <mpi.h>
int main(void) { return MPI_SUCCESS; }' ;;
    *) command -v "$1" >/dev/null 2>&1 ;;
    esac
}

wanted="libcmocka-dev libgmp-dev g++ libcgal-dev libeigen3-dev gcc gcc-multilib g++-multilib tcc clang python3 mpich libmpich-dev
    qemu-user binutils-aarch64-linux-gnu libc6-dev-arm64-cross libgcc-12-dev-arm64-cross
    lld wasi-libc libclang-rt-dev-wasm32 nodejs python3-vtk9 python3-meshio python3-gemmi zlib1g-dev
    voro++-dev"
test $# -gt 0 && wanted=$*
missing() {
    for package in $wanted; do
        has "$package" || printf '%s ' "$package"
    done
}

lacking=$(missing)
if [ -n "$lacking" ] && command -v apt-get >/dev/null 2>&1; then
    if [ "$(id -u)" = 0 ]; then
        root=
    elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
        root=sudo
    else
        root=none
    fi
    if [ "$root" != none ]; then
        echo "Installing $lacking"
        $root apt-get update -q >"$work/log" 2>&1
        # One by one, so that a package that this release lacks does not prevent the others.
        for package in $lacking; do
            $root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "$package" \
                >>"$work/log" 2>&1 || echo "apt-get could not install $package"
        done
    fi
    lacking=$(missing)
fi
if [ -n "$lacking" ]; then
    echo "Without them some of the work is left out:  apt-get install $lacking"
fi

{
    has libcmocka-dev && echo HAVE_CMOCKA=1
    has libgmp-dev && echo HAVE_GMP=1
    has g++ && has libcgal-dev && has libeigen3-dev && echo HAVE_CGAL=1
    has g++ && has voro++-dev && echo HAVE_VORO=1
    compiles "$CC" c 'int main(void) { return 0; }' -fsanitize=address,undefined && "$work/probe" 2>/dev/null &&
        echo HAVE_SANITIZERS=1
    compiles "$CC" c 'int main(void) { return 0; }' -fsanitize=thread && "$work/probe" 2>/dev/null &&
        echo HAVE_THREAD_SANITIZER=1
} >"$file"
exit 0
