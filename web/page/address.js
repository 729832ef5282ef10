// What the page's address says besides the link: `?lesson=NAME`, `challenge=1` and `embed=1`.
export function readAddress() {
  const asked = new URLSearchParams(location.search);
  return {
    embed: asked.get("embed") === "1",
    challenge: asked.get("challenge") === "1",
    lesson: asked.get("lesson") ?? "",
  };
}

// Puts lesson and challenge into an address, or takes them out; whatever else it asks for stays as it is.
export function withLesson(url, { lesson = "", challenge = false }) {
  const rest = url.search.slice(1).split("&").filter((part) => part && !/^(lesson|challenge)(=|$)/.test(part));
  if (lesson) rest.push(`lesson=${lesson}`);  // its characters need no escape (lesson_source.js)
  if (challenge) rest.push("challenge=1");
  url.search = rest.join("&");
  return url;
}
