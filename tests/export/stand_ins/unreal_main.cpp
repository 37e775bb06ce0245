int main() {
    USandWorld Component;
    Component.BeginPlay();
    for (int Frame = 0; Frame < 20; Frame++) Component.TickComponent(1.0f / 60, LEVELTICK_All, nullptr);
    std::printf("%x 0\n", unsigned(Component.Texture->First));
}
