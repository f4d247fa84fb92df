// What the OpenXR loader and an API layer or a runtime exchange when they are loaded, as the loader's
// specification ("Loader/Layer Negotiation", "Loader/Runtime Negotiation") lays it out. Debian's
// headers of OpenXR 1.0 do not declare it. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

#ifdef _WIN32
#define GLOVETRACK_EXPORT extern "C" __declspec(dllexport)
#else
#define GLOVETRACK_EXPORT extern "C" __attribute__((visibility("default")))
#endif

namespace glovetrack {

constexpr uint32_t LAYER_INTERFACE = 1;    // version of the loader's interface
constexpr uint32_t RUNTIME_INTERFACE = 1;  // likewise
constexpr uint32_t STRUCTURE = 1;          // version of each structure below

enum class Kind : uint32_t {
    LoaderInfo = 1,
    LayerRequest = 2,
    RuntimeRequest = 3,
    LayerCreateInfo = 4,
    LayerNextInfo = 5,
};

struct LoaderInfo {
    Kind kind;
    uint32_t version;
    size_t size;
    uint32_t least_interface;
    uint32_t most_interface;
    XrVersion least_api;
    XrVersion most_api;
};

struct LayerCreateInfo;
using CreateLayerInstance = XrResult(XRAPI_PTR*)(const XrInstanceCreateInfo*,
                                                 const LayerCreateInfo*, XrInstance*);

struct LayerRequest {
    Kind kind;
    uint32_t version;
    size_t size;
    uint32_t interface_version;
    XrVersion api_version;
    PFN_xrGetInstanceProcAddr get_proc;
    CreateLayerInstance create_instance;
};

struct RuntimeRequest {
    Kind kind;
    uint32_t version;
    size_t size;
    uint32_t interface_version;
    XrVersion api_version;
    PFN_xrGetInstanceProcAddr get_proc;
};

struct LayerNextInfo {
    Kind kind;
    uint32_t version;
    size_t size;
    char name[XR_MAX_API_LAYER_NAME_SIZE];
    PFN_xrGetInstanceProcAddr get_proc;
    CreateLayerInstance create_instance;
    LayerNextInfo* next;
};

struct LayerCreateInfo {
    Kind kind;
    uint32_t version;
    size_t size;
    void* loader_instance;
    char settings_file[512];
    LayerNextInfo* next_info;
};

// Whether the loader that is described speaks the interface `wanted` and OpenXR 1.0.
inline bool speaks(const LoaderInfo* info, uint32_t wanted) {
    return info && info->kind == Kind::LoaderInfo && info->version == STRUCTURE &&
           info->size == sizeof(LoaderInfo) && info->least_interface <= wanted &&
           wanted <= info->most_interface && info->least_api <= XR_MAKE_VERSION(1, 0, 0xfff) &&
           XR_MAKE_VERSION(1, 0, 0) <= info->most_api;
}

}  // namespace glovetrack
