#!/bin/sh
# Usage: coverage.sh PROGRAM... Runs the programs that `make coverage` built to count what they reach, JOBS at a time, and prints
# how many of the lines and branches of each header and section that is: a branch is one outcome of a condition. Lines that no
# program reaches stand in tests/uncovered.txt with the reason why; the others are named. The exit status is 1 if less than LEAST
# per cent of a header's lines are reached, or a program failed or is missing.
LEAST=95
SECONDS_EACH=1200
work=build/coverage
rm -rf $work/raw $work/logs $work/lines
mkdir -p $work/raw $work/logs $work/lines
. tests/programs/mpich.sh
. tests/programs/tap.sh
for tool in clang llvm-profdata llvm-cov; do
    has $tool || { echo "coverage.sh: needs $tool (apt-get install clang llvm)" >&2 && exit 2; }
done
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

# run PROGRAM: leaves its counts in raw/COPY-NAME.profraw, where COPY names the copy of the implementation that it has.
cat >$work/run.sh <<'END'
program=$1
name=$(echo "${program#build/coverage/}" | tr / -)
[ -x "$program" ] || { echo "$name did not build" && exit; }
export LLVM_PROFILE_FILE="build/coverage/raw/$name-%m.profraw"
run() { timeout -k 5 $SECONDS_EACH "$@" </dev/null >>"build/coverage/logs/$name.log" 2>&1 || echo "$name failed: see build/coverage/logs/$name.log"; }
case $name in
*fuzz_*) run "$program" fuzz/corpus/"${name#*fuzz_}"/* ;;
ranks) run "$program" 300; run "$program" 100 weights ;;
mpi) for group in many shares options weights errors; do run mpiexec -n 8 "$program" $group; done ;;
*) run "$program" ;;
esac
END
export SECONDS_EACH
printf '%s\n' "$@" | xargs -P "${JOBS:-1}" -n 1 sh $work/run.sh | tee $work/failures

# The lines and branches of one copy of the implementation: those programs that link the same object share a copy.
counts() { # name of the copy, a program that has it, files of counts
    copy=$1 program=$2
    shift 2
    llvm-profdata merge -sparse -o $work/lines/$copy.profdata "$@" &&
        llvm-cov export -format=lcov -instr-profile $work/lines/$copy.profdata "$program" >$work/lines/$copy.lcov
}
for lanes in best sse2 plain; do
    linked=
    for program in "$@"; do
        name=${program##*/}
        case $program in
        */$lanes/*) ;;
        *) continue ;;
        esac
        ls $work/raw/$lanes-$name-*.profraw >/dev/null 2>&1 || continue
        if [ -e tests/$name.c ] && grep -q '^ *# *define *PARADT_IMPLEMENTATION' tests/$name.c; then
            counts $lanes-$name "$program" $work/raw/$lanes-$name-*.profraw
        else
            linked="$linked $(echo $work/raw/$lanes-$name-*.profraw)"
            last=$program
        fi
    done
    [ -z "$linked" ] || counts $lanes $last $linked
done
for name in ranks mpi; do
    ls $work/raw/$name-*.profraw >/dev/null 2>&1 && counts $name $work/$name $work/raw/$name-*.profraw
done

# A line counts once for all copies, a branch by its place in its line. A program with a copy of its own uses it in part, and
# of the rest clang knows no more than the text: such a copy shows what is reached, not what could be.
awk -v least=$LEAST '
    function percent(some, all) { return all ? sprintf("%.1f", int(1000 * some / all) / 10) : "-" }
    function row(name, i) {
        printf "  %-32s %6d of %6d  %5s %%  %6d of %6d  %5s %%\n", name, covered[i], lines[i], percent(covered[i], lines[i]),
            taken[i], branches[i], percent(taken[i], branches[i])
    }
    FILENAME ~ /uncovered\.txt$/ { if ($0 !~ /^#/ && NF) known[$0] = 1; next }
    FILENAME ~ /\.lcov$/ {
        copy = FILENAME; sub(/.*\//, "", copy)
        if (/^SF:/) { file = $0; sub(/.*\//, "", file); wanted = file == "paradt.h" || file == "paradt_mpi.h"; delete place; partial = file == "paradt.h" && copy !~ /^(best|sse2|plain)\.lcov$/ }
        else if (!wanted) next
        else if (/^DA:/) {
            split(substr($0, 4), part, ",")
            if (part[2] > 0 || !partial) line[file, part[1]] += part[2] > 0
        } else if (/^BRDA:/) {
            split(substr($0, 6), part, ",")
            at = file SUBSEP part[1] SUBSEP place[part[1]]++
            if (part[4] > 0 || !partial) branch[at] += part[4] > 0
        }
        next
    }
    FNR == 1 { header = FILENAME; section = header " before its sections"; order[++sections] = section }
    /^\/\/ >>/ && rule { section = (header == "paradt.h" ? "" : "mpi ") substr($0, 6); order[++sections] = section }
    { rule = /^\/\/ -----/ }
    (header, FNR) in line && !/^ *(#|\/\/|PARADT_ASSERT\(.*\);$)/ {
        lines[section]++
        lines[header]++
        if (line[header, FNR]) { covered[section]++; covered[header]++ }
        else {
            text = $0
            sub(/^ +/, "", text)
            if ((section "|" text) in known) { explained++; known[section "|" text] = 2 }
            else if (text ~ /[A-Za-z0-9]/) left[++unexplained] = header ":" FNR "|" section "|" text
        }
        for (i = 0; (header, FNR, i) in branch; i++) {
            branches[section]++
            branches[header]++
            if (branch[header, FNR, i]) { taken[section]++; taken[header]++ }
        }
    }
    END {
        printf "  %-32s %24s  %26s\n", "", "lines", "branches"
        for (i = 1; i <= sections; i++) if (lines[order[i]]) row(order[i], order[i])
        print ""
        for (i = 1; i <= 2; i++) {
            header = i == 1 ? "paradt.h" : "paradt_mpi.h"
            row(header, header)
            if (100 * covered[header] < least * lines[header]) { print "  less than " least " % of its lines"; short = 1 }
        }
        print ""
        for (entry in known) if (known[entry] == 1) print "reached, or gone, but in tests/uncovered.txt: " entry
        print explained + 0 " lines are in tests/uncovered.txt with the reason; " unexplained + 0 " are not reached and not there"
        for (i = 1; i <= unexplained; i++) print left[i]
        exit short
    }' tests/uncovered.txt $work/lines/*.lcov paradt.h paradt_mpi.h >$work/report
status=$?
cat $work/report
[ $status = 0 ] && [ ! -s $work/failures ]
