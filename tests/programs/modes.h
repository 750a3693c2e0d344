// Modes of floating point that break careless code, for programs that are run in them.
//   up, down, zero   the rounding mode
//   ftz              subnormal results and operands are zeros (SSE)
//   single, double   the precision of x87 registers
#ifndef MODES_H
#define MODES_H

#include <fenv.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if defined(__SSE__) && !defined(__TINYC__)
#include <xmmintrin.h>
#endif

static void enter(const char *mode) {
#ifdef FE_UPWARD
    if (!strcmp(mode, "up") || !strcmp(mode, "down") || !strcmp(mode, "zero")) {
        fesetround(mode[0] == 'u' ? FE_UPWARD : mode[0] == 'd' ? FE_DOWNWARD : FE_TOWARDZERO);
        return;
    }
#endif
#if defined(__SSE__) && !defined(__TINYC__)
    if (!strcmp(mode, "ftz")) {
        _mm_setcsr(_mm_getcsr() | 0x8040u);
        return;
    }
#endif
#if defined(__i386__) && !defined(__TINYC__)
    if (!strcmp(mode, "single") || !strcmp(mode, "double")) {
        unsigned short control;
        __asm__ volatile("fnstcw %0" : "=m"(control));
        control = (unsigned short)((control & ~0x300u) | (mode[0] == 'd' ? 0x200u : 0u));
        __asm__ volatile("fldcw %0" : : "m"(control));
        return;
    }
#endif
    fprintf(stderr, "this build has no mode %s\n", mode);
    exit(2);
}

// Numbers come from a little-endian file. A processor of the other order turns their bytes around.
static void turn(void *numbers, size_t count, size_t width) {
    const unsigned one = 1;
    unsigned char *bytes = (unsigned char *)numbers, kept;
    size_t i, j;
    for (i = 0; i < count && !*(const unsigned char *)&one; i++, bytes += width)
        for (j = 0; j < width / 2; j++) {
            kept = bytes[j];
            bytes[j] = bytes[width - 1 - j];
            bytes[width - 1 - j] = kept;
        }
}

// Reads the four numbers that a sample begins with; 0: the file is at its end.
static int get_head(FILE *file, int32_t *head) {
    if (fread(head, sizeof *head, 4, file) != 4)
        return 0;
    turn(head, 4, sizeof *head);
    return 1;
}

static void *get(FILE *file, size_t count, size_t width) {
    void *memory = malloc(count ? count * width : 1);
    if (!memory || fread(memory, width, count, file) != count) {
        fprintf(stderr, "the file ends early\n");
        exit(1);
    }
    turn(memory, count, width);
    return memory;
}
#endif
