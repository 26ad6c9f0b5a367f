// Compiles HLSL with Microsoft's compilers and runs it on Direct3D 11 for the program that started
// it, like host/backends/webgpu/runner.mjs and by the same messages. A Windows program, for Wine.
// Usage: lacquer-fxc.exe FOLDER, where d3dcompiler_47.dll and dxcompiler.dll are.
#include <cstdio>
#include <exception>
#include <map>

#include "compilers.h"
#include "direct3d.h"
#include "messages.h"

namespace {

using Microsoft::WRL::ComPtr;
using nlohmann::json;

class Runner {
 public:
    explicit Runner(const std::string& folder) : fxc_{folder}, dxc_{folder} {
        write_answer({{"adapter", "FXC, Direct3D 11 on Wine"}});
    }

    void answer(const json& request) {
        const std::string operation = request.at("operation");
        if (operation == "compile") {
            const auto code =
                fxc_.compile(request.at("kernel"), request.at("source"), request.at("entry_point"));
            shaders_[request.at("kernel")] = direct3d_.create_shader(code.Get());
            write_answer(json::object());
        } else if (operation == "check") {
            dxc_.check(request.at("source"), request.at("entry_point"));
            write_answer(json::object());
        } else {
            const std::vector<KernelBuffer> buffers = read_buffers(request.at("buffers"));
            const Bytes results = direct3d_.run(shaders_.at(request.at("kernel")).Get(), buffers,
                                                request.at("groups"));
            write_answer({{"size", results.size()}}, results);
        }
    }

 private:
    static std::vector<KernelBuffer> read_buffers(const json& list) {
        using Kind = KernelBuffer::Kind;
        std::vector<KernelBuffer> buffers;
        for (const json& entry : list) {
            const std::string kind = entry.at("kind");
            const std::size_t size = entry.at("size");
            if (kind == "write")
                buffers.push_back({Kind::write, size, {}});
            else
                buffers.push_back(
                    {kind == "uniform" ? Kind::uniform : Kind::read, size, read_bytes(size)});
        }
        return buffers;
    }

    Fxc fxc_;
    Dxc dxc_;
    Direct3d direct3d_;
    std::map<std::string, ComPtr<ID3D11ComputeShader>> shaders_;
};

}  // namespace

int main(int argc, char** argv) {
    use_binary_streams();
    try {
        if (argc != 2) throw std::runtime_error{"usage: lacquer-fxc.exe FOLDER"};
        Runner runner{argv[1]};
        while (const auto request = read_request()) {
            try {
                runner.answer(*request);
            } catch (const std::exception& error) {
                write_answer({{"error", error.what()}});
            }
        }
    } catch (const std::exception& error) {
        write_answer({{"error", error.what()}});
        return 1;
    }
}
