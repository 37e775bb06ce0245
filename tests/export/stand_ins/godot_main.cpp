class Opened : public SandWorld {
public:
    static void bind() { _bind_methods(); }
};

int main() {
    Opened node;
    Opened::bind();
    node._ready();
    for (int frame = 0; frame < 20; frame++) node._process(1.0 / 60);
    std::printf("%x %d\n", unsigned(node.texture->image->first), node.paint(-100, 0, 3, 1));
}
