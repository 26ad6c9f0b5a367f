// One triangle that covers the picture; draw three vertices.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"

layout(location = 0) out vec2 view_position;

// Declared anew without the built-in outputs that are not used.
out gl_PerVertex {
    vec4 gl_Position;
};

void main() {
    const vec2 corner = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    view_position = vec2(corner.x * view.half_extent.x, -corner.y * view.half_extent.y);
    gl_Position = vec4(corner, 0.0, 1.0);
}
