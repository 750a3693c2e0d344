#!/bin/sh
# The benchmark: builds ParaDT and its peers and runs them in turn on the same points. Writes the raw lines to
# build/bench/runs.json, makes build/bench/table.md from them and prints it. Run the script from the top folder, as
# `make bench` does.
#
#   BENCH=full|quick          everything (an hour or more), or small sets of a few families (a few minutes)
#   BENCH_SECTIONS="..."      any of families sizes scans dimensions weighted hulls threads speedup small predicates use;
#                             all by default
#   BENCH_SCANS="..."         files of points in space for the section scans; none by default
#   BENCH_METHODS="..."       methods of ParaDT; auto incode dewall by default
#   BENCH_PEERS="..."         peers; by default all that can be built
#   BENCH_LIMIT=SECONDS       stop a run after this time; 120 by default, 20 for quick
#   BENCH_CLOCK=wall|cpu      compare programs of one thread by this time; cpu is for a machine that others use, too
#   BENCH_KEEP=1              keep the raw lines of earlier runs and append to them
# Lists of words are split on purpose where they are used:
# shellcheck disable=SC2046,SC2086
BENCH=${BENCH:-full}
METHODS=${BENCH_METHODS:-auto incode dewall}
LIMIT=${BENCH_LIMIT:-$([ "$BENCH" = full ] && echo 120 || echo 20)}
B=build/bench
RUNS=$B/runs.json
POINTS=$B/points.bin
mkdir -p "$B" || exit 1
# A later run must not find the points of this one.
trap 'rm -f "$POINTS"' EXIT
trap 'exit 130' INT TERM

# --- the peers --------------------------------------------------------------------------------------------------------
# Prints a line for each peer: name, a header that is found if the peer is installed, Debian packages.
peers() {
    cat <<'END'
cgal CGAL/Delaunay_triangulation_3.h libcgal-dev
cgal-regular CGAL/Regular_triangulation_3.h libcgal-dev
cgal-dd Eigen/Core libeigen3-dev libcgal-dev
cgal-tbb tbb/global_control.h libtbb-dev libcgal-dev
tetgen tetgen.h libtet1.5-dev
qhull libqhull_r/qhull_ra.h libqhull-dev
qhull-hull libqhull_r/qhull_ra.h libqhull-dev
hxt gmshc.h libgmsh-dev
voro voro++/voro++.hh voro++-dev
END
}

has_header() { echo "#include <$1>" | ${CXX:-c++} -std=c++17 -isystem /usr/include/eigen3 -E -x c++ - >/dev/null 2>&1; }

# Prints the lines of the peers that BENCH_PEERS names.
wanted_peers() {
    peers | while read -r peer header packages; do
        case " ${BENCH_PEERS-$peer} " in *" $peer "*) echo "$peer $header $packages" ;; esac
    done
}

# Prints the packages of peers that are not installed.
lacking() {
    wanted_peers | while read -r peer header packages; do
        has_header "$header" || printf '%s\n' $packages
    done | sort -u | tr '\n' ' '
}

install_peers() {
    packages=$(lacking)
    [ -n "$packages" ] || return
    root=
    if [ "$(id -u)" != 0 ]; then
        root="sudo -n"
        $root true 2>/dev/null || root=none
    fi
    if [ "$root" != none ] && command -v apt-get >/dev/null 2>&1; then
        echo "Installing $packages"
        $root apt-get update -q >"$B/install.log" 2>&1
        for package in $packages; do
            $root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "$package" \
                >>"$B/install.log" 2>&1 || echo "apt-get could not install $package (see $B/install.log)"
        done
        packages=$(lacking)
    fi
    [ -z "$packages" ] || echo "Some peers are left out. To install them:  apt-get install $packages"
}

