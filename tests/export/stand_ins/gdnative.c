/* A header in Godot 3: a native script whose method runs the scene and prints the digest. What it takes of GDNative is
   declared here, as far as it is used. */
#include <stdio.h>
#include <stdlib.h>

#define SANDGLASS_IMPLEMENTATION
#include "sandglass.h"

typedef struct {
    unsigned major, minor;
} version_of_api;
typedef struct api {
    unsigned type;
    version_of_api version;
    const struct api *next;
    unsigned extension_count;
    const struct api **extensions;
} api;
typedef struct {
    char in_editor;
    uint64_t hashes[3];
    void *reports[2], *library;
    const api *core;
    const void *path;
} options_of_start;
typedef struct {
    uint8_t bytes[24];
} variant;
typedef struct {
    void *(*create)(void *object, void *data);
    void *data;
    void (*release)(void *data);
} creation;
typedef struct {
    void (*destroy)(void *object, void *data, void *own);
    void *data;
    void (*release)(void *data);
} destruction;
typedef struct {
    variant (*call)(void *object, void *data, void *own, int count, variant **given);
    void *data;
    void (*release)(void *data);
} method;
typedef struct {
    unsigned type;
    version_of_api version;
    const api *next;
    void (*register_class)(void *handle, const char *name, const char *base, creation, destruction);
    void (*register_tool_class)(void *handle, const char *name, const char *base, creation, destruction);
    void (*register_method)(void *handle, const char *name, const char *function, int rpc, method);
} script_api;

enum { NATIVE_SCRIPT = 1 };
static const script_api *scripts;

static void *create(void *object, void *data)
{
    sandglass *world = sandglass_init(malloc(sandglass_bytes(SANDGLASS_SCENE_WIDTH, SANDGLASS_SCENE_HEIGHT)),
                                      SANDGLASS_SCENE_WIDTH, SANDGLASS_SCENE_HEIGHT, 1);
    (void)object, (void)data;
    sandglass_scene(world);
    return world;
}

static void destroy(void *object, void *data, void *own)
{
    (void)object, (void)data;
    free(own);
}

static variant run(void *object, void *data, void *own, int count, variant **given)
{
    variant nothing = { { 0 } };
    char digest[33];
    (void)object, (void)data, (void)count, (void)given;
    sandglass_step((sandglass *)own, 80);
    sandglass_digest((sandglass *)own, digest);
    printf("%s\n", digest);
    fflush(stdout);
    return nothing;
}

void godot_gdnative_init(options_of_start *options);
void godot_gdnative_terminate(void *options);
void godot_nativescript_init(void *handle);

void godot_gdnative_init(options_of_start *options)
{
    unsigned i;
    for (i = 0; i < options->core->extension_count; i++)
        if (options->core->extensions[i]->type == NATIVE_SCRIPT)
            scripts = (const script_api *)(const void *)options->core->extensions[i];
}

void godot_gdnative_terminate(void *options)
{
    (void)options;
}

void godot_nativescript_init(void *handle)
{
    creation made = { create, 0, 0 };
    destruction gone = { destroy, 0, 0 };
    method called = { run, 0, 0 };
    scripts->register_class(handle, "SandWorld", "Reference", made, gone);
    scripts->register_method(handle, "SandWorld", "run", 0, called);
}
