# For scripts that use MPI, which read this file: mpicc, mpicxx and mpiexec are MPICH's where it is installed. Packages that need
# Open MPI at run time may have taken these names over, without its headers.
if command -v mpicc.mpich >/dev/null 2>&1; then
    mkdir -p "$PWD/build/tests/mpich"
    for program in mpicc mpicxx mpiexec; do
        rm -f "$PWD/build/tests/mpich/$program"
        printf '#!/bin/sh\nexec %s.mpich "$@"\n' $program >"$PWD/build/tests/mpich/$program"
        chmod +x "$PWD/build/tests/mpich/$program"
    done
    PATH=$PWD/build/tests/mpich:$PATH
    export PATH
fi
