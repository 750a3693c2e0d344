#!/bin/sh
# runner_32.sh COMPILER FLAGS...: prints by what programs run that are built so for 32-bit processors: nothing where the
# system runs them itself, qemu-i386 where it doesn't. Fails where they can't be built, or run.
probe=$(mktemp) || exit 1
trap 'rm -f "$probe"' EXIT
printf '#include <stdlib.h>\nint main(void) { return 0; }\n' | "$@" -x c - -o "$probe" 2>/dev/null || exit 1
"$probe" 2>/dev/null && exit 0
qemu-i386 "$probe" 2>/dev/null && echo qemu-i386
