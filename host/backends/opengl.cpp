// Backends `glsl` and `essl`: the generated GLSL 4.50 and ESSL 3.10 as OpenGL compute shaders.
#include <map>

#include "backends/entries.h"
#include "backends/float_backend.h"
#include "backends/shader_store.h"
#include "opengl/compute.h"

namespace lacquer {

namespace {

using opengl::Api;

class OpenglBackend final : public FloatBackend {
 public:
    explicit OpenglBackend(Api api) : api_{api}, context_{api} {}

    std::string device() const override { return context_.renderer(); }

 private:
    void compile(Model model, Kernel kernel) override {
        const ShaderSource source =
            load_shader(api_ == Api::opengl ? "glsl450" : "essl310", model, kernel);
        programs_.emplace(std::pair{model, kernel}, context_.compile(source.contents));
    }

    std::optional<double> execute(const Dispatch& dispatch, std::span<glm::vec4> results) override {
        context_.run(programs_.at({dispatch.model, dispatch.kernel}),
                     kernel_arguments(dispatch, results), dispatch.workgroups());
        return std::nullopt;  // Mesa's software renderer has a clock, but it misses compute shaders
    }

    Api api_;
    opengl::Context context_;
    std::map<std::pair<Model, Kernel>, opengl::Program> programs_;
};

template <Api api>
Availability probe(const BackendOptions&) {
    return probe_by_trying([] { return opengl::Context{api}.renderer(); });
}

template <Api api>
std::unique_ptr<Backend> create(const BackendOptions&) {
    return std::make_unique<OpenglBackend>(api);
}

}  // namespace

constinit const BackendEntry kGlslEntry{"glsl", "GLSL 4.50 on OpenGL 4.5", probe<Api::opengl>,
                                        create<Api::opengl>};
constinit const BackendEntry kEsslEntry{"essl", "ESSL 3.10 on OpenGL ES 3.1", probe<Api::gles>,
                                        create<Api::gles>};

}  // namespace lacquer
