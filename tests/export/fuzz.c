/* Calls a header at random, with what no caller should hand over too, and with memory of just the bytes that are asked
   for: to be built with sanitizers, which end it where it reads or writes what is not its own. */
#include <stdio.h>
#include <stdlib.h>

#define SANDGLASS_IMPLEMENTATION
#include "sandglass.h"

static uint64_t state = 88172645463325252u;

static uint32_t any(uint32_t below)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 33) % below;
}

/* Return a number that is mostly near to 0 ... limit, and seldom anything. */
static int near_to(uint32_t limit)
{
    return any(20) ? (int)any(limit + 8) - 4 : (int)(any(2) ? 0u - any(2147483647u) : any(2147483647u));
}

static void call(sandglass *world, uint32_t width, uint32_t height)
{
    static const double chances[] = { 0.0, 1.0, 0.5, 0.3, 1e-300, -1.0, 2.0, 1e308 };
    uint32_t pitch = width + any(3), what = any(11);
    int material = near_to(SANDGLASS_MATERIALS);
    if (what == 0) sandglass_set(world, near_to(width), near_to(height), material);
    if (what == 1) sandglass_get(world, near_to(width), near_to(height));
    if (what == 2) sandglass_disc(world, near_to(width), near_to(height), near_to(20), material);
    if (what == 3) sandglass_flip(world);
    if (what == 4 && sandglass_count(world, material) > width * height) abort();
    if (what == 5) {
        uint8_t *cells = malloc((height - 1) * pitch + width);
        uint32_t i, air = 0;
        if (!sandglass_cells(world, cells, pitch)) abort();
        for (i = 0; i < width * height; i++) air += !cells[i / width * pitch + i % width];
        if (air != sandglass_count(world, 0)) abort();
        free(cells);
    }
    if (what == 6) {
        uint32_t *pixels = malloc(4 * ((height - 1) * pitch + width));
        sandglass_colours(world, 0, pixels, pitch);
        free(pixels);
    }
    if (what == 7) {
        const char *name = sandglass_chance_name(near_to(SANDGLASS_CHANCES));
        sandglass_set_chance(world, name ? name : "none", chances[any(8)]);
    }
    if (what == 8) sandglass_set_schedule(world, near_to(3));
    if (what == 9) sandglass_scene(world);
    if (what == 10) {
        char digest[33];
        sandglass_digest(world, digest);
    }
    sandglass_step(world, any(9));
}

int main(void)
{
    int number, i;
    for (number = 0; number < 30; number++) {
        uint32_t width = number % 5 ? 1 + any(300) : 1 + any(4), height = number % 7 ? 1 + any(90) : 1 + any(4), count = 0;
        void *memory = malloc(sandglass_bytes((int)width, (int)height));
        sandglass *world = sandglass_init(memory, (int)width, (int)height, state);
        if (!world) abort();
        for (i = 0; i < 60; i++) call(world, width, height);
        for (i = 0; i < SANDGLASS_MATERIALS; i++) count += sandglass_count(world, i);
        if (count != width * height) abort();
        free(memory);
    }
    puts("well");
    return 0;
}
