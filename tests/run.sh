#!/bin/sh
# Usage: run.sh LIST LOGS. Runs the test programs named in the file LIST, JOBS at a time, each for at most TEST_SECONDS, and writes
# their output to the folder LOGS. A line "skip NAME REASON..." stands for a test that can't run here.
# Programs print TAP. These count as failures: lines "not ok"; tests of the plan that did not report; programs that did not build,
# crashed, ran out of time or reported nothing. The last line printed is "N passed, N failed".
TEST_SECONDS=${TEST_SECONDS:-1200}

# The address sanitizer must accept that stdbuf preloads a library.
export ASAN_OPTIONS=verify_asan_link_order=0

# Runs one program and writes its counts to LOGS/NAME.count.
run_one() {
    program=$1
    logs=$2
    name=${program#build/tests/}
    name=${name#tests/}
    file=$(printf '%s' "$name" | tr / -)
    log=$logs/$file.log
    start=$(date +%s)
    case $program in
    *.sh) timeout -k 5 "$TEST_SECONDS" sh "$program" >"$log" 2>&1 ;;
    *)
        if [ -x "$program" ]; then
            CMOCKA_MESSAGE_OUTPUT=TAP stdbuf -oL timeout -k 5 "$TEST_SECONDS" "$program" >"$log" 2>&1
        else
            echo "did not build" >"$log"
            (exit 127)
        fi
        ;;
    esac
    status=$?
    seconds=$(($(date +%s) - start))
    # The last line of `times`, 1m2.34s 0m5.67s, is what the program and those that it started took of the processors.
    times >"$logs/$file.times"
    used=$(awk 'END { gsub("s", ""); for (i = 1; i <= 2; i++) { split($i, part, "m"); sum += 60 * part[1] + part[2] } printf "%d", sum }' \
        "$logs/$file.times")
    awk -v status="$status" -v name="$name" -v seconds="$seconds" -v used="$used" -v count="$logs/$file.count" -v limit="$TEST_SECONDS" '
        /^1\.\.[0-9]+$/     { planned += substr($0, 4) }
        /^(not )?ok.*# SKIP/ { skipped++; notes = notes "    skipped: " $0 "\n"; before = ""; next }
        /^ok /              { passed++; before = "" }
        /^not ok /          { failed++; if (shown++ < 20) notes = notes "    " $0 "\n" before; before = ""; next }
        # Remarks on a failing test come before or after its line. Both are shown below it.
        /^# /               { if (lines++ < 60) before = before "        " $0 "\n"; next }
                            { last[NR % 8] = $0 }
        END {
            reported = passed + failed + skipped
            if (failed) notes = notes before
            if (planned > reported) {
                failed += planned - reported
                notes = notes "    " planned - reported " of the planned tests never reported\n"
            }
            if (status != 0 && failed == 0) failed++
            if (reported == 0 && failed == 0) { failed++; notes = notes "    reported no test\n" }
            if (status == 124 || status == 137) notes = notes "    stopped after " limit " seconds\n"
            if (status != 0 && planned + reported == 0 || status > 123)
                for (i = NR + 1; i <= NR + 8; i++) if (last[i % 8] != "") notes = notes "    | " last[i % 8] "\n"
            printf "%-32s %4d passed, %d failed%s  (%d s, processors %d s)\n%s", name, passed, failed,
                skipped ? ", " skipped " skipped" : "", seconds, used, notes
            print passed + 0, failed + 0, skipped + 0 >count
        }' "$log"
}

if [ "$1" = --one ]; then
    run_one "$2" "$3"
    exit 0
fi

list=$1
logs=$2
rm -rf "$logs"
mkdir -p "$logs"
grep -v '^skip ' "$list" | xargs -P "${JOBS:-1}" -I{} sh "$0" --one {} "$logs"
sed -n 's/^skip /skipped: /p' "$list"
skipped=$(grep -c '^skip ' "$list")
started=$(grep -vc '^skip ' "$list")
set -- "$logs"/*.count
finished=$#
[ -e "$1" ] || finished=0
cat "$logs"/*.count 2>/dev/null | awk -v skipped="$skipped" -v lost="$((started - finished))" '
    { passed += $1; failed += $2; skipped += $3 }
    END {
        failed += lost
        if (passed + failed == 0) failed = 1
        if (skipped) print skipped " skipped"
        printf "%d passed, %d failed\n", passed, failed
    }' | tee "${logs%/*}/summary"
tail -n 1 "${logs%/*}/summary" | grep -q ', 0 failed$'
