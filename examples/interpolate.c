// Linear interpolation of scattered samples onto a grid. Writes interpolate.svg.
//
//     cc -O2 -o interpolate examples/interpolate.c -lm && ./interpolate
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SAMPLES = 400, SIDE = 80 };

static double chance(void) { return rand() / (RAND_MAX + 1.0); }
static double height(const double *x) { return sin(7 * x[0]) * cos(5 * x[1]); }

// Twice the signed area of a triangle
static double area(const double *a, const double *b, const double *c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

int main(void) {
    static double samples[SAMPLES][2], values[SAMPLES], grid[SIDE * SIDE][2];
    static paradt_location found[SIDE * SIDE];
    const paradt_points points = paradt_points_f64(samples[0], SAMPLES, 2);
    const paradt_points queries = paradt_points_f64(grid[0], SIDE * SIDE, 2);
    paradt_triangulation t;
    paradt_locator *locator;
    double squares = 0;
    int inside = 0;
    for (int i = 0; i < SAMPLES; i++) {
        samples[i][0] = 1.1 * chance() - 0.05;
        samples[i][1] = 1.1 * chance() - 0.05;
        values[i] = height(samples[i]);
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        grid[i][0] = (i % SIDE + 0.5) / SIDE;
        grid[i][1] = (i / SIDE + 0.5) / SIDE;
    }
    if (paradt_triangulate(&t, &points, NULL) || paradt_locator_create(&locator, &t, &points, NULL) ||
        paradt_locate(locator, &queries, found, NULL))
        return 1;
    FILE *svg = fopen("interpolate.svg", "w");
    if (!svg)
        return 1;
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d %d'>\n", SIDE, SIDE);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double value = 0, whole = 0;
        if (!found[i].face) // outside the hull, nothing is known
            continue;
        for (int j = 0; j < 3; j++) { // a sample's share: the triangle of the query and the other two
            const paradt_index *v = t.cells + 3 * found[i].cell;
            double share = area(grid[i], samples[v[(j + 1) % 3]], samples[v[(j + 2) % 3]]);
            value += share * values[v[j]];
            whole += share;
        }
        value /= whole;
        squares += pow(value - height(grid[i]), 2);
        inside++;
        fprintf(svg, "<rect x='%d' y='%d' width='1.1' height='1.1' fill='hsl(%.0f,55%%,65%%)'/>\n", i % SIDE, i / SIDE,
                220 - 90 * (1 - value));
    }
    for (int i = 0; i < SAMPLES; i++)
        fprintf(svg, "<circle cx='%.2f' cy='%.2f' r='.4'/>\n", SIDE * samples[i][0], SIDE * samples[i][1]);
    fprintf(svg, "</svg>\n");
    fclose(svg);
    printf("%d places are inside, error %.3f\n", inside, sqrt(squares / inside));
    paradt_locator_free(locator);
    paradt_free(&t);
    return 0;
}
