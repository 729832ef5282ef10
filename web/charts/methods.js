// In the order of Method in core/include/evenlift/document.h. charts.css has their colours, under the same names.
export const methods = {
  area: { words: "area", sign: "circle", dashes: "none" },
  circle: { words: "circle", sign: "square", dashes: "6 3" },
  distance: { words: "distance", sign: "triangle", dashes: "2 3" },
  distributed: { words: "equal angles", sign: "diamond", dashes: "none" },
  random: { words: "random", sign: "times", dashes: "8 3 2 3" },
  balanced: { words: "balanced", sign: "star", dashes: "none" },
};
