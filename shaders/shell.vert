// The sphere of a test: a unit sphere, moved and scaled.
layout(location = 0) in vec3 aPosition;

uniform mat4 uView;
uniform mat4 uProjection;
uniform vec3 uCenter;
uniform float uRadius;

out vec3 vNormal;
out vec3 vPosition;

void main() {
    vNormal = aPosition;
    vPosition = uCenter + aPosition * uRadius;
    gl_Position = uProjection * (uView * vec4(vPosition, 1.0));
}
