//! Rectangles against each other, by code of the tests' own.

/// Separating axes of two rectangles.
pub(crate) fn overlap(a: &[[f64; 2]; 4], b: &[[f64; 2]; 4]) -> bool {
    [a, b].iter().all(|ring| {
        (0..2).all(|k| {
            let normal = [ring[k][1] - ring[k + 1][1], ring[k + 1][0] - ring[k][0]];
            let range = |ring: &[[f64; 2]; 4]| {
                let along = ring.iter().map(|p| p[0] * normal[0] + p[1] * normal[1]);
                along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)))
            };
            let ((a0, a1), (b0, b1)) = (range(a), range(b));
            a0 <= b1 && b0 <= a1
        })
    })
}
