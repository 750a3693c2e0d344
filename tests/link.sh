#!/bin/sh
# What a program that includes the header in several files, or in other ways than the plain one, relies on. Prints TAP.
work=build/tests/link
rm -rf "$work"
mkdir -p "$work"
CC=${CC:-cc}
number=0

report() { # 0: good, name, log
    number=$((number + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $number - $2"
    else
        echo "not ok $number - $2"
        sed 's/^/# /' "$3" | head -20
    fi
}
skip() {
    number=$((number + 1))
    echo "ok $number - $1 # SKIP $2"
}
has() { command -v "$1" >/dev/null 2>&1; }

# --- the clock: a call in which nearly all time passes asleep
cat >"$work/clock.c" <<'END'
#define PARADT_IMPLEMENTATION
#include "paradt.h"
#include <stdio.h>
int usleep(unsigned microseconds); /* which a strict standard does not declare */
static int doze(void *user, double fraction) {
    int *once = (int *)user;
    if (!(*once)++) usleep(300000);
    return fraction < 0;
}
int main(void) {
    static const double x[] = {0, 0, 1, 0, 0, 1};
    paradt_points points = {0};
    paradt_options options = {0};
    paradt_triangulation t;
    int once = 0;
    points.data = x;
    points.count = 3;
    points.dim = 2;
    options.progress = doze;
    options.user = &once;
    if (paradt_triangulate(&t, &points, &options) != PARADT_OK) return 1;
    printf("%.3f s\n", t.stats.seconds);
    return !(t.stats.seconds >= 0.29 && t.stats.seconds < 30);
}
END
for way in gcc-c99 gcc-c11 gcc-gnu99 clang-c99 tcc-c99; do
    compiler=${way%-*} strict="-Wall -Wextra -Wpedantic -Werror"
    [ $compiler = tcc ] && strict=
    if has $compiler; then
        $compiler -std=${way#*-} $strict -I. "$work/clock.c" -o "$work/clock" -lm >"$work/clock.log" 2>&1 &&
            [ ! -s "$work/clock.log" ] && "$work/clock" >"$work/clock.log" 2>&1
        report $? "seconds_are_wall_time_$way" "$work/clock.log"
    else
        skip "seconds_are_wall_time_$way" "$compiler is not installed"
    fi
done

echo "1..$number"
