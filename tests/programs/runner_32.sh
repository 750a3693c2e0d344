#!/bin/sh
# Usage: runner_32.sh COMPILER FLAGS... Prints the command that runs programs built so for 32-bit processors: nothing if the
# system runs them itself, else qemu-i386. Fails if they cannot be built or run.
probe=$(mktemp) || exit 1
trap 'rm -f "$probe"' EXIT
printf '#include <stdlib.h>\nint main(void) { return 0; }\n' | "$@" -x c - -o "$probe" 2>/dev/null || exit 1
"$probe" 2>/dev/null && exit 0
qemu-i386 "$probe" 2>/dev/null && echo qemu-i386
