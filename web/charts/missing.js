// Replaces charts.js where the page was built without the library that draws charts.
export const missing = true;
