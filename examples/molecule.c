// The room that each atom of a molecule takes: its cell in the power diagram of the atoms and of a solvent around them.
// Here ethanol. Writes molecule.svg.
//
//     cc -O2 -o molecule examples/molecule.c -lm && ./molecule
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ATOMS = 9, MOST = 1000 };

static const double towards[3] = {0.29, -0.82, 0.49}, right[3] = {0.94, 0.34, 0}, up[3] = {-0.17, 0.46, 0.87}; // of a viewer
static const char names[ATOMS + 1] = "OCCHHHHHH";
static double centres[MOST][3] = {{-1.17, 0.30, 0.00},  {-0.05, -0.57, 0.00}, {1.22, 0.27, 0.00},
                                  {-0.10, -1.21, 0.88}, {-0.10, -1.19, -0.89}, {2.11, -0.37, -0.02},
                                  {1.24, 0.93, -0.87},  {1.26, 0.91, 0.89},    {-1.13, 0.84, 0.81}};
static double weights[MOST]; // squared radii

static double radius(char name) { return name == 'H' ? 1.1 : name == 'C' ? 1.7 : 1.52; }
static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Fills space around the molecule with water, of radius 1.4. Returns the number of all spheres.
static size_t add_water(size_t count) {
    for (int i = 0; i < 1000; i++) {
        double *x = centres[count];
        int free = 1;
        for (int k = 0, n = i; k < 3; k++, n /= 10)
            x[k] = 1.5 * (n % 10 - 4.5);
        for (int a = 0; a < ATOMS; a++) {
            const double d[3] = {x[0] - centres[a][0], x[1] - centres[a][1], x[2] - centres[a][2]};
            free &= sqrt(dot(d, d)) > radius(names[a]) + 1.4;
        }
        if (free)
            weights[count++] = 1.4 * 1.4;
    }
    return count;
}

static int by_depth(const void *a, const void *b) { // power cells hide each other in the order of their centres
    double x = dot(centres[*(const size_t *)a], towards), y = dot(centres[*(const size_t *)b], towards);
    return (x > y) - (x < y);
}

// Draws a face if it looks towards the viewer.
static void draw(FILE *svg, const paradt_voronoi *v, size_t face, size_t atom) {
    const double way = v->sides[2 * face] == (paradt_index)atom ? 1 : -1, *normal = v->normals + 3 * face;
    const char *colour = names[atom] == 'O' ? "0,70%" : names[atom] == 'C' ? "210,10%" : "50,30%";
    if (way * dot(normal, towards) <= 0)
        return;
    fprintf(svg, "<path fill='hsl(%s,%.0f%%)' d='M", colour, (names[atom] == 'H' ? 75 : 45) + 20 * way * dot(normal, up));
    for (size_t i = v->first_vertex[face]; i < v->first_vertex[face + 1]; i++) {
        const double *x = v->vertices + 3 * v->polygons[i];
        fprintf(svg, "%.1f %.1f ", 200 + 50 * dot(x, right), 160 - 50 * dot(x, up));
    }
    fprintf(svg, "Z'/>\n");
}

int main(void) {
    const paradt_voronoi_request want = {PARADT_VORONOI_VOLUMES | PARADT_VORONOI_FACES | PARADT_VORONOI_NORMALS |
                                             PARADT_VORONOI_POLYGONS, NULL, NULL, 0};
    paradt_points spheres;
    paradt_triangulation t;
    paradt_voronoi v;
    size_t order[ATOMS];
    double whole = 0;
    for (size_t a = 0; a < ATOMS; a++) {
        weights[a] = radius(names[a]) * radius(names[a]);
        order[a] = a;
    }
    spheres = paradt_points_f64(centres[0], add_water(ATOMS), 3);
    spheres.weights = weights;
    if (paradt_triangulate(&t, &spheres, NULL) || paradt_voronoi_compute(&v, &t, &spheres, &want, NULL))
        return 1;
    FILE *svg = fopen("molecule.svg", "w");
    if (!svg)
        return 1;
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 320' stroke='#333' stroke-width='.7'>\n");
    qsort(order, ATOMS, sizeof *order, by_depth);
    for (size_t i = 0; i < ATOMS; i++)
        for (size_t k = v.first_face[order[i]]; k < v.first_face[order[i] + 1]; k++)
            draw(svg, &v, (size_t)v.faces[k], order[i]);
    fprintf(svg, "</svg>\n");
    fclose(svg);
    for (size_t a = 0; a < ATOMS; a++) {
        printf("%c %.2f cubic angstroms\n", names[a], v.volumes[a]);
        whole += v.volumes[a];
    }
    printf("ethanol %.2f\n", whole);
    paradt_voronoi_free(&v);
    paradt_free(&t);
    return 0;
}
