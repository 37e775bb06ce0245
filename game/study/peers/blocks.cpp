// The loop that most toys would write: a byte for each cell, block after block. Compiled and called by cpp_blocks.py.
#include <cstdint>

#ifdef _WIN32
#define PUBLIC extern "C" __declspec(dllexport)
#else
#define PUBLIC extern "C"
#endif

enum : std::uint8_t { EMPTY, SAND, WALL };

// Runs the iterations in place on height x width cells with a border of wall.
// offsets: x, y of the partitions, repeated. Thresholds: topple probabilities in units of 2^-32.
PUBLIC void advance(std::uint8_t *cells, std::int64_t height, std::int64_t width, const std::int64_t *offsets,
                    std::int64_t partitions, std::int64_t start, std::int64_t iterations, std::uint64_t threshold_left,
                    std::uint64_t threshold_right) {
    std::uint64_t random = std::uint64_t(start) + 88172645463325252u;
    for (std::int64_t t = start; t < start + iterations; ++t) {
        const std::int64_t left = offsets[2 * (t % partitions)], top = offsets[2 * (t % partitions) + 1];
        for (std::int64_t y = 1 - top; y < height - 1; y += 2) {
            std::uint8_t *upper = cells + y * width, *lower = upper + width;
            for (std::int64_t x = 1 - left; x < width - 1; x += 2) {
                std::uint8_t &a = upper[x], &b = upper[x + 1], &c = lower[x], &d = lower[x + 1];
                if (a != SAND && b != SAND) continue;
                const bool a_falls = a == SAND && c == EMPTY, b_falls = b == SAND && d == EMPTY;
                if (a_falls) a = EMPTY, c = SAND;
                if (b_falls) b = EMPTY, d = SAND;
                if (a_falls || b_falls) continue;
                const bool right = a == SAND && b == EMPTY && d == EMPTY;
                if (!right && !(b == SAND && a == EMPTY && c == EMPTY)) continue;
                random ^= random << 13;  // xorshift64, Marsaglia 2003
                random ^= random >> 7;
                random ^= random << 17;
                if ((random >> 32) >= (right ? threshold_right : threshold_left)) continue;
                if (right) a = EMPTY, d = SAND;
                else b = EMPTY, c = SAND;
            }
        }
    }
}
