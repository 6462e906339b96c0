// Clear in the middle, denser at the rim.
in vec3 vNormal;
in vec3 vPosition;

uniform vec3 uEye;
uniform vec3 uBackward;
uniform bool uOrthographic;
uniform vec4 uColor;

out vec4 fragColor;

void main() {
    vec3 toEye = uOrthographic ? uBackward : normalize(uEye - vPosition);
    float rim = 1.0 - abs(dot(normalize(vNormal), toEye));
    fragColor = vec4(uColor.rgb, uColor.a * (0.6 + 3.0 * rim * rim * rim));
}
