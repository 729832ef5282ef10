// Path data for the fill rule "evenodd".
export const pathOf = (rings) => rings.map((ring) => `${lineOf(ring)}Z`).join("");

export const lineOf = (points) => `M${points.map((point) => point.join(" ")).join("L")}`;

// Maps polygon coordinates, with y upwards, into a picture of this size, so that these points fill it except for the
// margin. Rounds to tenths, so that the picture stays small as text.
export function fitted(points, width, height, margin) {
  const low = [0, 1].map((axis) => Math.min(...points.map((p) => p[axis])));
  const high = [0, 1].map((axis) => Math.max(...points.map((p) => p[axis])));
  const scale = Math.min(
    (width - 2 * margin) / (high[0] - low[0] || 1),
    (height - 2 * margin) / (high[1] - low[1] || 1),
  );
  const round = (value) => Math.round(value * 10) / 10;
  return ([x, y]) => [
    round(width / 2 + (x - (low[0] + high[0]) / 2) * scale),
    round(height / 2 - (y - (low[1] + high[1]) / 2) * scale),
  ];
}
