// Stands for charts.js where the page was built without what draws charts.
export const missing = true;
