// Round ends, dashes that fit the length, and an arrow head at the middle.
in vec4 vColor;
in vec2 vPlace;
flat in float vLength;
flat in vec3 vWidthDashArrow;

uniform float uAlpha;
uniform float uGap;
uniform float uHiddenDash;  // pixels: dashes of hidden lines; 0 for visible ones

out vec4 fragColor;

float capsule(vec2 p, float from, float to, float radius) {
    float x = p.x - clamp(p.x, from, to);
    return length(vec2(x, p.y)) - radius;
}

void main() {
    float radius = 0.5 * vWidthDashArrow.x;
    float dash = max(vWidthDashArrow.y, uHiddenDash);
    float d;
    if (dash > 0.0 && vLength > 1.5 * dash) {
        // Half a dash at either end, so that lines in a row join well.
        float periods = max(1.0, floor(vLength / (2.0 * dash) + 0.5));
        float period = vLength / periods;
        float x = vPlace.x - period * floor(vPlace.x / period + 0.5);
        d = max(length(vec2(max(abs(x) - 0.25 * period, 0.0), vPlace.y)) - radius,
                max(-vPlace.x, vPlace.x - vLength) - radius);
    } else {
        d = capsule(vPlace, 0.0, vLength, radius);
    }
    float arrow = vWidthDashArrow.z;
    if (arrow > 0.0 && vLength > 1.1 * arrow) {
        vec2 p = vec2(vPlace.x - 0.5 * vLength, abs(vPlace.y));
        float tip = 0.5 * arrow;
        d = min(d, max(-p.x - 0.42 * arrow, dot(p - vec2(tip, 0.0), normalize(vec2(0.5, 0.95)))));
    }
    if (uGap > 0.0) {
        // Only beside the line: lines that meet at its ends are not cut.
        if (d > uGap || vPlace.x < 0.0 || vPlace.x > vLength || vColor.a < 0.2) discard;
        fragColor = vec4(0.0);
        return;
    }
    float alpha = clamp(0.5 - d, 0.0, 1.0) * vColor.a * uAlpha;
    if (alpha < 0.01) discard;
    fragColor = vec4(vColor.rgb, alpha);
}
