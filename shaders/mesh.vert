// Triangles, three vertices each, not indexed: the corner is the vertex number modulo 3.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aColor;
layout(location = 2) in float aHatched;

uniform mat4 uView;
uniform mat4 uProjection;

out vec3 vPosition;
out vec3 vBarycentric;
out vec4 vColor;
flat out float vHatched;

void main() {
    vPosition = aPosition;
    int corner = gl_VertexID % 3;
    vBarycentric = vec3(corner == 0, corner == 1, corner == 2);
    vColor = aColor;
    vHatched = aHatched;
    gl_Position = uProjection * (uView * vec4(aPosition, 1.0));
}
