// Points of the input. Position and normal are uploaded once; the style byte picks color, size and
// shape from small tables.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in uint aStyle;

uniform mat4 uView;
uniform mat4 uProjection;
uniform vec3 uEye;
uniform vec3 uBackward;  // from the scene to the eye, if orthographic
uniform bool uOrthographic;
uniform float uBias;     // view units toward the eye, so that points are not half inside triangles
uniform vec4 uStyleColor[80];
uniform vec2 uStyleSizeShape[80];  // pixels; shape number

#ifdef SOLID
uniform vec3 uBackground;
#endif

out vec4 vColor;
flat out int vShape;
flat out float vSize;

void main() {
    vec2 style = uStyleSizeShape[aStyle];
    vec3 toEye = uOrthographic ? uBackward : normalize(uEye - aPosition);
    gl_Position = uProjection * (uView * vec4(aPosition + toEye * uBias, 1.0));
    // Points on the far side of the surface step back.
    float facing = dot(toEye, aNormal);
    float fade = mix(0.30, 1.0, smoothstep(-0.25, 0.15, facing));
    vColor = vec4(uStyleColor[aStyle].rgb, uStyleColor[aStyle].a * fade);
    vShape = int(style.y);
#ifdef SOLID
    // Opaque, so that depth tells them apart; too small for shapes. Lit as the mesh is.
    vec3 key = normalize(0.75 * toEye + 0.75 * vec3(uView[0][1], uView[1][1], uView[2][1]) -
                         0.65 * vec3(uView[0][0], uView[1][0], uView[2][0]));
    float shade = 0.62 + 0.38 * max(dot(facing < 0.0 ? -aNormal : aNormal, key), 0.0);
    vColor = vec4(mix(uBackground, vColor.rgb * shade, 0.70 * vColor.a), 1.0);
    if (vShape != 0) vShape = 2;
#endif
    vSize = style.x + 2.0;
    gl_PointSize = vSize;
    if (style.y < 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
