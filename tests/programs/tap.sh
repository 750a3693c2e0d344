# What the shell tests have in common: TAP lines. A test sources this file (`. tests/programs/tap.sh`), and calls plan at its end.
number=0
# A test with other files to show than the one that it hands to report defines this again.
explain() { # file of a report
    [ ! -e "$1" ] || awk '{ line[NR] = $0 }
        END { for (i = 1; i <= NR; i++) if (i <= 12 || i > NR - 8) print line[i] }' "$1"
}
report() { # 0: passed, name, file that explains a failure
    number=$((number + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $number - $2"
    else
        echo "not ok $number - $2"
        explain "$3" | cut -c 1-300 | sed 's/^/# /'
    fi
}
skip() { # name, reason
    number=$((number + 1))
    echo "ok $number - $1 # SKIP $2"
}
has() { command -v "$1" >/dev/null 2>&1; }
plan() { echo "1..$number"; }
