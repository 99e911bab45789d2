// Strings as drivers give them.

#include "core/gl/device_class.hpp"

#include <gtest/gtest.h>

namespace alcove::gl {

namespace {

struct Device {
    const char* vendor;
    const char* renderer;
};

void expect_all(DeviceClass expected, std::initializer_list<Device> devices) {
    for (const Device& device : devices) {
        EXPECT_EQ(to_text(classify_device(device.vendor, device.renderer)), to_text(expected))
            << device.vendor << " | " << device.renderer;
    }
}

TEST(DeviceClassTest, WhatRunsOnTheCpuIsSoftware) {
    expect_all(DeviceClass::software, {{"Mesa", "llvmpipe (LLVM 15.0.6, 256 bits)"},
                                       {"VMware, Inc.", "llvmpipe (LLVM 12.0.0, 256 bits)"},
                                       {"Mesa/X.org", "softpipe"},
                                       {"Mesa", "Software Rasterizer"},
                                       {"Google Inc.", "Google SwiftShader"},
                                       {"Microsoft Corporation", "Microsoft Basic Render Driver"},
                                       {"Apple Inc.", "Apple Software Renderer"}});
}

TEST(DeviceClassTest, WhatExecutesCountsMoreThanTheLayerAboveIt) {
    expect_all(
        DeviceClass::software,
        {{"Microsoft Corporation", "D3D12 (Microsoft Basic Render Driver)"},
         {"Mesa", "zink Vulkan 1.3(llvmpipe (LLVM 15.0.6, 256 bits) (LLVMPIPE))"},
         {"Red Hat", "virgl (LLVMPIPE (LLVM 11.0.1, 256 bits))"},
         {"Google Inc. (Google)", "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)))"}});
}

TEST(DeviceClassTest, OpenGlThroughAnotherInterfaceIsTranslated) {
    expect_all(DeviceClass::translated,
               {{"Microsoft Corporation", "D3D12 (NVIDIA GeForce RTX 3080)"},
                {"Mesa", "zink Vulkan 1.3(NVIDIA GeForce RTX 2060 (NVK_TU106))"},
                {"Google Inc. (Intel)", "ANGLE (Intel, Intel(R) UHD Graphics 630, OpenGL 4.1)"},
                {"Mesa/X.org", "virgl (AMD Radeon RX 6600 (radeonsi, navi23))"},
                {"VMware, Inc.", "SVGA3D; build: RELEASE;  LLVM;"},
                {"Apple", "Apple M1 Pro"},
                {"Apple Inc.", "Apple M2"}});
}

TEST(DeviceClassTest, ComputeCardsAreDatacentre) {
    expect_all(DeviceClass::datacentre, {{"NVIDIA Corporation", "NVIDIA A100-SXM4-40GB/PCIe/SSE2"},
                                         {"NVIDIA Corporation", "NVIDIA H100 PCIe/PCIe/SSE2"},
                                         {"NVIDIA Corporation", "NVIDIA L4/PCIe/SSE2"},
                                         {"NVIDIA Corporation", "NVIDIA L40S/PCIe/SSE2"},
                                         {"NVIDIA Corporation", "NVIDIA A10G/PCIe/SSE2"},
                                         {"NVIDIA Corporation", "Tesla T4/PCIe/SSE2"},
                                         {"AMD", "AMD Instinct MI210 (radeonsi, gfx90a)"},
                                         {"Intel", "Intel(R) Data Center GPU Flex 170"}});
}

TEST(DeviceClassTest, GpusThatShareMemoryAreIntegrated) {
    expect_all(DeviceClass::integrated,
               {{"Intel", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)"},
                {"Intel", "Mesa Intel(R) Iris(R) Xe Graphics (TGL GT2)"},
                {"Intel Open Source Technology Center", "Mesa DRI Intel(R) HD Graphics 520"},
                {"Intel", "Mesa Intel(R) Graphics (RPL-P)"},
                {"Intel", "Mesa Intel(R) Arc(tm) Graphics (MTL)"},
                {"Intel", "Intel(R) Arc(TM) 140V GPU (16GB)"},
                {"AMD", "AMD Radeon Graphics (radeonsi, renoir, LLVM 15.0.6, DRM 3.49)"},
                {"ATI Technologies Inc.", "AMD Radeon(TM) Graphics"},
                {"AMD", "AMD Radeon Vega 8 Graphics (radeonsi, raven, LLVM 15.0.6)"},
                {"AMD", "AMD Radeon(TM) RX Vega 11 Graphics"},
                {"AMD", "AMD Radeon 780M (radeonsi, gfx1103_r1, LLVM 17.0.6)"},
                {"AMD", "AMD Custom GPU 0405 (radeonsi, vangogh)"},
                {"Mesa", "Apple M1 (G13G B1)"},
                {"ARM", "Mali-G78"},
                {"Panfrost", "Mali-G52 r1 (Panfrost)"},
                {"Qualcomm", "Adreno (TM) 740"},
                {"NVIDIA Corporation", "NVIDIA Tegra Orin (nvgpu)/integrated"}});
}

TEST(DeviceClassTest, CardsAreDiscrete) {
    expect_all(DeviceClass::discrete,
               {{"NVIDIA Corporation", "NVIDIA GeForce RTX 3080/PCIe/SSE2"},
                {"NVIDIA Corporation", "GeForce GTX 1080 Ti/PCIe/SSE2"},
                {"NVIDIA Corporation", "Quadro P400/PCIe/SSE2"},
                {"NVIDIA Corporation", "NVIDIA RTX A4000/PCIe/SSE2"},
                {"NVIDIA Corporation", "NVIDIA T1000/PCIe/SSE2"},
                {"AMD", "AMD Radeon RX 6800 XT (radeonsi, navi21, LLVM 15.0.6, DRM 3.54)"},
                {"AMD", "AMD Radeon RX Vega 64 (radeonsi, vega10, LLVM 15.0.6)"},
                {"AMD", "AMD Radeon Pro W6800 (radeonsi, navi21)"},
                {"AMD", "AMD Radeon VII (radeonsi, vega20)"},
                {"AMD", "AMD Radeon (TM) R9 390 Series"},
                {"Intel", "Mesa Intel(R) Arc(tm) A770 Graphics (DG2)"},
                {"Intel", "Mesa Intel(R) Arc(tm) Pro A40 Graphics (DG2)"},
                {"Intel", "Intel(R) Arc(TM) B580 Graphics"},
                {"Intel", "Intel(R) Iris(R) Xe MAX Graphics"}});
}

TEST(DeviceClassTest, UnknownNamesAreNotGuessed) {
    expect_all(DeviceClass::unclassified, {{"", ""},
                                           {"Mesa", "NV167"},
                                           {"Some Vendor", "Graphics Processor 9000"},
                                           {"Some Vendor", "llvmpiper"}, // whole words only
                                           {"Other Vendor", "H100"}});
}

TEST(DeviceClassTest, EveryClassHasItsWord) {
    EXPECT_EQ(to_text(DeviceClass::software), "software");
    EXPECT_EQ(to_text(DeviceClass::integrated), "integrated");
    EXPECT_EQ(to_text(DeviceClass::discrete), "discrete");
    EXPECT_EQ(to_text(DeviceClass::datacentre), "datacentre");
    EXPECT_EQ(to_text(DeviceClass::translated), "translated");
    EXPECT_EQ(to_text(DeviceClass::unclassified), "unclassified");
}

} // namespace
} // namespace alcove::gl
