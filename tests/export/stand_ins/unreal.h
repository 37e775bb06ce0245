/* Stand-ins for what the README's class for Unreal takes of the engine. */
#ifndef UNREAL
#define UNREAL
#include <cstdint>
#include <cstdio>
#include <vector>

#define UCLASS(...)
#define UPROPERTY(...)
#define GENERATED_BODY() using Super = UActorComponent;
using uint8 = uint8_t;
using uint32 = uint32_t;
using uint64 = uint64_t;

template <class T> class TArray {
    std::vector<T> items;

public:
    void SetNumZeroed(int size) { items.assign(size, 0); }
    T *GetData() { return items.data(); }
};

struct FUpdateTextureRegion2D {
    uint32 DestX, DestY;
    int SrcX, SrcY;
    uint32 Width, Height;
};
enum ELevelTick { LEVELTICK_All };
enum EPixelFormat { PF_R8G8B8A8 };
struct FActorComponentTickFunction {
    bool bCanEverTick;
};

struct UTexture2D {
    uint32 First;
    static UTexture2D *CreateTransient(int, int, EPixelFormat) { return new UTexture2D(); }
    void UpdateTextureRegions(int, uint32, const FUpdateTextureRegion2D *, uint32, uint32, uint8 *Data) {
        First = Data[0] | Data[1] << 8 | Data[2] << 16 | uint32(Data[3]) << 24;
    }
};

class UActorComponent {
public:
    FActorComponentTickFunction PrimaryComponentTick;
    virtual ~UActorComponent() {}
    virtual void BeginPlay() {}
    virtual void TickComponent(float, ELevelTick, FActorComponentTickFunction *) {}
};
#endif
