#include "direct3d.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "check.h"

using Microsoft::WRL::ComPtr;

namespace {

constexpr std::size_t kSmallestCapacity = 256;
constexpr UINT kWordSize = 4;  // raw views count 32-bit words

D3D11_BUFFER_DESC description_of(KernelBuffer::Kind kind, std::size_t capacity) {
    D3D11_BUFFER_DESC description{};
    description.ByteWidth = static_cast<UINT>(capacity);
    if (kind == KernelBuffer::Kind::uniform) {
        description.BindFlags = D3D11_BIND_CONSTANT_BUFFER;
        return description;
    }
    description.BindFlags =
        kind == KernelBuffer::Kind::read ? D3D11_BIND_SHADER_RESOURCE : D3D11_BIND_UNORDERED_ACCESS;
    description.MiscFlags = D3D11_RESOURCE_MISC_BUFFER_ALLOW_RAW_VIEWS;
    return description;
}

}  // namespace

Direct3d::Direct3d() {
    const D3D_FEATURE_LEVEL level = D3D_FEATURE_LEVEL_11_0;
    check(D3D11CreateDevice(nullptr, D3D_DRIVER_TYPE_HARDWARE, nullptr, 0, &level, 1,
                            D3D11_SDK_VERSION, &device_, nullptr, &context_),
          "D3D11CreateDevice");
}

ComPtr<ID3D11ComputeShader> Direct3d::create_shader(ID3DBlob* code) const {
    ComPtr<ID3D11ComputeShader> shader;
    check(device_->CreateComputeShader(code->GetBufferPointer(), code->GetBufferSize(), nullptr,
                                       &shader),
          "ID3D11Device::CreateComputeShader");
    return shader;
}

void Direct3d::reserve(Slot& slot, const KernelBuffer& buffer) {
    // Constant buffers are written whole, so that theirs has exactly the size.
    const bool fits = buffer.kind == KernelBuffer::Kind::uniform ? slot.capacity == buffer.size
                                                                 : slot.capacity >= buffer.size;
    if (fits) return;
    slot = {};
    slot.capacity = buffer.kind == KernelBuffer::Kind::uniform
                        ? buffer.size
                        : std::bit_ceil(std::max(buffer.size, kSmallestCapacity));
    const D3D11_BUFFER_DESC description = description_of(buffer.kind, slot.capacity);
    check(device_->CreateBuffer(&description, nullptr, &slot.buffer), "ID3D11Device::CreateBuffer");
    const UINT words = static_cast<UINT>(slot.capacity) / kWordSize;
    if (buffer.kind == KernelBuffer::Kind::read) {
        D3D11_SHADER_RESOURCE_VIEW_DESC view{};
        view.Format = DXGI_FORMAT_R32_TYPELESS;
        view.ViewDimension = D3D11_SRV_DIMENSION_BUFFEREX;
        view.BufferEx = {0, words, D3D11_BUFFEREX_SRV_FLAG_RAW};
        check(device_->CreateShaderResourceView(slot.buffer.Get(), &view, &slot.read_view),
              "ID3D11Device::CreateShaderResourceView");
    }
    if (buffer.kind == KernelBuffer::Kind::write) {
        D3D11_UNORDERED_ACCESS_VIEW_DESC view{};
        view.Format = DXGI_FORMAT_R32_TYPELESS;
        view.ViewDimension = D3D11_UAV_DIMENSION_BUFFER;
        view.Buffer = {0, words, D3D11_BUFFER_UAV_FLAG_RAW};
        check(device_->CreateUnorderedAccessView(slot.buffer.Get(), &view, &slot.write_view),
              "ID3D11Device::CreateUnorderedAccessView");
    }
}

void Direct3d::upload(const Slot& slot, const KernelBuffer& buffer) {
    if (buffer.kind == KernelBuffer::Kind::write) return;
    const D3D11_BOX box{0, 0, 0, static_cast<UINT>(buffer.size), 1, 1};
    const bool whole = buffer.size == slot.capacity;
    context_->UpdateSubresource(slot.buffer.Get(), 0, whole ? nullptr : &box, buffer.bytes.data(),
                                0, 0);
}

void Direct3d::bind(UINT index, const Slot& slot, KernelBuffer::Kind kind) {
    switch (kind) {
        case KernelBuffer::Kind::uniform:
            context_->CSSetConstantBuffers(index, 1, slot.buffer.GetAddressOf());
            break;
        case KernelBuffer::Kind::read:
            context_->CSSetShaderResources(index, 1, slot.read_view.GetAddressOf());
            break;
        case KernelBuffer::Kind::write:
            context_->CSSetUnorderedAccessViews(index, 1, slot.write_view.GetAddressOf(), nullptr);
            break;
    }
}

Bytes Direct3d::download(const Slot& slot, std::size_t size) {
    D3D11_BUFFER_DESC description{};
    description.ByteWidth = static_cast<UINT>(size);
    description.Usage = D3D11_USAGE_STAGING;
    description.CPUAccessFlags = D3D11_CPU_ACCESS_READ;
    ComPtr<ID3D11Buffer> staging;
    check(device_->CreateBuffer(&description, nullptr, &staging), "ID3D11Device::CreateBuffer");
    const D3D11_BOX box{0, 0, 0, static_cast<UINT>(size), 1, 1};
    context_->CopySubresourceRegion(staging.Get(), 0, 0, 0, 0, slot.buffer.Get(), 0, &box);
    D3D11_MAPPED_SUBRESOURCE mapped{};
    check(context_->Map(staging.Get(), 0, D3D11_MAP_READ, 0, &mapped), "ID3D11DeviceContext::Map");
    Bytes bytes(size);
    std::memcpy(bytes.data(), mapped.pData, size);
    context_->Unmap(staging.Get(), 0);
    return bytes;
}

Bytes Direct3d::run(ID3D11ComputeShader* shader, const std::vector<KernelBuffer>& buffers,
                    UINT groups) {
    slots_.resize(std::max(slots_.size(), buffers.size()));
    context_->CSSetShader(shader, nullptr, 0);
    for (UINT index = 0; index < buffers.size(); ++index) {
        reserve(slots_[index], buffers[index]);
        upload(slots_[index], buffers[index]);
        bind(index, slots_[index], buffers[index].kind);
    }
    context_->Dispatch(groups, 1, 1);
    const auto results = std::ranges::find(buffers, KernelBuffer::Kind::write, &KernelBuffer::kind);
    if (results == buffers.end()) throw std::runtime_error{"no buffer to write results to"};
    return download(slots_[static_cast<std::size_t>(results - buffers.begin())], results->size);
}
