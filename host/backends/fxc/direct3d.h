// Compute shaders on Direct3D 11.
#pragma once

#include <d3d11.h>
#include <wrl/client.h>

#include <vector>

#include "messages.h"

// One buffer of a dispatch; its place in a list is its register (b, t or u).
struct KernelBuffer {
    enum class Kind { uniform, read, write };

    Kind kind;
    std::size_t size;
    Bytes bytes;  // what the kernel is given; empty for results
};

// Everything throws with the call and its result.
class Direct3d {
 public:
    Direct3d();

    Microsoft::WRL::ComPtr<ID3D11ComputeShader> create_shader(ID3DBlob* code) const;

    // Runs the shader and returns what it wrote to its writable buffer.
    Bytes run(ID3D11ComputeShader* shader, const std::vector<KernelBuffer>& buffers, UINT groups);

 private:
    // A buffer for one register that grows as needed, and its view.
    struct Slot {
        Microsoft::WRL::ComPtr<ID3D11Buffer> buffer;
        Microsoft::WRL::ComPtr<ID3D11ShaderResourceView> read_view;
        Microsoft::WRL::ComPtr<ID3D11UnorderedAccessView> write_view;
        std::size_t capacity = 0;
    };

    void reserve(Slot& slot, const KernelBuffer& buffer);
    void upload(const Slot& slot, const KernelBuffer& buffer);
    void bind(UINT index, const Slot& slot, KernelBuffer::Kind kind);
    Bytes download(const Slot& slot, std::size_t size);

    Microsoft::WRL::ComPtr<ID3D11Device> device_;
    Microsoft::WRL::ComPtr<ID3D11DeviceContext> context_;
    std::vector<Slot> slots_;
};
