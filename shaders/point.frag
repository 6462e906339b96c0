// Shapes of points, by signed distance in pixels. Numbers as in draw_list.h.
in vec4 vColor;
flat in int vShape;
flat in float vSize;

uniform vec3 uHalo;  // color around marks, so that they stand out from the background

out vec4 fragColor;

float box(vec2 p, float half_) {
    vec2 d = abs(p) - half_;
    return max(d.x, d.y);
}

float triangle(vec2 p, float r) {
    // Pointing right; the corners lie on the circle of radius r.
    vec2 q = vec2(p.x, abs(p.y));
    return max(-q.x - 0.5 * r, dot(q, vec2(0.5, 0.8660254)) - 0.5 * r);
}

float segment(vec2 p, vec2 a, vec2 b) {
    vec2 ab = b - a;
    return length(p - a - ab * clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0));
}

void main() {
    float r = 0.5 * vSize - 1.0;
    vec2 p = (gl_PointCoord - 0.5) * vSize;
    p.y = -p.y;
    float stroke = max(1.0, r * 0.30);
    float d = length(p) - r;
    float coreHit = 0.0;
    if (vShape == 3) d = abs(d + 0.5 * stroke) - 0.5 * stroke;
    else if (vShape == 4) d = box(p, r * 0.82);
    else if (vShape == 5) d = abs(box(p, r * 0.82) + 0.5 * stroke) - 0.5 * stroke;
    else if (vShape == 6) d = (abs(p.x) + abs(p.y) - r) * 0.7071;
    else if (vShape == 7) d = abs((abs(p.x) + abs(p.y) - r) * 0.7071 + 0.5 * stroke) - 0.5 * stroke;
    else if (vShape == 8) {
        float ring = abs(d + r * 0.10) - r * 0.10;
        d = min(ring, length(p) - r * 0.55);
    }
    else if (vShape == 9) d = triangle(p, r);
    else if (vShape == 10) d = triangle(vec2(-p.x, p.y), r);
    else if (vShape == 11) {
        float e = r * 0.62;
        d = min(segment(p, vec2(-e, -e), vec2(e, e)), segment(p, vec2(-e, e), vec2(e, -e))) -
            max(0.8, r * 0.20);
    }
    else if (vShape == 12) {
        d = min(segment(p, vec2(-r, 0.0), vec2(r, 0.0)), segment(p, vec2(0.0, -r), vec2(0.0, r))) -
            max(0.7, r * 0.16);
    }
    float alpha = clamp(0.5 - d, 0.0, 1.0);
#ifdef HALO
    float halo = clamp(1.6 - d, 0.0, 1.0) * 0.75;
    float total = alpha + halo * (1.0 - alpha);
    if (total < 0.01) discard;
    fragColor = vec4(mix(uHalo, vColor.rgb, alpha / total), total * vColor.a);
#else
    if (alpha < 0.01) discard;
    fragColor = vec4(vColor.rgb, vColor.a * alpha);
#endif
}
