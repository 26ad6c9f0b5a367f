#include "heightfield/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "core/error.h"

namespace lacquer::heightfield {

namespace {

// One thread builds: several would order equals by chance, and a ray along an edge could meet
// either of its facets.
constexpr const char* kDeviceOptions = "threads=1";

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

[[noreturn]] void fail(RTCDevice device) {
    throw Error{fmt::format("ray tracing a heightfield: Embree failed with code {}",
                            static_cast<int>(rtcGetDeviceError(device)))};
}

// What the filter knows of the ray; Embree passes a pointer to its first member.
struct Query {
    RTCIntersectContext embree;
    glm::dvec3 direction;
    bool below;
};

void refuse_far_sides(const RTCFilterFunctionNArguments* arguments) {
    const auto& mesh = *static_cast<const FacetMesh*>(arguments->geometryUserPtr);
    const auto& query = *reinterpret_cast<const Query*>(arguments->context);
    const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const double cosine = glm::dot(query.direction, mesh.facets[triangle].normal);
    if (query.below ? cosine <= 0.0 : cosine >= 0.0) arguments->valid[0] = 0;
}

void* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride,
             std::size_t count, RTCDevice device) {
    void* memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
    if (memory == nullptr) fail(device);
    return memory;
}

void add_triangles(RTCDevice device, RTCScene scene, FacetMesh& mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                                3 * sizeof(float), mesh.vertices.size(), device));
    for (const glm::dvec3& vertex : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(vertex[axis]);
    auto* corners = static_cast<std::uint32_t*>(buffer(geometry, RTC_BUFFER_TYPE_INDEX,
                                                       RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                                                       mesh.triangles.size(), device));
    for (const auto& triangle : mesh.triangles)
        corners = std::copy(triangle.begin(), triangle.end(), corners);
    rtcSetGeometryUserData(geometry, &mesh);
    rtcSetGeometryIntersectFilterFunction(geometry, refuse_far_sides);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

}  // namespace

struct RayScene::State {
    FacetMesh mesh;
    Device device;
    Scene scene;
};

RayScene::RayScene(FacetMesh mesh) : state_{std::make_unique<State>()} {
    state_->mesh = std::move(mesh);
    state_->device.reset(rtcNewDevice(kDeviceOptions));
    if (!state_->device) fail(nullptr);
    const RTCDevice device = state_->device.get();
    state_->scene.reset(rtcNewScene(device));
    // No ray slips through where facets join.
    rtcSetSceneFlags(state_->scene.get(), RTC_SCENE_FLAG_ROBUST);
    add_triangles(device, state_->scene.get(), state_->mesh);
    rtcCommitScene(state_->scene.get());
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail(device);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

const FacetMesh& RayScene::mesh() const {
    return state_->mesh;
}

std::optional<RayHit> RayScene::first_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                          double distance, bool below) const {
    Query query{{}, direction, below};
    rtcInitIntersectContext(&query.embree);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(origin.x);
    ray.ray.org_y = static_cast<float>(origin.y);
    ray.ray.org_z = static_cast<float>(origin.z);
    ray.ray.dir_x = static_cast<float>(direction.x);
    ray.ray.dir_y = static_cast<float>(direction.y);
    ray.ray.dir_z = static_cast<float>(direction.z);
    ray.ray.tfar = static_cast<float>(distance);
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->scene.get(), &query.embree, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const FacetMesh& mesh = state_->mesh;
    const auto& [a, b, c] = mesh.triangles[ray.hit.primID];
    const double u = ray.hit.u, v = ray.hit.v;
    return RayHit{ray.hit.primID,
                  (1.0 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] + v * mesh.vertices[c]};
}

}  // namespace lacquer::heightfield
