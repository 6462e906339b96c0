// Triangles, three vertices each, not indexed: the corner is the vertex number modulo 3.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aColor;
layout(location = 2) in float aHatched;
layout(location = 3) in vec3 aNormal;  // of the point; none for new triangles

uniform mat4 uView;
uniform mat4 uProjection;
uniform bool uByCreation;    // color by the number of the triangle
uniform float uCreationEnd;  // the number at the end of the scale
uniform vec4 uScale[9];

out vec3 vPosition;
out vec3 vBarycentric;
out vec3 vNormal;
out vec4 vColor;
flat out float vHatched;

void main() {
    vPosition = aPosition;
    int corner = gl_VertexID % 3;
    vBarycentric = vec3(corner == 0, corner == 1, corner == 2);
    vNormal = aNormal;
    vColor = aColor;
    if (uByCreation) {
        float place = clamp((float(gl_VertexID / 3) + 0.5) / uCreationEnd, 0.0, 1.0) * 8.0;
        int low = min(int(place), 7);
        vColor = mix(uScale[low], uScale[low + 1], place - float(low));
    }
    vHatched = aHatched;
    gl_Position = uProjection * (uView * vec4(aPosition, 1.0));
}
