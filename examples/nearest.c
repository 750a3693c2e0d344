// A game: each creature runs to its nearest shelter, and a wanderer asks at every step. Writes nearest.svg.
//
//     cc -O2 -o nearest examples/nearest.c -lm && ./nearest
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SHELTERS = 40, CREATURES = 600, STEPS = 300 };

static double chance(void) { return rand() / (RAND_MAX + 1.0); }

static void scatter(double (*places)[2], int count) {
    for (int i = 0; i < count; i++) {
        places[i][0] = chance();
        places[i][1] = chance();
    }
}

int main(void) {
    static double shelters[SHELTERS][2], creatures[CREATURES][2];
    static paradt_index refuge[CREATURES];
    const paradt_points points = paradt_points_f64(shelters[0], SHELTERS, 2);
    const paradt_points queries = paradt_points_f64(creatures[0], CREATURES, 2);
    paradt_triangulation t;
    paradt_locator *locator;
    scatter(shelters, SHELTERS);
    scatter(creatures, CREATURES);
    if (paradt_triangulate(&t, &points, NULL) || paradt_locator_create(&locator, &t, &points, NULL) ||
        paradt_nearest(locator, &queries, refuge, NULL)) // all at once
        return 1;
    FILE *svg = fopen("nearest.svg", "w");
    if (!svg)
        return 1;
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 400' fill='none'>\n");
    for (int i = 0; i < CREATURES; i++) {
        const double *from = creatures[i], *to = shelters[refuge[i]];
        fprintf(svg, "<path stroke='hsl(%d,60%%,55%%)' d='M%.1f %.1fL%.1f %.1f'/>\n", (int)refuge[i] * 137 % 360,
                400 * from[0], 400 * from[1], 400 * to[0], 400 * to[1]);
    }
    paradt_index last = -1; // the answer before is a good hint: the wanderer has not gone far
    int changes = 0;
    fprintf(svg, "<g fill='#222'>\n");
    for (int step = 0; step < STEPS; step++) {
        const double turn = 0.04 * step, here[2] = {0.5 + 0.0014 * step * cos(turn), 0.5 + 0.0014 * step * sin(turn)};
        paradt_index now = paradt_nearest_one(locator, here, last);
        // a large dot where another shelter becomes the nearest
        fprintf(svg, "<circle cx='%.1f' cy='%.1f' r='%g'/>\n", 400 * here[0], 400 * here[1], now != last ? 4.5 : 1.2);
        changes += now != last;
        last = now;
    }
    fprintf(svg, "</g>\n</svg>\n");
    fclose(svg);
    printf("the wanderer's nearest shelter changed %d times\n", changes);
    paradt_locator_free(locator);
    paradt_free(&t);
    return 0;
}
