#!/bin/sh
# The benchmark: builds ParaDT and its peers, runs them by turns on the same points, and writes build/bench/table.md,
# also to standard output, from the raw lines in build/bench/runs.json. Run it from the top folder, as `make bench` does.
#
#   BENCH=full|quick          everything (an hour or more), or small sets of a few families (a few minutes)
#   BENCH_SECTIONS="..."      of families sizes scans dimensions weighted threads speedup small predicates; all by default
#   BENCH_SCANS="..."         files of points in space for the section scans; none by default
#   BENCH_METHODS="..."       methods of ParaDT; auto incode dewall by default
#   BENCH_PEERS="..."         peers; all that can be built by default
#   BENCH_LIMIT=SECONDS       after which a run is stopped; 120 by default, 20 for quick
#   BENCH_CLOCK=wall|cpu      what programs of one thread are compared by; cpu when others use the machine
#   BENCH_KEEP=1              append to the raw lines of earlier runs
# Lists of words are split where they are used, on purpose:
# shellcheck disable=SC2046,SC2086
BENCH=${BENCH:-full}
METHODS=${BENCH_METHODS:-auto incode dewall}
LIMIT=${BENCH_LIMIT:-$([ "$BENCH" = full ] && echo 120 || echo 20)}
B=build/bench
RUNS=$B/runs.json
POINTS=$B/points.bin
mkdir -p "$B" || exit 1
# Points of an earlier case must not stand for a case whose points could not be made.
trap 'rm -f "$POINTS"' EXIT
trap 'exit 130' INT TERM

# --- the peers --------------------------------------------------------------------------------------------------------
# peer, header that shows it is there, Debian packages
peers() {
    cat <<'END'
cgal CGAL/Delaunay_triangulation_3.h libcgal-dev
cgal-regular CGAL/Regular_triangulation_3.h libcgal-dev
cgal-dd Eigen/Core libeigen3-dev libcgal-dev
cgal-tbb tbb/global_control.h libtbb-dev libcgal-dev
tetgen tetgen.h libtet1.5-dev
qhull libqhull_r/qhull_ra.h libqhull-dev
hxt gmshc.h libgmsh-dev
END
}

has_header() { echo "#include <$1>" | ${CXX:-c++} -std=c++17 -isystem /usr/include/eigen3 -E -x c++ - >/dev/null 2>&1; }

wanted_peers() {
    peers | while read -r peer header packages; do
        case " ${BENCH_PEERS-$peer} " in *" $peer "*) echo "$peer $header $packages" ;; esac
    done
}

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
    [ -z "$packages" ] || echo "Peers that need these are left out; to have them:  apt-get install $packages"
}

build() {
    wanted=$(wanted_peers | cut -d' ' -f1 | tr '\n' ' ')
    echo "Building ParaDT, $wanted"
    make --no-print-directory -k -j"$(getconf _NPROCESSORS_ONLN)" -f tests/bench/bench.mk programs PEERS="$wanted" \
        >"$B/build.log" 2>&1 && return
    grep -E 'rror|undefined' "$B/build.log" | head -10
    echo "What was not built is left out (see $B/build.log)."
}

# --- one run ----------------------------------------------------------------------------------------------------------
# A program is written NAME[/kREGIONS][/jJOBS][/nn][/xCOPIES], NAME a peer, or a method of ParaDT, with -native where it
# is compiled for this processor; nn: without neighbours; so many copies at once have a part of the points each.

# Whether it was built, and is no peer that was not asked for.
available() {
    name=${1%%/*}
    case " $(peers | cut -d' ' -f1 | tr '\n' ' ') " in
    *" $name "*) case " $wanted " in *" $name "*) ;; *) return 1 ;; esac ;;
    esac
    [ -x "$(command_of "$1" | cut -d' ' -f1)" ]
}

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

# Runs the program on the points, adds its line to the raw ones, and leaves its milliseconds in $spent (empty: it
# failed) and its exit status in $status.
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
# KIND may be a file, whose number of points is found out.
# Programs run by turns, each right after the reference or after others that together took no longer than it does, so
# that the two times of a ratio are near each other. Rounds are repeated three times or more. A slow or failing program
# is not repeated; one that was stopped is not tried on larger sets.
SLOW=20000 # milliseconds of one run
LONG=90    # seconds of a case: three rounds have to do then, but for threads, of which the differences count
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

SECTIONS=${BENCH_SECTIONS:-families sizes scans dimensions weighted threads speedup small predicates}
wants() { case " $SECTIONS " in *" $1 "*) ;; *) false ;; esac; }

# The first word of a list, for the method that stands for ParaDT where one is enough.
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
    if wants sizes; then # sets of special sizes or degeneracy
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
    if wants threads; then
        for kind in uniform clusters; do
            measure threads "$kind" "$large" 3 0 1 cgal $(for method in $METHODS; do
                echo "$method $method/k2/j2 $method/k8/j1 $method/k8/j2"
            done) "$main/x2" cgal-tbb/j1 cgal-tbb/j2 hxt/j1 hxt/j2
        done
    fi
    if wants speedup; then # one thread and two by turns, without a peer between, which takes much longer
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
    packages=$(for package in libcgal-dev libtet1.5-dev libqhull-dev libgmsh-dev libtbb-dev; do
        dpkg-query -W -f '${Package} ${Version}, ' "$package" 2>/dev/null
    done)
    echo "- $(date -u '+%Y-%m-%d %H:%M') UTC, BENCH=$BENCH, seed 1, at most $LIMIT s a run, clock: ${BENCH_CLOCK:-wall}"
    echo "- $processor, $(getconf _NPROCESSORS_ONLN) processors, cache $cache, memory $memory, $(uname -sr)"
    echo "- $compilers; -O3, no -march but in the columns named native"
    echo "- ${packages%, }"
    echo "- load average at the start: $load"
}

load=$(cut -d' ' -f1-3 /proc/loadavg)
install_peers
build
[ -n "$BENCH_KEEP" ] || : >"$RUNS"
measure_all
if wants predicates && [ -x "$B/predicates" ]; then "$B/predicates" >"$B/predicates.txt"; fi
{
    conditions
    awk -v clock="${BENCH_CLOCK:-wall}" -f tests/bench/table.awk "$RUNS"
    if [ -s "$B/predicates.txt" ]; then
        printf '\n## predicates\n\n```\n'
        cat "$B/predicates.txt"
        printf '```\n'
    fi
} >"$B/table.md"
cat "$B/table.md"
echo "Written: $B/table.md; the raw lines: $RUNS"
