/* Stand-ins for what the README's class for Godot takes of godot-cpp, and a run of it. */
#ifndef GODOT
#define GODOT
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#define GDCLASS(own, base)

namespace godot {
template <class T> using Ref = T *; // leaks

class PackedByteArray {
    std::vector<uint8_t> bytes;

public:
    void resize(int64_t size) { bytes.resize(size); }
    uint8_t *ptrw() { return bytes.data(); }
    const uint8_t *ptr() const { return bytes.data(); }
};

struct Image {
    enum Format { FORMAT_RGBA8 };
    uint32_t first;
    static Ref<Image> create_from_data(int, int, bool, Format, const PackedByteArray &data) {
        Ref<Image> image = new Image();
        std::memcpy(&image->first, data.ptr(), 4);
        return image;
    }
};

struct ImageTexture {
    Ref<Image> image;
    static Ref<ImageTexture> create_from_image(const Ref<Image> &image) {
        Ref<ImageTexture> texture = new ImageTexture();
        texture->image = image;
        return texture;
    }
};

struct TextureRect {
    Ref<ImageTexture> texture;
    virtual ~TextureRect() {}
    virtual void _ready() {}
    virtual void _process(double) {}
    void set_texture(const Ref<ImageTexture> &shown) { texture = shown; }
};

struct MethodDefinition {};
template <class... Names> MethodDefinition D_METHOD(Names...) { return {}; }
struct ClassDB {
    template <class Method> static void bind_method(MethodDefinition, Method) {}
};
} // namespace godot
#endif
