// Replaces charts.js in a page built without Observable Plot.
export const missing = true;
