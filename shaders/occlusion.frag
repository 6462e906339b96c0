// How open the surroundings of a surface are: 1 where nothing stands before them, at half the size
// of the picture. Samples lie in opposite pairs, so that a slope does not occlude itself.
uniform sampler2D uDepth;
uniform vec2 uLens;          // of the projection: rows 2 and 3 of column 2
uniform bool uOrthographic;
uniform float uPixel;        // view units of a pixel at distance 1
uniform float uReach;        // pixels

out vec4 fragColor;

const int kPairs = 8;

float distanceOf(float depth) {
    float z = 2.0 * depth - 1.0;
    return uOrthographic ? (uLens.y - z) / uLens.x : uLens.y / (z + uLens.x);
}

float distanceAt(ivec2 at) {
    ivec2 last = textureSize(uDepth, 0) - 1;
    return distanceOf(texelFetch(uDepth, clamp(at, ivec2(0), last), 0).r);
}

// Pixels by which a sample stands before the place; what is far before it belongs to another part.
float standing(float own, float sampled, float unit) {
    float before = (own - sampled) / unit;
    return max(before, -uReach) * (1.0 - smoothstep(1.0, 2.5, before / uReach));
}

void main() {
    ivec2 at = 2 * ivec2(gl_FragCoord.xy);
    float depth = texelFetch(uDepth, min(at, textureSize(uDepth, 0) - 1), 0).r;
    if (depth >= 1.0) {
        fragColor = vec4(1.0);
        return;
    }
    float own = distanceOf(depth);
    float unit = uPixel * (uOrthographic ? 1.0 : own);
    // Sixteen directions that repeat every four pixels; their average is taken in relief.frag.
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    float turn = float(cell.x * 4 + cell.y) * 0.19634954;
    float closed = 0.0;
    for (int i = 0; i < kPairs; ++i) {
        float radius = uReach * sqrt((float(i) + 0.5) / float(kPairs));
        float angle = turn + float(i) * 2.3999632;
        ivec2 way = ivec2(round(radius * vec2(cos(angle), sin(angle))));
        float both = standing(own, distanceAt(at + way), unit) +
                     standing(own, distanceAt(at - way), unit);
        closed += clamp(both / radius - 0.06, 0.0, 1.3);
    }
    fragColor = vec4(1.0 - min(closed / float(kPairs), 1.0));
}
