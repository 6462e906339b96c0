// Lines as quads in screen space: one instance per line, six vertices.
layout(location = 0) in vec3 aFrom;
layout(location = 1) in vec3 aTo;
layout(location = 2) in vec4 aColor;
layout(location = 3) in vec3 aWidthDashArrow;  // pixels

uniform mat4 uView;
uniform mat4 uProjection;
uniform vec2 uViewport;  // pixels
uniform vec3 uEye;
uniform vec3 uBackward;
uniform bool uOrthographic;
uniform float uBias;
uniform float uGap;  // pixels; more than 0: the halo around the line

out vec4 vColor;
out vec2 vPlace;          // pixels along and across the line, from its start
flat out float vLength;   // pixels
flat out vec3 vWidthDashArrow;

vec4 clipPosition(vec3 at) {
    vec3 toEye = uOrthographic ? uBackward : normalize(uEye - at);
    return uProjection * (uView * vec4(at + toEye * uBias, 1.0));
}

void main() {
    vec4 a = clipPosition(aFrom);
    vec4 b = clipPosition(aTo);
    // Cut off the part behind the eye, where no direction on the screen exists.
    const float nearest = 1e-4;
    if (a.w < nearest && b.w < nearest) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (a.w < nearest) a = mix(a, b, (nearest - a.w) / (b.w - a.w));
    if (b.w < nearest) b = mix(b, a, (nearest - b.w) / (a.w - b.w));
    vec2 pa = a.xy / a.w * 0.5 * uViewport;
    vec2 pb = b.xy / b.w * 0.5 * uViewport;
    vec2 along = pb - pa;
    vLength = length(along);
    along = vLength > 1e-3 ? along / vLength : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);

    float reach = 0.5 * max(aWidthDashArrow.x, aWidthDashArrow.z) + 1.5 + uGap;
    int corner = gl_VertexID % 6;
    bool atEnd = corner == 1 || corner == 2 || corner == 4;
    float side = (corner == 0 || corner == 1 || corner == 3) ? -1.0 : 1.0;
    vec2 pixel = (atEnd ? pb + along * reach : pa - along * reach) + across * side * reach;
    vPlace = vec2(atEnd ? vLength + reach : -reach, side * reach);
    vec4 end = atEnd ? b : a;
    gl_Position = vec4(pixel / (0.5 * uViewport) * end.w, end.z, end.w);
    // Perspective must not bend the pixel coordinates.
    gl_Position /= gl_Position.w;
    vColor = aColor;
    vWidthDashArrow = aWidthDashArrow;
}
