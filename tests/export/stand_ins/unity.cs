// Stand-ins for what the README's class for Unity takes of the engine, and a run of it.
namespace UnityEngine {
    public enum TextureFormat { RGBA32 }
    public class Texture2D {
        public uint[] Shown;
        uint[] given;
        public Texture2D(int width, int height, TextureFormat format, bool mipmaps) {}
        public void SetPixelData<T>(T[] data, int level) { given = (uint[])(object)data; }
        public void Apply() { Shown = (uint[])given.Clone(); }
    }
    public class Material { public Texture2D mainTexture; }
    public class Renderer { public Material material = new Material(); }
    public class MonoBehaviour {
        readonly Renderer renderer = new Renderer();
        public T GetComponent<T>() where T : class { return renderer as T; }
    }
}

public static class Run {
    static void Call(SandWorld world, string name) {
        var flags = System.Reflection.BindingFlags.NonPublic | System.Reflection.BindingFlags.Instance;
        typeof(SandWorld).GetMethod(name, flags).Invoke(world, null);
    }
    public static void Main() {
        var world = new SandWorld();
        Call(world, "Start");
        for (int frame = 0; frame < 20; frame++) Call(world, "Update");
        foreach (uint pixel in world.GetComponent<UnityEngine.Renderer>().material.mainTexture.Shown)
            System.Console.WriteLine(pixel);
        world.Paint(-100, 0, 3, 1);
        Call(world, "OnDestroy");
    }
}
