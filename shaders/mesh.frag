// Flat lit triangles with thin edges; back faces are darker, to show the orientation.
in vec3 vPosition;
in vec3 vBarycentric;
in vec3 vNormal;
in vec4 vColor;
flat in float vHatched;

uniform vec3 uEye;
uniform vec3 uBackward;
uniform bool uOrthographic;
uniform vec3 uRight;
uniform vec3 uUp;
uniform vec4 uEdgeColor;  // alpha 0: no edges
uniform float uEdgeWidth; // pixels
uniform float uHatch;     // pixels between stripes
uniform vec2 uCorner;     // of a part of a larger picture, in pixels
uniform bool uLit;
uniform float uSpacing;    // median distance of the points
uniform float uPixel;      // size of a pixel, at distance 1 in perspective
uniform float uSmooth;     // 1: light by the normals of the points
uniform bool uWire;        // edges only
uniform float uSoft;       // 1: no shade at all

uniform vec4 uGhost;       // sphere of a decision; what hides it is left out; radius 0: none
uniform bool uGhostsOnly;  // what hides it alone, faintly

out vec4 fragColor;

// 1 in front of the sphere, as seen from the eye, and outside of it.
float hiding() {
    vec3 offset = vPosition - uGhost.xyz;
    vec3 toEye = uOrthographic ? uBackward : uEye - uGhost.xyz;
    float distance = uOrthographic ? 1.0 : length(toEye);
    toEye /= length(toEye);
    float front = dot(offset, toEye);
    // Lines of sight come together at the eye.
    float narrow = uOrthographic ? 1.0 : max(1.0 - front / distance, 0.01);
    float beside = length(offset - front * toEye) / narrow;
    float outside = smoothstep(0.9, 1.0, length(offset) / uGhost.w);
    return front > 0.0 ? outside * (1.0 - smoothstep(1.0, 1.08, beside / uGhost.w)) : 0.0;
}

// Pixels of the least height of the triangle.
float heightOf() {
    vec3 width = max(fwidth(vBarycentric), 1e-6);
    return 1.0 / max(width.x, max(width.y, width.z));
}

// Of the triangle from near, of the points from afar, where triangles are smaller than a few
// pixels; toward the eye.
vec3 normalOf(vec3 toEye) {
    vec3 flatOne = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    if (dot(flatOne, toEye) < 0.0) flatOne = -flatOne;
    if (dot(vNormal, vNormal) < 0.01) return flatOne;
    vec3 smoothOne = normalize(vNormal);
    if (dot(smoothOne, flatOne) < 0.0) smoothOne = -smoothOne;
    float share = max(uSmooth, 1.0 - smoothstep(5.0, 16.0, heightOf()));
    vec3 normal = mix(flatOne, smoothOne, share);
    return dot(normal, normal) > 1e-4 ? normalize(normal) : flatOne;
}

// A light from the upper left, sky and ground, a weak light from the eye, and a soft gloss.
float shadeOf() {
    vec3 toEye = uOrthographic ? uBackward : normalize(uEye - vPosition);
    vec3 normal = normalOf(toEye);
    vec3 key = normalize(0.75 * toEye + 0.75 * uUp - 0.65 * uRight);
    float lit = max((dot(normal, key) + 0.15) / 1.15, 0.0);
    float sky = 0.5 + 0.5 * dot(normal, uUp);
    float gloss = pow(max(dot(normal, normalize(key + toEye)), 0.0), 30.0);
    float shade = 0.30 + 0.14 * sky + 0.12 * max(dot(normal, toEye), 0.0) + 0.45 * lit;
    shade += 0.07 * gloss;
    // The back of a surface is darker, to show the orientation.
    return gl_FrontFacing ? shade : 0.6 * shade;
}

// Edges fade by the density of points on the screen, alike for neighbors, so that no triangle
// stands alone with its outline; and within triangles of a few pixels, which would be all edge.
float edgeStrength() {
    float away = uOrthographic ? 1.0 : max(dot(uEye - vPosition, uBackward), 1e-6);
    float apart = uSpacing / (uPixel * away * uEdgeWidth);
    return smoothstep(6.0, 18.0, apart) * smoothstep(1.5, 5.0, heightOf());
}

void main() {
    vec4 color = vColor;
    if (uLit) {
        color.rgb *= mix(shadeOf(), 1.0, uSoft);
    }
    if (vHatched > 0.5) {
        vec2 at = gl_FragCoord.xy + uCorner;
        float stripe = abs(fract((at.x + at.y) / uHatch) - 0.5) * uHatch;
        float between = clamp(stripe - 0.22 * uHatch + 0.5, 0.0, 1.0);
        // Transparent triangles are clearer between the stripes, all others darker.
        if (uLit) color.rgb *= mix(1.0, 0.72, between);
        else color.a *= mix(1.0, 0.35, between);
    }
    float drawnEdge = 0.0;
    if (uEdgeColor.a > 0.0) {
        vec3 width = max(fwidth(vBarycentric), 1e-6);
        vec3 distance = vBarycentric / width;
        float nearest = min(distance.x, min(distance.y, distance.z));
        float strength = uWire ? 1.0 : edgeStrength();
        float edge = 1.0 - smoothstep(0.5 * uEdgeWidth - 0.5, 0.5 * uEdgeWidth + 0.5, nearest);
        if (uWire && edge < 0.3) discard;
        drawnEdge = edge * strength;
        color.rgb = mix(color.rgb, uEdgeColor.rgb, drawnEdge * uEdgeColor.a);
    }
    if (uGhost.w > 0.0) {
        float faint = hiding();
        if ((faint > 0.5) != uGhostsOnly) discard;
        // An edge stays visible where its triangles fade.
        if (uGhostsOnly) color.a *= mix(1.0, 0.2 + 0.35 * drawnEdge, faint);
    }
    fragColor = color;
}
