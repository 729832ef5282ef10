import { underWay } from "../page/under_way.js";
import { say } from "../words/words.js";

// The page's data files. Each is fetched once, at the first use; after a failure again.
const fetched = new Map();

export function fetchJson(name) {
  if (!fetched.has(name)) {
    const coming = ask(new URL(name, import.meta.url)).then((answer) => answer.json());
    coming.catch(() => fetched.delete(name));
    fetched.set(name, coming);
  }
  return fetched.get(name);
}

// Rejects with an Error whose message gives the reason.
export async function ask(url, options) {
  let answer;
  try {
    answer = await underWay(fetch(url, options));
  } catch {
    throw new Error("the server cannot be reached");
  }
  if (!answer.ok)
    throw new Error(
      answer.status === 404
        ? "the server does not have it"
        : say("the server answered {status}", { status: answer.status }),
    );
  return answer;
}
