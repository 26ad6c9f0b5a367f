#include "compilers.h"

#include <stdexcept>

#include "check.h"

using Microsoft::WRL::ComPtr;

namespace {

constexpr UINT kUtf8 = 65001;  // DXC_CP_UTF8

constexpr GUID kDxcCompilerClass{
    0x73e22d93, 0xe6ce, 0x47f3, {0xb5, 0xbf, 0xf0, 0x66, 0x4f, 0x39, 0xc1, 0xb0}};
constexpr GUID kDxcCompiler3Id{
    0x228b4687, 0x5a6a, 0x4730, {0x90, 0x0c, 0x97, 0x02, 0xb2, 0x20, 0x3f, 0x54}};
constexpr GUID kDxcOperationResultId{
    0xcedb484a, 0xd4e9, 0x445a, {0xb9, 0x91, 0xca, 0x21, 0xca, 0x15, 0x7d, 0xc2}};

using DxcCreateInstance = HRESULT(WINAPI*)(REFCLSID, REFIID, void**);

template <typename Function>
Function load_function(const std::string& file, const char* name) {
    const HMODULE library = LoadLibraryA(file.c_str());
    if (library == nullptr) throw std::runtime_error{file + " cannot be loaded"};
    const auto function = reinterpret_cast<void*>(GetProcAddress(library, name));
    if (function == nullptr) throw std::runtime_error{file + " has no " + name};
    return reinterpret_cast<Function>(function);
}

std::string text_of(const ComPtr<ID3DBlob>& blob) {
    if (!blob) return "no message";
    return {static_cast<const char*>(blob->GetBufferPointer()), blob->GetBufferSize()};
}

}  // namespace

Fxc::Fxc(const std::string& folder)
    : compile_{load_function<pD3DCompile>(folder + "\\d3dcompiler_47.dll", "D3DCompile")} {}

ComPtr<ID3DBlob> Fxc::compile(const std::string& name, const std::string& source,
                              const std::string& entry_point) const {
    ComPtr<ID3DBlob> code, messages;
    const HRESULT result =
        compile_(source.data(), source.size(), name.c_str(), nullptr, nullptr, entry_point.c_str(),
                 "cs_5_0", D3DCOMPILE_OPTIMIZATION_LEVEL3, 0, &code, &messages);
    if (FAILED(result)) throw std::runtime_error{"FXC: " + text_of(messages)};
    return code;
}

Dxc::Dxc(const std::string& folder) {
    const auto create =
        load_function<DxcCreateInstance>(folder + "\\dxcompiler.dll", "DxcCreateInstance");
    ::check(create(kDxcCompilerClass, kDxcCompiler3Id,
                   reinterpret_cast<void**>(compiler_.GetAddressOf())),
            "DxcCreateInstance");
}

void Dxc::check(const std::string& source, const std::string& entry_point) const {
    const std::wstring entry{entry_point.begin(), entry_point.end()};
    LPCWSTR arguments[] = {L"-T", L"cs_6_0", L"-E", entry.c_str()};
    const DxcBuffer buffer{source.data(), source.size(), kUtf8};
    ComPtr<IDxcOperationResult> result;
    ::check(
        compiler_->Compile(&buffer, arguments, std::size(arguments), nullptr, kDxcOperationResultId,
                           reinterpret_cast<void**>(result.GetAddressOf())),
        "IDxcCompiler3::Compile");
    HRESULT status = S_OK;
    ::check(result->GetStatus(&status), "IDxcOperationResult::GetStatus");
    if (SUCCEEDED(status)) return;
    ComPtr<ID3DBlob> messages;
    result->GetErrorBuffer(&messages);
    throw std::runtime_error{"DXC: " + text_of(messages)};
}
