// The density at each particle of an N-body snapshot: its mass over the volume of its Voronoi cell. Nothing is to be chosen,
// no kernel and no grid. Writes density.svg: the particles of a slice, bright where it is dense.
//
//     cc -O2 -o density examples/density.c -lm && ./density
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT = 20000 };

static double chance(void) { return rand() / (RAND_MAX + 1.0); }

// Plummer's model of a star cluster: density 3 / (4 pi) (1 + r^2)^(-5/2)
static double model(double r) { return 3 / (4 * 3.14159265358979) * pow(1 + r * r, -2.5); }
static void place(double *x) {
    double r = 1 / sqrt(pow(0.97 * chance() + 1e-9, -2.0 / 3) - 1), length;
    do {
        for (int k = 0; k < 3; k++)
            x[k] = 2 * chance() - 1;
        length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    } while (length > 1 || length == 0);
    for (int k = 0; k < 3; k++)
        x[k] *= r / length;
}

int main(void) {
    static const double box[6] = {-8, -8, -8, 8, 8, 8};
    static double particles[COUNT][3];
    const paradt_points points = paradt_points_f64(particles[0], COUNT, 3);
    const paradt_voronoi_request want = {PARADT_VORONOI_VOLUMES, box, NULL, 0};
    paradt_triangulation t;
    paradt_voronoi v;
    double logs = 0;
    int inner = 0;
    for (int i = 0; i < COUNT; i++)
        place(particles[i]);
    if (paradt_triangulate(&t, &points, NULL) || paradt_voronoi_compute(&v, &t, &points, &want, NULL))
        return 1;
    FILE *svg = fopen("density.svg", "w");
    if (!svg)
        return 1;
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 400'>\n<rect width='400' height='400'/>\n");
    for (int i = 0; i < COUNT; i++) {
        const double *x = particles[i], r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        const double density = 0.97 / COUNT / v.volumes[i];
        if (r < 1) {
            logs += log(density / model(r));
            inner++;
        }
        if (fabs(x[2]) < 0.3)
            fprintf(svg, "<circle cx='%.1f' cy='%.1f' r='1.2' fill='hsl(%.0f,90%%,%.0f%%)'/>\n", 200 + 50 * x[0],
                    200 + 50 * x[1], fmin(60, 60 + 12 * log10(density)), fmax(25, fmin(90, 90 + 16 * log10(density))));
    }
    fprintf(svg, "</svg>\n");
    fclose(svg);
    printf("density over the model's, geometric mean of %d particles: %.3f\n", inner, exp(logs / inner));
    paradt_voronoi_free(&v);
    paradt_free(&t);
    return 0;
}
