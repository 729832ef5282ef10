// The query of the page's address: `?lesson=NAME`, `challenge=1` and `embed=1`.
export function readAddress() {
  const asked = new URLSearchParams(location.search);
  return {
    embed: asked.get("embed") === "1",
    challenge: asked.get("challenge") === "1",
    lesson: asked.get("lesson") ?? "",
  };
}

// Puts the lesson and the challenge into an address, or removes them. The rest of its query stays.
export function withLesson(url, { lesson = "", challenge = false }) {
  const rest = url.search
    .slice(1)
    .split("&")
    .filter((part) => part && !/^(lesson|challenge)(=|$)/.test(part));
  if (lesson) rest.push(`lesson=${lesson}`); // its characters need no escape (lesson_source.js)
  if (challenge) rest.push("challenge=1");
  url.search = rest.join("&");
  return url;
}
