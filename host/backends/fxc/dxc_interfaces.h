// The part of dxcapi.h that is used here; MinGW has no such header. A blob of DXC's is a blob of
// Direct3D's.
#pragma once

#include <d3dcommon.h>
#include <unknwn.h>

struct DxcBuffer {
    const void* data;
    SIZE_T size;
    UINT encoding;
};

struct IDxcOperationResult : IUnknown {
    virtual HRESULT STDMETHODCALLTYPE GetStatus(HRESULT* status) = 0;
    virtual HRESULT STDMETHODCALLTYPE GetResult(ID3DBlob** result) = 0;
    virtual HRESULT STDMETHODCALLTYPE GetErrorBuffer(ID3DBlob** errors) = 0;
};

struct IDxcCompiler3 : IUnknown {
    virtual HRESULT STDMETHODCALLTYPE Compile(const DxcBuffer* source, LPCWSTR* arguments,
                                              UINT32 argument_count, IUnknown* include_handler,
                                              REFIID result_id, void** result) = 0;
};