build() {
    wanted=$(wanted_peers | cut -d' ' -f1 | grep -v '^voro$' | tr '\n' ' ') # Voro++ is a program of use.sh
    echo "Building ParaDT, $wanted"
    make --no-print-directory -k -j"$(getconf _NPROCESSORS_ONLN)" -f tests/bench/bench.mk programs PEERS="$wanted" \
        >"$B/build.log" 2>&1 && return
    grep -E 'rror|undefined' "$B/build.log" | head -10
    echo "Programs that could not be built are left out (see $B/build.log)."
}

# --- one run ----------------------------------------------------------------------------------------------------------
# A program is written NAME[/kREGIONS][/jJOBS][/nn][/xCOPIES]. NAME: a peer, or a method of ParaDT, with -native if it
# is compiled for this processor; nn: without neighbours; x: concurrent copies, each with a part of the points.

# available PROGRAM: succeeds if the program is built and, if it is a peer, wanted.
available() {
    name=${1%%/*}
    case " $(peers | cut -d' ' -f1 | tr '\n' ' ') " in
    *" $name "*) case " $wanted " in *" $name "*) ;; *) return 1 ;; esac ;;
    esac
    [ -x "$(command_of "$1" | cut -d' ' -f1)" ]
}

# command_of PROGRAM: prints the command and its arguments.
command_of() {
    command=
    arguments="--name $1"
    for part in $(echo "$1" | tr / ' '); do
        case $command:$part in
        :*-native) command=$B/paradt-native arguments="$arguments --method ${part%-native}" ;;
        :*)
            if [ -x "$B/$part" ]; then
                command=$B/$part
            else
                command=$B/paradt arguments="$arguments --method $part"
            fi
            ;;
        *:k[0-9]*) arguments="$arguments --regions ${part#k}" ;;
        *:j[0-9]*) arguments="$arguments --jobs ${part#j}" ;;
        *:nn) arguments="$arguments --no-neighbors" ;;
        *:x[0-9]*) arguments="$arguments --copies ${part#x}" ;;
        esac
    done
    echo "$command $arguments"
}

# run PROGRAM: runs the program on the points and adds its line to the raw lines. Leaves its milliseconds in $spent
# (empty: it failed) and its exit status in $status.
run() {
    line=$(timeout -k 5 "$LIMIT" $(command_of "$1") --calls "$calls" $hash "$POINTS" 2>"$B/errors.log")
    status=$?
    case $status in
    0) ;;
    124 | 137) line="{\"name\":\"$1\",\"failed\":\">$LIMIT s\"}" ;;
    *)
        line="{\"name\":\"$1\",\"failed\":\"failed\"}"
        echo "    $1: status $status: $(head -c 200 "$B/errors.log")"
        ;;
    esac
    case_fields="\"section\":\"$section\",\"kind\":\"$kind\",\"points\":$n,\"dim\":$d,\"reference\":\"$reference\""
    echo "{$case_fields,\"round\":$round,${line#\{}" >>"$RUNS"
    spent=$(echo "$line" | awk -F '"seconds":' 'NF > 1 { printf "%d", 1000 * $2 }')
}

# --- one case ---------------------------------------------------------------------------------------------------------
# measure SECTION KIND N D WEIGHTED CALLS REFERENCE PROGRAMS...
# KIND: a kind of points, or a file; N of a file is read from it.
# Programs run in turn. Since the last run of the reference, other programs may have taken no longer than the reference
# itself; otherwise the reference runs again. So the two times of a ratio are near each other. There are three rounds or
# more. A slow or failing program is not repeated, and a program that was stopped is not tried on larger sets.
SLOW=20000 # milliseconds of a run: a program that takes longer is slow
LONG=90    # seconds of a case, after which three rounds suffice; threads get more, because small differences matter
stopped=
measure() {
    section=$1 kind=$2 n=$3 d=$4 weighted=$5 calls=$6 reference=$7
    shift 7
    available "$reference" || { echo "$section: $kind $n left out, for want of $reference"; return; }
    rm -f "$POINTS"
    if [ -f "$kind" ]; then
        "$B/points" "$kind" "$d" "$weighted" "$POINTS" || return
        n=$(od -An -t u8 -j 8 -N 8 "$POINTS" | tr -d ' ')
        kind=$(basename "$kind")
    else
        "$B/points" "gen:$kind:$((n * calls)):1" "$d" "$weighted" "$POINTS" || return
    fi
    echo "$section: $kind $n, d = $d"
    if [ "$n" -gt 200000 ]; then rounds=3; elif [ "$n" -gt 20000 ]; then rounds=5; else rounds=9; fi
    long=$LONG
    if [ "$section" = threads ]; then rounds=9 long=$((4 * LONG)); fi
    if [ "$section" = speedup ]; then rounds=25 long=$((2 * LONG)); fi
    [ "$BENCH" = full ] || rounds=3
    slow=
    round=0
    began=$(date +%s)
    while [ "$round" -lt "$rounds" ]; do
        round=$((round + 1))
        if [ "$round" = 1 ]; then hash=--hash; else hash=; fi
        since=
        for program in "$@"; do
            key=$section:$kind:$d:$program
            available "$program" || continue
            case " $slow $stopped " in *" $key "*) continue ;; esac
            if [ -z "$since" ] || [ "$since" -gt "$reference_spent" ]; then
                run "$reference"
                [ -n "$spent" ] || return
                reference_spent=$spent
                since=0
            fi
            run "$program"
            since=$((since + ${spent:-$SLOW}))
            [ "${spent:-$SLOW}" -lt "$SLOW" ] || slow="$slow $key"
            case $status in 124 | 137) stopped="$stopped $key" ;; esac
        done
        if [ "$round" -ge 3 ] && [ $(($(date +%s) - began)) -gt "$long" ]; then return; fi
    done
}

# --- the cases --------------------------------------------------------------------------------------------------------

SECTIONS=${BENCH_SECTIONS:-families sizes scans dimensions weighted hulls threads speedup small predicates use}
wants() { case " $SECTIONS " in *" $1 "*) ;; *) false ;; esac; }

# Prints the first word of a list: the method that represents ParaDT where one is enough.
first() { echo "$1"; }

measure_all() {
    main=$(first $METHODS)
    if [ "$BENCH" = full ]; then
        kinds="uniform gauss sphere clusters lattice plane helix plummer" sizes="10000 100000 1000000" large=1000000
    else
        kinds="uniform sphere clusters lattice" sizes="10000 100000" large=100000
    fi
    if wants families; then
        for kind in $kinds; do
            for n in $sizes; do
                if [ "$BENCH" = full ] || [ "$n" -le 10000 ]; then qhull=qhull; else qhull=; fi
                measure families "$kind" "$n" 3 0 1 cgal $METHODS "$main-native" "$main/nn" tetgen hxt $qhull
            done
        done
    fi
    if wants sizes; then # sets of a special size or degeneracy
        measure sizes sphere $((large / 5)) 3 0 1 cgal $METHODS tetgen hxt
        measure sizes clusters $((large / 2)) 3 0 1 cgal $METHODS tetgen hxt
        if [ "$BENCH" = full ]; then measure sizes lattice 262144 3 0 1 cgal $METHODS tetgen hxt; fi
        measure sizes cospherical 10000 3 0 1 cgal $METHODS tetgen hxt
        measure sizes duplicates "$large" 3 0 1 cgal $METHODS tetgen hxt
        if [ "$BENCH" = full ]; then measure sizes uniform 5000000 3 0 1 cgal "$main" hxt; fi
    fi
    if wants scans; then
        for file in ${BENCH_SCANS:-}; do
            measure scans "$file" 0 3 0 1 cgal $METHODS tetgen hxt
        done
    fi
    if wants dimensions; then
        for n in $sizes; do
            measure dimensions uniform "$n" 2 0 1 cgal-dd $METHODS qhull
        done
        measure dimensions uniform 10000 4 0 1 qhull $METHODS cgal-dd
        measure dimensions uniform 3000 5 0 1 qhull $METHODS cgal-dd
        measure dimensions uniform 1000 6 0 1 qhull $METHODS cgal-dd
    fi
    if wants weighted; then
        for n in $sizes; do
            measure weighted uniform "$n" 3 1 1 cgal-regular $METHODS
        done
    fi
    if wants hulls; then # the hull alone; hull/k2/j2 has two threads
        measure hulls ball "$large" 2 0 1 qhull-hull hull hull/k2/j2
        measure hulls ball "$large" 3 0 1 qhull-hull hull hull/k2/j2
        measure hulls uniform "$large" 3 0 1 qhull-hull hull hull/k2/j2
        measure hulls sphere $((large / 10)) 3 0 1 qhull-hull hull hull/k2/j2
        measure hulls ball $((large / 10)) 4 0 1 qhull-hull hull hull/k2/j2
        measure hulls ball $((large / 10)) 5 0 1 qhull-hull hull hull/k2/j2
    fi
    if wants threads; then
        for kind in uniform clusters; do
            measure threads "$kind" "$large" 3 0 1 cgal $(for method in $METHODS; do
                echo "$method $method/k2/j2 $method/k8/j1 $method/k8/j2"
            done) "$main/x2" cgal-tbb/j1 cgal-tbb/j2 hxt/j1 hxt/j2
        done
    fi
    if wants speedup; then # one thread and two in turn; a peer in between would take much longer
        for kind in uniform clusters; do
            measure speedup "$kind" "$large" 3 0 1 "$main" "$main/k2/j2" "$main/x2"
        done
    fi
    if wants small; then
        measure small uniform 100 3 0 5000 cgal $METHODS
        measure small uniform 1000 3 0 500 cgal $METHODS
    fi
}

conditions() {
    processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -1)
    cache=$(sed -n 's/^cache size[^:]*: *//p' /proc/cpuinfo | head -1)
    memory=$(awk '/^MemTotal/ { printf "%.0f GiB", $2 / 1048576 }' /proc/meminfo)
    compilers="$(${CC:-cc} --version | head -1), $(${CXX:-c++} --version | head -1)"
    packages=$(for package in libcgal-dev libtet1.5-dev libqhull-dev libgmsh-dev libtbb-dev voro++-dev; do
        dpkg-query -W -f '${Package} ${Version}, ' "$package" 2>/dev/null
    done)
    echo "- $(date -u '+%Y-%m-%d %H:%M') UTC, BENCH=$BENCH, seed 1, at most $LIMIT s a run, clock: ${BENCH_CLOCK:-wall}"
    echo "- $processor, $(getconf _NPROCESSORS_ONLN) processors, cache $cache, memory $memory, $(uname -sr)"
    echo "- $compilers; -O3; -march=native in the columns named native only"
    echo "- ${packages%, }"
    echo "- load average at the start: $load"
}

# What is done with a triangulation: tables of their own
measure_use() {
    if [ "$BENCH" = full ]; then use_rounds=5 use_large=1000000 use_four=10000; else use_rounds=3 use_large=100000 use_four=1000; fi
    for size in "$use_large 3" "$use_large 2" "$use_four 4"; do
        # shellcheck disable=SC2086 # two words
        USE_ROUNDS=$use_rounds sh tests/bench/use.sh $size
        echo
    done >"$B/use.md"
}

load=$(cut -d' ' -f1-3 /proc/loadavg)
install_peers
build
[ -n "$BENCH_KEEP" ] || : >"$RUNS"
measure_all
if wants use; then measure_use; fi
if wants predicates && [ -x "$B/predicates" ]; then "$B/predicates" >"$B/predicates.txt"; fi
{
    conditions
    awk -v clock="${BENCH_CLOCK:-wall}" -f tests/bench/table.awk "$RUNS"
    if wants use && [ -s "$B/use.md" ]; then
        printf '\n## use\n\n'
        cat "$B/use.md"
    fi
    if [ -s "$B/predicates.txt" ]; then
        printf '\n## predicates\n\n```\n'
        cat "$B/predicates.txt"
        printf '```\n'
    fi
} >"$B/table.md"
cat "$B/table.md"
echo "Written: $B/table.md; the raw lines: $RUNS"
