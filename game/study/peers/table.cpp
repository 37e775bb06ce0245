// The loop that most toys would write for many materials: a byte for each cell, block states looked up in a table.
// Compiled and called by cpp_blocks.py.
#include <cstdint>

#ifdef _WIN32
#define PUBLIC extern "C" __declspec(dllexport)
#else
#define PUBLIC extern "C"
#endif

static const std::uint64_t GOLDEN = 0x9E3779B97F4A7C15u;

static inline std::uint64_t mix(std::uint64_t z) {  // splitmix64, Steele, Lea & Flood 2014
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

// Runs the iterations in place on height x width cells with a border of what is outside.
// offsets: x, y of the partitions, repeated. first, last, after: see block_table.py.
PUBLIC void advance(std::uint8_t *cells, std::int64_t height, std::int64_t width, const std::int64_t *offsets,
                    std::int64_t partitions, std::int64_t start, std::int64_t iterations, std::int64_t bits,
                    const std::uint32_t *first, const std::uint32_t *last, const std::uint16_t *after) {
    const std::int64_t across = (width - 2) / 2 + 1;
    const unsigned low = (1u << bits) - 1;
    for (std::int64_t t = start; t < start + iterations; ++t) {
        const std::uint64_t key = mix(std::uint64_t(t) * GOLDEN);
        const std::int64_t left = offsets[2 * (t % partitions)], top = offsets[2 * (t % partitions) + 1];
        for (std::int64_t y = 1 - top; y < height - 1; y += 2) {
            std::uint8_t *upper = cells + y * width, *lower = upper + width;
            const std::uint64_t row = std::uint64_t((y + 1) / 2 * across);
            for (std::int64_t x = 1 - left; x < width - 1; x += 2) {
                const unsigned state =
                    upper[x] | upper[x + 1] << bits | lower[x] << 2 * bits | unsigned(lower[x + 1]) << 3 * bits;
                std::uint32_t at = first[state];
                const std::uint32_t end = first[state + 1];
                if (at == end) continue;
                if (last[at] != 0xFFFFFFFFu) {
                    const std::uint32_t drawn = mix(key + (row + std::uint64_t((x + 1) / 2)) * GOLDEN) >> 32;
                    while (at < end && drawn > last[at]) ++at;
                    if (at == end) continue;
                }
                const unsigned now = after[at];
                upper[x] = now & low, upper[x + 1] = now >> bits & low;
                lower[x] = now >> 2 * bits & low, lower[x + 1] = now >> 3 * bits & low;
            }
        }
    }
}
