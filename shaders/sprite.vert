// Single marked points: one instance each, a quad that always faces the eye.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aColor;
layout(location = 2) in vec2 aSizeShape;  // pixels; shape number

uniform mat4 uView;
uniform mat4 uProjection;

out vec4 vColor;
flat out int vShape;
flat out float vSize;

void main() {
    gl_Position = uProjection * (uView * vec4(aPosition, 1.0));
    vColor = aColor;
    vShape = int(aSizeShape.y);
    vSize = aSizeShape.x + 2.0;
    gl_PointSize = vSize;
}
