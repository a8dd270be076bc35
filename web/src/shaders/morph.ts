/** Placeholder of the generated file. */
export const MORPH = `
const float OPPOSED = 1e-6;
float user_weight(float rho, float r2, float slope) { return clamp((r2 - rho) * slope, 0.0, 1.0); }
vec4 blended(vec3 from_user, vec3 from_center, float w) {
    float by_user = length(from_user);
    float by_center = length(from_center);
    vec3 user_direction = from_user / max(by_user, 1e-30);
    vec3 mixed = w * user_direction + (1.0 - w) * from_center / max(by_center, 1e-30);
    float size = length(mixed);
    vec3 direction = user_direction;
    if (size > OPPOSED) { direction = mixed / size; }
    return vec4(direction, w * by_user + (1.0 - w) * by_center);
}
struct Place { vec2 at; float rho; };
float leave_cylinder(Place user, vec3 direction, float rho) {
    float a = dot(direction.xz, direction.xz);
    if (rho <= user.rho || a == 0.0) { return -1.0; }
    float b = dot(direction.xz, user.at);
    float c = (user.rho - rho) * (user.rho + rho);
    float q = sqrt(b * b - a * c);
    if (b > 0.0) { return -c / (b + q); }
    return (q - b) / a;
}
vec4 on_cylinder(Place user, vec3 from_user, vec3 from_center, float w, float rho) {
    vec4 to = blended(from_user, from_center, w);
    float leaves = leave_cylinder(user, to.xyz, rho);
    return vec4(to.xyz, leaves >= 0.0 ? leaves : to.w);
}
`;
