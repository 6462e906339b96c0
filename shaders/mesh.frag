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
uniform bool uLit;
uniform bool uSmooth;      // light by the normals of the points
uniform bool uWire;        // edges only
uniform float uSoft;       // 1: no shade at all

uniform vec4 uGhost;       // sphere of a decision; what hides it is drawn faintly; radius 0: none

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

void main() {
    vec4 color = vColor;
    if (uLit) {
        vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
        vec3 toEye = uOrthographic ? uBackward : normalize(uEye - vPosition);
        if (uSmooth && dot(vNormal, vNormal) > 0.01) normal = normalize(vNormal);
        if (dot(normal, toEye) < 0.0) normal = -normal;
        // A light over the left shoulder, and a weak one from the eye.
        vec3 light = normalize(toEye + 0.7 * uUp - 0.6 * uRight);
        float shade = 0.48 + 0.42 * max(dot(normal, light), 0.0) + 0.16 * dot(normal, toEye);
        if (!gl_FrontFacing) shade *= 0.55;
        color.rgb *= mix(shade, 1.0, uSoft);
    }
    if (vHatched > 0.5) {
        float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / uHatch) - 0.5) * uHatch;
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
        // Triangles of a few pixels would be all edge.
        float height = 1.0 / max(width.x, max(width.y, width.z));
        float strength = uWire ? 1.0 : smoothstep(3.0, 12.0, height);
        float edge = 1.0 - smoothstep(0.5 * uEdgeWidth - 0.5, 0.5 * uEdgeWidth + 0.5, nearest);
        if (uWire && edge < 0.3) discard;
        drawnEdge = edge * strength;
        color.rgb = mix(color.rgb, uEdgeColor.rgb, drawnEdge * uEdgeColor.a);
    }
    // An edge stays visible where its triangles fade.
    float faint = uGhost.w > 0.0 ? hiding() : 0.0;
    color.a *= mix(1.0, 0.2 + 0.35 * drawnEdge, faint);
    fragColor = color;
}
