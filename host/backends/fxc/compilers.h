// Microsoft's two HLSL compilers.
#pragma once

#include <d3dcompiler.h>
#include <wrl/client.h>

#include <string>

#include "dxc_interfaces.h"

// FXC, d3dcompiler_47.dll.
class Fxc {
 public:
    // Loads the compiler from `folder`.
    explicit Fxc(const std::string& folder);

    // Compiles a compute shader of shader model 5.0 to bytecode. Throws with the compiler's
    // message.
    Microsoft::WRL::ComPtr<ID3DBlob> compile(const std::string& name, const std::string& source,
                                             const std::string& entry_point) const;

 private:
    pD3DCompile compile_;
};

// DXC, dxcompiler.dll.
class Dxc {
 public:
    explicit Dxc(const std::string& folder);

    // Compiles a compute shader of shader model 6.0 and throws the result away. Throws with the
    // compiler's message.
    void check(const std::string& source, const std::string& entry_point) const;

 private:
    Microsoft::WRL::ComPtr<IDxcCompiler3> compiler_;
};
