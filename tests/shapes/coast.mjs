// A coast of n vertices: each side of a pentagon is bent in its middle, and so on; then some are left out.
export function coast(n) {
  let seed = 12345;
  const random = () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  let points = [
    [1000, 0],
    [309, 951],
    [-809, 588],
    [-809, -588],
    [309, -951],
  ];
  while (points.length < n) {
    points = points.flatMap(([x, y], i) => {
      const [u, v] = points[(i + 1) % points.length],
        bend = (random() - 0.5) / 3;
      return [
        [x, y],
        [(x + u) / 2 - bend * (v - y), (y + v) / 2 + bend * (u - x)],
      ];
    });
  }
  const excess = points.length - n;
  const out = new Set(Array.from({ length: excess }, (_, i) => Math.floor((i * points.length) / excess) | 1));
  return points
    .filter((_, i) => !out.has(i))
    .map(([x, y]) => `(${x},${y})`)
    .join("\n");
}
