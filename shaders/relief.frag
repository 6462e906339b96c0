// Darkens what lies lower than the pixels on both sides of it, most of all beside an outline.
uniform sampler2D uDepth;
uniform sampler2D uColor;
uniform sampler2D uOcclusion;
uniform vec2 uLens;          // of the projection: rows 2 and 3 of column 2
uniform bool uOrthographic;
uniform float uPixel;        // view units of a pixel at distance 1
uniform int uStep;           // pixels to the neighbors

out vec4 fragColor;

const float kMost = 8.0;     // pixels of depth, beyond which all is an outline
const float kOutline = 0.55;
const float kOcclusion = 0.62;

float distanceAt(ivec2 at) {
    float z = 2.0 * texelFetch(uDepth, clamp(at, ivec2(0), textureSize(uDepth, 0) - 1), 0).r - 1.0;
    return uOrthographic ? (uLens.y - z) / uLens.x : uLens.y / (z + uLens.x);
}

float valley(ivec2 at, ivec2 way, float own, float unit) {
    float a = clamp((own - distanceAt(at + way)) / unit, -kMost, kMost);
    float b = clamp((own - distanceAt(at - way)) / unit, -kMost, kMost);
    return clamp((a + b) / kMost, 0.0, 1.0);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 color = texelFetch(uColor, at, 0);
    float own = distanceAt(at);
    float unit = uPixel * (uOrthographic ? 1.0 : own) * float(uStep);
#ifdef QUICK
    // Outlines alone, from what is known without neighbors.
    float shade = 1.0 - kOutline * clamp(fwidth(own) / (unit * kMost) - 0.5, 0.0, 1.0);
#else
    float low = valley(at, ivec2(uStep, 0), own, unit) + valley(at, ivec2(0, uStep), own, unit) +
                valley(at, ivec2(uStep, uStep), own, unit) +
                valley(at, ivec2(uStep, -uStep), own, unit);
    float shade = 1.0 - kOutline * min(0.5 * low, 1.0);
    if (texelFetch(uDepth, at, 0).r < 1.0) {
        vec2 texel = 1.0 / vec2(textureSize(uOcclusion, 0));
        vec2 place = 0.5 * gl_FragCoord.xy * texel;
        float open = texture(uOcclusion, place + texel).r + texture(uOcclusion, place - texel).r +
                     texture(uOcclusion, place + texel * vec2(1.0, -1.0)).r +
                     texture(uOcclusion, place + texel * vec2(-1.0, 1.0)).r;
        shade *= 1.0 - kOcclusion * (1.0 - 0.25 * open);
    }
#endif
    fragColor = vec4(color.rgb * shade, color.a);
}
