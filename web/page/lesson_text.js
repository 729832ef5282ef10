// A text is a lesson (docs/lessons.md) if its first line that is not a comment is a setting, except `com:`, which
// polygons may have.
import { say } from "../words/words.js";

const setting =
  /^(title|polygon|link|teams|metric|min-ratio|weight|seed|predict|generate|require|move|place|find)[ \t]*:/;
const mostBytes = 65536; // core/include/evenlift/lesson.h

export function isLesson(text) {
  const lines = text
    .slice(0, mostBytes)
    .replace(/^\uFEFF/, "")
    .split("\n")
    .map((line) => line.trim());
  return setting.test(lines.find((line) => line && !line.startsWith("#")) ?? "");
}

// The program receives UTF-8 up to a NUL, so it would not see the rest.
export function unreadable(text) {
  if (text.length > mostBytes) return "A lesson has at most 65,536 bytes";
  const at = text.search(/[\0\uFFFD]/);
  return at < 0 ? "" : say("Line {line}: not readable text (UTF-8)", { line: text.slice(0, at).split("\n").length });
}
